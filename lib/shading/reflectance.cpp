#include <candela/brdf.h>

#include "shading/argument_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candela {

using namespace arguments;

namespace {

double squared(double a) {
    return a * a;
}

double schlick(double f0, double cosine) {
    return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0);
}

/// Fresnel's equations at normal incidence.
double normalReflectance(double outerIor, double innerIor) {
    return squared((innerIor - outerIor) / (innerIor + outerIor));
}

/// Fresnel's equations for unpolarised light from air; the cosines are those outside and inside.
double fresnel(double outside, double inside, double ior) {
    const double rs = (outside - ior * inside) / std::max(outside + ior * inside, 1.0e-6);
    const double rp = (inside - ior * outside) / std::max(inside + ior * outside, 1.0e-6);
    return 0.5 * (squared(rs) + squared(rp));
}

/// A lobe of a CIE colour matching function in Fourier space.
struct Sensitivity {
    double value, position, variance;

    double at(double phase) const {
        return value * std::sqrt(2.0 * std::numbers::pi * variance) * std::cos(position * phase) *
               std::exp(-variance * phase * phase);
    }
};

/// How a wave of light from everywhere in the spectrum looks that interferes with itself after a difference
/// of paths of so many metres: linear Rec.709. Source: the supplement of Belcour and Barla 2017.
glm::dvec3 interference(double pathDifference) {
    constexpr Sensitivity red{5.4856e-13, 1.6810e6, 4.3278e9}, redSecond{9.7470e-14, 2.2399e6, 4.5282e9},
        green{4.4201e-13, 1.7953e6, 9.3046e9}, blue{5.2481e-13, 2.2084e6, 6.6121e9};
    constexpr double whiteLuminance = 1.0685e-7;
    const double phase = 2.0 * std::numbers::pi * pathDifference;
    const double x = (red.at(phase) + redSecond.at(phase)) / whiteLuminance;
    const double y = green.at(phase) / whiteLuminance, z = blue.at(phase) / whiteLuminance;
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

/// The reflectance of a film between air and a base for light at `cosine`: the squared sum of all waves, as a
/// series in the number of their ways through the film, of which two orders interfere visibly.
glm::dvec3 filmReflectance(double cosine, const glm::dvec3& baseF0, double filmIor, double nanometres) {
    const double filmCosine = std::sqrt(std::max(1.0 - (1.0 - squared(cosine)) / squared(filmIor), 0.0));
    const double r12 = fresnel(cosine, filmCosine, filmIor), t121 = 1.0 - r12;
    const double pathDifference = 2.0 * filmIor * nanometres * 1.0e-9 * filmCosine;
    const std::array<glm::dvec3, 2> waves{interference(pathDifference), interference(2.0 * pathDifference)};
    glm::dvec3 result;
    for (int c = 0; c < 3; ++c) {
        const double root = std::sqrt(std::clamp(baseF0[c], 0.0, 0.9999));
        const double baseIor = (1.0 + root) / (1.0 - root);
        const double r23 = schlick(normalReflectance(filmIor, baseIor), filmCosine);
        const double r123 = std::min(r12 * r23, 0.9999);
        const double rs = squared(t121) * r23 / (1.0 - r123);
        // Reflection off the film's inner side, then off the base.
        const double phase = std::numbers::pi + (baseIor < filmIor ? std::numbers::pi : 0.0);
        double sum = r12 + rs;
        for (int m = 1; m <= 2; ++m) {
            sum += 2.0 * (rs - t121) * std::pow(std::sqrt(r123), m) * std::cos(m * phase) *
                   waves[static_cast<std::size_t>(m - 1)][c];
        }
        result[c] = std::max(sum, 0.0);
    }
    return result;
}

}  // namespace

glm::dvec3 dielectricF0(double ior, double specular, const glm::dvec3& specularColor) {
    require(ior >= 1.0, "the index of refraction", "1 or more");
    requireUnitRange(specular, "the specular factor");
    require(isNonNegative(specularColor), "the specular colour", "finite and 0 or more");
    const double reflectance = std::isinf(ior) ? 1.0 : normalReflectance(1.0, ior);
    glm::dvec3 result;
    for (int c = 0; c < 3; ++c) result[c] = std::min(reflectance * specularColor[c], 1.0) * specular;
    return result;
}

glm::dvec3 iridescentF0(double nDotV, const glm::dvec3& f0, double filmIor, double thicknessNanometres) {
    requireCosine(nDotV, "n·v");
    requireUnitRange(f0, "F0");
    require(std::isfinite(filmIor) && filmIor >= 1.0, "the film's index of refraction", "1 or more");
    require(std::isfinite(thicknessNanometres) && thicknessNanometres >= 0.0, "the film's thickness",
            "0 nanometres or more");
    const double cosine = std::clamp(nDotV, 0.0, 1.0);
    // A film much thinner than light's wavelength is none.
    const double presence = std::clamp(thicknessNanometres / 0.03, 0.0, 1.0);
    const double ior = 1.0 + (filmIor - 1.0) * presence * presence * (3.0 - 2.0 * presence);
    const glm::dvec3 reflectance = filmReflectance(cosine, f0, ior, thicknessNanometres);
    const double weight = std::min(std::pow(1.0 - cosine, 5.0), 0.9999);
    glm::dvec3 result;
    for (int c = 0; c < 3; ++c) result[c] = std::clamp((reflectance[c] - weight) / (1.0 - weight), 0.0, 1.0);
    return result;
}

}  // namespace candela
