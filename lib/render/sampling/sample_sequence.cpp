#include "render/sampling/sample_sequence.h"

#include <array>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr std::uint32_t half = 0x80000000u;
constexpr double pi = std::numbers::pi;

constexpr std::uint32_t reverseBits(std::uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
    return x >> 16 | x << 16;
}

/// A well-mixed word. Source: Wellons, "Prospecting for hash functions", 2018 (lowbias32).
constexpr std::uint32_t hashed(std::uint32_t x) {
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

/// Owen scrambling: whether a bit flips depends on the seed and the bits above it. In reversed order that is
/// a hash in which a bit affects higher ones alone. Source of the constants: Vegdahl, "Building a better LK
/// hash", 2021, after Laine and Karras, "Stratified sampling for stochastic transparency", 2011.
constexpr std::uint32_t owenScrambled(std::uint32_t x, std::uint32_t seed) {
    x = reverseBits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverseBits(x);
}

constexpr std::uint32_t sobolDimensions = 5;

/// The direction numbers of the first dimensions of Sobol's sequence. Source: Joe and Kuo, "Constructing
/// Sobol sequences with better two-dimensional projections", 2008 (new-joe-kuo-6).
constexpr auto sobolDirections = [] {
    struct Polynomial {
        std::uint32_t degree, coefficients;
        std::array<std::uint32_t, 3> first;
    };
    constexpr std::array<Polynomial, sobolDimensions - 1> polynomials{
        {{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}}};
    std::array<std::array<std::uint32_t, 32>, sobolDimensions> v{};
    for (std::uint32_t i = 0; i < 32; ++i) v[0][i] = half >> i;
    for (std::uint32_t d = 1; d < sobolDimensions; ++d) {
        const auto& [degree, coefficients, first] = polynomials[d - 1];
        for (std::uint32_t i = 0; i < degree; ++i) v[d][i] = first[i] << (31 - i);
        for (std::uint32_t i = degree; i < 32; ++i) {
            v[d][i] = v[d][i - degree] ^ v[d][i - degree] >> degree;
            for (std::uint32_t k = 1; k < degree; ++k)
                if ((coefficients >> (degree - 1 - k) & 1u) != 0) v[d][i] ^= v[d][i - k];
        }
    }
    return v;
}();

constexpr std::uint32_t sobol(std::uint32_t index, std::uint32_t dimension) {
    std::uint32_t x = 0;
    for (std::uint32_t i = 0; index != 0; ++i, index >>= 1)
        if ((index & 1u) != 0) x ^= sobolDirections[dimension][i];
    return x;
}

/// Where a coordinate of a sample comes from.
struct Source {
    std::uint32_t sobolDimension;
    bool hasStreams;
};

/// The coordinates of the view and those of each light are stratified together. Lights have their samples in
/// an order of their own, which decorrelates them from the view and from each other.
constexpr Source sourceOf(SampleDimension dimension) {
    using enum SampleDimension;
    if (dimension >= lightX)
        return {static_cast<std::uint32_t>(dimension) - static_cast<std::uint32_t>(lightX), true};
    return {static_cast<std::uint32_t>(dimension), false};
}

/// The one, of 4,000, with the smallest error of straight edges before and behind the plane in focus at 4 to
/// 256 samples: some 8 % below the median.
constexpr std::uint32_t viewSeed = 0x9cfee34bu;
constexpr std::uint32_t lightSeed = 0x9e3779b9u;

std::uint32_t scrambled(std::uint32_t sample, const Source& source, std::uint32_t stream) {
    const std::uint32_t seed = source.hasStreams ? hashed(lightSeed + stream) : viewSeed;
    // Twice: a single pass of the hash leaves some correlation with the original order.
    const std::uint32_t index =
        source.hasStreams ? owenScrambled(owenScrambled(sample, seed), hashed(seed)) : sample;
    return owenScrambled(sobol(index, source.sobolDimension), hashed(seed + source.sobolDimension + 1u));
}

/// The inverse of an increasing function on [0, high].
template <typename Function>
double solve(const Function& function, double value, double high) {
    double low = 0.0;
    // Each step halves the interval; after these it is narrower than the last bit of a float.
    constexpr int steps = 48;
    for (int i = 0; i < steps; ++i) {
        const double middle = 0.5 * (low + high);
        (function(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The share of the kernel that lies within `s` of its centre on one side; its width is 1.
double blackmanHarrisShare(double s) {
    constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;
    const double turn = 2.0 * pi * s;
    return s + (a1 * std::sin(turn) + a2 / 2.0 * std::sin(2.0 * turn) + a3 / 3.0 * std::sin(3.0 * turn)) /
                   (2.0 * pi * a0);
}

double filterOffset(double coordinate) {
    constexpr double width = 1.5;  // Pixels.
    const double fromMiddle = coordinate - 0.5;
    if (fromMiddle == 0.0) return 0.0;
    return std::copysign(width * solve(blackmanHarrisShare, std::abs(fromMiddle), 0.5), fromMiddle);
}

struct Polar {
    double radius, angle;
};

/// From the square to the unit disc, keeping areas and neighbours. Source: Shirley and Chiu, "A low
/// distortion map between disk and square", 1997.
Polar concentric(double u, double v) {
    const double a = 2.0 * u - 1.0, b = 2.0 * v - 1.0;
    if (a == 0.0 && b == 0.0) return {0.0, 0.0};
    if (std::abs(a) > std::abs(b)) {
        const double angle = pi / 4.0 * b / a;
        return {std::abs(a), a > 0.0 ? angle : angle + pi};
    }
    const double angle = pi / 2.0 - pi / 4.0 * a / b;
    return {std::abs(b), b > 0.0 ? angle : angle + pi};
}

glm::dvec2 corner(double number, std::uint32_t blades) {
    const double angle = pi / 2.0 + 2.0 * pi * number / blades;
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

double sampleCoordinate(std::uint32_t sample, SampleDimension dimension, std::uint32_t stream) {
    const Source source = sourceOf(dimension);
    // A flip of bits that is the same for all samples moves sample 0 to the middle and keeps every stratum
    // one sample.
    const std::uint32_t flips = scrambled(0, source, stream) ^ half;
    return 0x1p-32 * (scrambled(sample, source, stream) ^ flips);
}

glm::dvec2 pixelOffset(std::uint32_t sample) {
    return {filterOffset(sampleCoordinate(sample, SampleDimension::pixelX)),
            filterOffset(sampleCoordinate(sample, SampleDimension::pixelY))};
}

glm::dvec2 aperturePoint(std::uint32_t sample, std::uint32_t blades) {
    const Polar polar = concentric(sampleCoordinate(sample, SampleDimension::lensX),
                                   sampleCoordinate(sample, SampleDimension::lensY));
    if (blades == 0) return polar.radius * glm::dvec2(std::cos(polar.angle), std::sin(polar.angle));
    // The angle selects a triangle of the polygon and a point of its outer side.
    const double around = polar.angle / (2.0 * pi) * blades;
    const double first = std::floor(around), along = around - first;
    return polar.radius * ((1.0 - along) * corner(first, blades) + along * corner(first + 1.0, blades));
}

glm::dvec3 lightPoint(std::uint32_t sample, std::uint32_t light) {
    const double u = 2.0 * sampleCoordinate(sample, SampleDimension::lightX, light) - 1.0;
    if (u == 0.0) return glm::dvec3(0.0);
    // A share (t - sin t) / pi of the density lies within the radius sin(t / 2). The sign of u tells two
    // opposite points apart, so that directions of one hemisphere suffice.
    const double t = solve([](double angle) { return (angle - std::sin(angle)) / pi; }, std::abs(u), pi);
    const double radius = std::copysign(std::sin(0.5 * t), u);
    const double z = sampleCoordinate(sample, SampleDimension::lightY, light);
    const double around = 2.0 * pi * sampleCoordinate(sample, SampleDimension::lightZ, light);
    const double side = std::sqrt(1.0 - z * z);
    return radius * glm::dvec3(side * std::cos(around), side * std::sin(around), z);
}

}  // namespace candela
