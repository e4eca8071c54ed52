#pragma once

#include <cmath>
#include <numbers>

namespace candela {

// Elementary functions of double precision that are made of operations which IEEE 754 rounds exactly, so that
// results are the same on every machine. What includes this is compiled without contraction to fused
// multiply-add. Errors are below 1e-15.

/// The sine of `x` within -pi to pi, by its Taylor series on -pi/2 to pi/2.
inline double portableSin(double x) {
    constexpr double pi = std::numbers::pi;
    if (x > pi / 2.0) x = pi - x;
    if (x < -pi / 2.0) x = -pi - x;
    const double square = x * x;
    double sum = 0.0;
    for (int i = 21; i >= 3; i -= 2) sum = (1.0 - sum) * square / ((i - 1.0) * i);
    return x * (1.0 - sum);
}

/// The cosine of `x` within -pi to pi.
inline double portableCos(double x) {
    return portableSin(std::numbers::pi / 2.0 - std::abs(x));
}

/// e to the power of `x` within -700 to 700.
inline double portableExp(double x) {
    const double whole = std::floor(x * std::numbers::log2e + 0.5);
    const double rest = x - whole * std::numbers::ln2;
    double sum = 1.0;
    for (int i = 14; i >= 1; --i) sum = 1.0 + sum * rest / i;
    return std::ldexp(sum, static_cast<int>(whole));
}

/// The angle, 0 to pi, whose cosine is `x`, which is taken to lie within -1 to 1.
inline double portableAcos(double x) {
    if (x <= -1.0) return std::numbers::pi;
    if (x >= 1.0) return 0.0;
    // The tangent of a 32nd of the angle.
    double tangent = std::sqrt((1.0 - x) / (1.0 + x));
    for (int halving = 0; halving < 4; ++halving) tangent /= 1.0 + std::sqrt(1.0 + tangent * tangent);
    const double square = tangent * tangent;
    double sum = 0.0;
    for (int i = 17; i >= 1; i -= 2) sum = 1.0 / i - square * sum;
    return 32.0 * tangent * sum;
}

}  // namespace candela
