#include <candela/environment.h>

#include "base/error_context.h"
#include "scene/environment/equirect.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numbers>

// A. J. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999. The same
// picture on every machine: see portable_math.h.

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint32_t width = 512, height = 256;
/// The least angle between the sun and the horizon: the model holds while the sun is up.
constexpr double minElevation = pi / 60.0;
/// The diffuse reflectance of the ground, which the model does not have.
constexpr double groundAlbedo = 0.2;
/// Illuminance of the sun outside the atmosphere, lux (IES Lighting Handbook, solar illuminance constant).
constexpr double solarIlluminance = 128000.0;

/// The distribution of Perez et al. over the sky, of a luminance or of a chromaticity: formula (3) of the
/// paper.
struct Distribution {
    std::array<double, 5> coefficients;  ///< A to E: appendix A.2.
    double zenith = 0.0;                 ///< Its value straight above.
    double scale = 0.0;                  ///< `zenith` over the formula's value there.

    /// The factor of what lies at an angle to the zenith.
    double gradation(double cosine) const {
        return 1.0 + coefficients[0] * portableExp(coefficients[1] / cosine);
    }
    /// The factor of what lies at an angle to the sun.
    double indicatrix(double angle, double cosine) const {
        return 1.0 + coefficients[2] * portableExp(coefficients[3] * angle) +
               coefficients[4] * cosine * cosine;
    }
    void setZenith(double value, double sunAngle) {
        zenith = value;
        scale = value / (gradation(1.0) * indicatrix(sunAngle, portableCos(sunAngle)));
    }
};

/// c0 + c1 s + c2 s² + c3 s³
double cubic(const std::array<double, 4>& c, double s) {
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

/// Rec.709 of a chromaticity and a luminance; what lies outside of its gamut is clipped.
glm::dvec3 rec709(double luminance, double x, double y) {
    const double sumX = x / y * luminance, sumZ = (1.0 - x - y) / y * luminance;
    return glm::max(glm::dvec3(3.2404542 * sumX - 1.5371385 * luminance - 0.4985314 * sumZ,
                               -0.9692660 * sumX + 1.8760108 * luminance + 0.0415560 * sumZ,
                               0.0556434 * sumX - 0.2040259 * luminance + 1.0572252 * sumZ),
                    glm::dvec3(0.0));
}

/// The radiance of the sky, candela per square metre.
class Daylight {
  public:
    Daylight(double turbidity, double sunElevation) {
        const double t = turbidity, s = pi / 2.0 - sunElevation;
        luminance_.coefficients = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                                   0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
        x_.coefficients = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                           -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
        y_.coefficients = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                           -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
        const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * s);
        const double tangent = portableSin(chi) / portableCos(chi);
        luminance_.setZenith(1000.0 * ((4.0453 * t - 4.9710) * tangent - 0.2155 * t + 2.4192), s);
        x_.setZenith(t * t * cubic({0.0, 0.00209, -0.00375, 0.00166}, s) +
                         t * cubic({0.00394, -0.03202, 0.06377, -0.02903}, s) +
                         cubic({0.25886, 0.06052, -0.21196, 0.11693}, s),
                     s);
        y_.setZenith(t * t * cubic({0.0, 0.00317, -0.00610, 0.00275}, s) +
                         t * cubic({0.00516, -0.04153, 0.08970, -0.04214}, s) +
                         cubic({0.26688, 0.06670, -0.26756, 0.15346}, s),
                     s);
    }

    /// From here on `radiance` is of directions at this angle to the zenith, below pi / 2.
    void setRow(double cosine) {
        gradation_ = {luminance_.scale * luminance_.gradation(cosine), x_.scale * x_.gradation(cosine),
                      y_.scale * y_.gradation(cosine)};
    }
    glm::dvec3 radiance(double cosineToSun) const {
        const double angle = portableAcos(cosineToSun);
        return rec709(gradation_.x * luminance_.indicatrix(angle, cosineToSun),
                      gradation_.y * x_.indicatrix(angle, cosineToSun),
                      gradation_.z * y_.indicatrix(angle, cosineToSun));
    }

  private:
    Distribution luminance_, x_, y_;
    glm::dvec3 gradation_{0.0};  ///< Of luminance, x and y.
};

/// The illuminance of the sun on a surface that faces it, lux: what Rayleigh scattering, aerosols and ozone
/// leave of it (appendix A.1 of the paper) at wavelengths that stand for red, green and blue. The air mass is
/// that of A. T. Young, "Air mass and refraction", Applied Optics 33, 1994.
glm::dvec3 sunIlluminance(double turbidity, double sunElevation) {
    const double c = portableSin(sunElevation);
    const double airMass =
        ((1.002432 * c + 0.148386) * c + 0.0096467) / (((c + 0.149864) * c + 0.0102963) * c + 0.000303978);
    // Of 0.68, 0.55 and 0.44 micrometres: 0.008735 times their power of -4.08, their power of -1.3, and 0.35
    // cm of ozone times its absorption.
    constexpr std::array rayleigh{0.042133, 0.100134, 0.248872}, aerosol{1.65097, 2.17535, 2.90745},
        ozone{0.0126, 0.02975, 0.00098};
    const double beta = 0.04608 * turbidity - 0.04586;
    glm::dvec3 illuminance(0.0);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double depth = rayleigh[at] + beta * aerosol[at] + ozone[at];
        illuminance[i] = solarIlluminance * portableExp(-depth * airMass);
    }
    return illuminance;
}

void setTexel(float* texel, const glm::dvec3& color) {
    for (int i = 0; i < 3; ++i) texel[i] = static_cast<float>(color[i]);
    texel[3] = 1.0f;
}

void checkOptions(const SkyOptions& options) {
    const ErrorContext context("sky");
    context.requireWithin("its turbidity", options.turbidity, 2.0, 8.0);
    context.require(options.sunElevation >= minElevation && options.sunElevation <= pi / 2.0,
                    "its sun's elevation must be pi / 60 to pi / 2");
    context.requireWithin("its sun's azimuth", options.sunAzimuth, -pi, pi);
}

/// Fills the rows above the horizon. Returns the illuminance of a horizontal surface.
glm::dvec3 drawSky(Environment& sky, const SkyOptions& options, const glm::dvec3& towardsSun) {
    Daylight daylight(options.turbidity, options.sunElevation);
    const Equirect equirect(width, height);
    float* texel = numbersOf(sky.picture).data();
    glm::dvec3 illuminance(0.0);
    for (std::uint32_t y = 0; y < height / 2; ++y) {
        const Equirect::Row row = equirect.row(y);
        daylight.setRow(row.cosine);
        glm::dvec3 sum(0.0);
        for (std::uint32_t x = 0; x < width; ++x, texel += 4) {
            const glm::dvec3 radiance = daylight.radiance(glm::dot(equirect.direction(x, row), towardsSun));
            setTexel(texel, radiance);
            sum += radiance;
        }
        illuminance += sum * (row.solidAngle * row.cosine);
    }
    return illuminance;
}

}  // namespace

Sky skyEnvironment(const SkyOptions& options) {
    checkOptions(options);
    const double level = portableCos(options.sunElevation);
    const glm::dvec3 towardsSun{level * portableSin(options.sunAzimuth), portableSin(options.sunElevation),
                                -level * portableCos(options.sunAzimuth)};
    Sky sky;
    sky.environment.picture = blackPicture("sky", width, height);
    const glm::dvec3 fromSky = drawSky(sky.environment, options, towardsSun);
    const glm::dvec3 fromSun = sunIlluminance(options.turbidity, options.sunElevation);
    const glm::dvec3 onGround = fromSky + fromSun * towardsSun.y;

    float* ground = numbersOf(sky.environment.picture).data() + std::size_t{4} * width * (height / 2);
    for (std::uint32_t i = 0; i < width * height / 2; ++i)
        setTexel(ground + std::size_t{4} * i, onGround * (groundAlbedo / pi));

    const double scale = pi / luminanceOf(onGround);
    for (float& number : numbersOf(sky.environment.picture)) number *= static_cast<float>(scale);
    const double strongest = std::max({fromSun.r, fromSun.g, fromSun.b});
    sky.sun.name = "sun";
    sky.sun.type = LightType::directional;
    sky.sun.color = glm::vec3(fromSun / strongest);
    sky.sun.intensity = static_cast<float>(scale * strongest);
    sky.sun.direction = glm::vec3(-towardsSun);
    return sky;
}

}  // namespace candela
