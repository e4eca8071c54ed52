#pragma once

#include <cmath>

#include "document.h"

namespace candela_obj {

/// Double precision: sums over many corners, and positions far from the origin.
struct Vector {
    double x = 0.0, y = 0.0, z = 0.0;

    Vector() = default;
    Vector(double a, double b, double c) : x(a), y(b), z(c) {}
    explicit Vector(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
    explicit operator Vec3() const {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    }
};

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, const Vector& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// (0, 0, 0) stays as it is.
inline Vector normalized(const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0.0 ? (1.0 / length) * a : a;
}

}  // namespace candela_obj
