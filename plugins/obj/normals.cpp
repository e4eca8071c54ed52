#include "normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document.h"
#include "indexing.h"

namespace candela_plugins::obj {
namespace {

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

Vector newellNormal(const Document& document, std::size_t face) {
    const Corner* const corners = &document.corners[document.faces[face].firstCorner];
    const std::uint32_t count = document.cornerCount(face);
    // Relative to the first corner, for the precision of small faces far from the origin.
    const Vector origin(document.positions[corners[0].vertex]);
    Vector sum;
    Vector before;
    for (std::uint32_t i = 1; i < count; ++i) {
        const Vector here = Vector(document.positions[corners[i].vertex]) - origin;
        sum = sum + cross(before, here);
        before = here;
    }
    return normalized(sum);
}

/// The inner angle of a polygon at `here`, 0 to 2 pi.
double angleAt(const Vector& before, const Vector& here, const Vector& after, const Vector& normal) {
    const Vector in = before - here, out = after - here;
    const double angle = std::atan2(dot(cross(out, in), normal), dot(out, in));
    return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

class Smoothing {
  public:
    explicit Smoothing(Document& document) : document_(document) {}

    void addFace(std::size_t face, std::uint32_t group) {
        const Vector normal = newellNormal(document_, face);
        const std::uint32_t count = document_.cornerCount(face);
        Corner* const corners = &document_.corners[document_.faces[face].firstCorner];
        const auto position = [&](std::uint32_t i) { return Vector(document_.positions[corners[i].vertex]); };
        for (std::uint32_t i = 0; i < count; ++i) {
            const double angle =
                angleAt(position((i + count - 1) % count), position(i), position((i + 1) % count), normal);
            const std::uint32_t number = keys_.indexOf({corners[i].vertex, group, 0});
            if (number == sums_.size()) sums_.emplace_back();
            sums_[number] = sums_[number] + angle * normal;
            corners[i].normal = first_ + number;
        }
    }

    void finish() {
        for (const Vector& sum : sums_) document_.normals.push_back(Vec3(normalized(sum)));
    }

  private:
    Document& document_;
    KeyIndex keys_;
    std::vector<Vector> sums_;
    const std::uint32_t first_ = static_cast<std::uint32_t>(document_.normals.size());
};

/// Whether the normals that the file gives a face lie on the side from which its corners run clockwise.
bool isTurnedAway(const Document& document, std::size_t face) {
    const Corner* const corners = &document.corners[document.faces[face].firstCorner];
    if (corners[0].normal == none) return false;
    const std::uint32_t count = document.cornerCount(face);
    Vector sum;
    for (std::uint32_t i = 0; i < count; ++i)
        sum = sum + normalized(Vector(document.normals[corners[i].normal]));
    return dot(sum, newellNormal(document, face)) < 0.0;
}

}  // namespace

void turnFacesToNormals(Document& document) {
    for (std::size_t face = 0; face < document.faces.size(); ++face) {
        if (!isTurnedAway(document, face)) continue;
        Corner* const corners = &document.corners[document.faces[face].firstCorner];
        std::reverse(corners, corners + document.cornerCount(face));
    }
}

Vec3 faceNormal(const Document& document, std::size_t face) {
    return Vec3(newellNormal(document, face));
}

void addSmoothNormals(Document& document) {
    Smoothing smoothing(document);
    for (std::size_t face = 0; face < document.faces.size(); ++face) {
        const std::uint32_t group = document.stateOf(face).smoothing;
        const bool hasNormals = document.corners[document.faces[face].firstCorner].normal != none;
        if (group != 0 && !hasNormals) smoothing.addFace(face, group);
    }
    smoothing.finish();
}

}  // namespace candela_plugins::obj
