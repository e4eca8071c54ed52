#include <candela/environment.h>

#include "scene/environment/equirect.h"
#include "scene/validate/scene_rules.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// The same light on every machine: see portable_math.h.

namespace candela {

namespace {

constexpr double radians = std::numbers::pi / 180.0;
/// A picture of fewer rows has no texel that is small enough for a sun.
constexpr std::uint32_t minRows = 64;
/// What lies closer to the sun's centre is it or its glare; as far again, around it, lies its surroundings.
constexpr double sunRadius = 4.0 * radians;
constexpr double ringRadius = 6.0 * radians;
/// The sun's brightest texel over its surroundings.
constexpr double minContrast = 20.0;
/// Its illuminance over pi times the mean radiance of all directions, which is that of an average surface.
constexpr double minShare = 0.1;

/// A picture in which a sun is looked for.
class SunSearch {
  public:
    explicit SunSearch(Image& picture)
        : equirect_(picture.width, picture.height), texels_(numbersOf(picture)) {
        double sum = 0.0, brightest = -1.0;
        for (std::uint32_t y = 0; y < picture.height; ++y) {
            const Equirect::Row row = equirect_.row(y);
            double rowSum = 0.0;
            for (std::uint32_t x = 0; x < picture.width; ++x) {
                const double luminance = luminanceOf(color(x, y));
                rowSum += luminance;
                if (luminance <= brightest) continue;
                brightest = luminance;
                centre_ = equirect_.direction(x, row);
            }
            sum += rowSum * row.solidAngle;
        }
        mean_ = sum / (4.0 * std::numbers::pi);
        peak_ = brightest;
    }

    /// The illuminance of the sun from each axis, for each channel; none where there is none.
    struct Sun {
        glm::dmat3 flux{0.0};  ///< A column of illuminance × direction for each channel.
        glm::dvec3 towards() const { return 0.2126 * flux[0] + 0.7152 * flux[1] + 0.0722 * flux[2]; }
    };
    std::optional<Sun> find() {
        // A sun that the file clips is a plateau, of which the first texel is at its rim.
        for (int i = 0; i < 3; ++i) {
            surroundings_ = meanBetween(sunRadius, ringRadius);
            const glm::dvec3 towards = excess().towards();
            if (!(glm::length(towards) > 0.0)) return std::nullopt;
            centre_ = glm::normalize(towards);
        }
        surroundings_ = meanBetween(sunRadius, ringRadius);
        const Sun sun = excess();
        const double illuminance = glm::length(sun.towards());
        const bool isSun = peak_ >= minContrast * luminanceOf(surroundings_) &&
                           illuminance >= minShare * std::numbers::pi * mean_;
        return isSun ? std::optional(sun) : std::nullopt;
    }

    /// Gives the sun's place the radiance of its surroundings.
    void remove() {
        forEachWithin(sunRadius, [&](float* texel, double, const glm::dvec3&, double) {
            for (int i = 0; i < 3; ++i) texel[i] = std::min(texel[i], static_cast<float>(surroundings_[i]));
        });
    }

  private:
    glm::dvec3 color(std::uint32_t x, std::uint32_t y) const {
        const float* texel = &texels_[(std::size_t{y} * equirect_.width() + x) * 4];
        return {texel[0], texel[1], texel[2]};
    }

    /// Calls visit(texel, solid angle, direction, cosine of the angle to the centre).
    template <typename Visit>
    void forEachWithin(double radius, Visit&& visit) {
        const double least = portableCos(radius);
        const double polar = portableAcos(centre_.y), step = std::numbers::pi / equirect_.height();
        const auto rowAt = [&](double angle) {
            return static_cast<std::uint32_t>(std::clamp(angle / step, 0.0, equirect_.height() - 1.0));
        };
        const std::uint32_t last = rowAt(polar + radius);
        for (std::uint32_t y = rowAt(polar - radius); y <= last; ++y) {
            const Equirect::Row row = equirect_.row(y);
            float* texel = &texels_[std::size_t{y} * equirect_.width() * 4];
            for (std::uint32_t x = 0; x < equirect_.width(); ++x, texel += 4) {
                const glm::dvec3 direction = equirect_.direction(x, row);
                const double cosine = glm::dot(direction, centre_);
                if (cosine >= least) visit(texel, row.solidAngle, direction, cosine);
            }
        }
    }

    glm::dvec3 meanBetween(double inner, double outer) {
        glm::dvec3 sum(0.0);
        double area = 0.0;
        const double cosineOfInner = portableCos(inner);
        forEachWithin(outer, [&](const float* texel, double solidAngle, const glm::dvec3&, double cosine) {
            if (cosine >= cosineOfInner) return;
            sum += solidAngle * glm::dvec3(texel[0], texel[1], texel[2]);
            area += solidAngle;
        });
        return sum / area;
    }

    /// What is brighter within the sun's radius than its surroundings.
    Sun excess() {
        Sun sun;
        forEachWithin(sunRadius,
                      [&](const float* texel, double solidAngle, const glm::dvec3& direction, double) {
                          for (int i = 0; i < 3; ++i) {
                              // As `remove` leaves it.
                              const double over = texel[i] - double{static_cast<float>(surroundings_[i])};
                              sun.flux[i] += std::max(over, 0.0) * solidAngle * direction;
                          }
                      });
        return sun;
    }

    Equirect equirect_;
    std::span<float> texels_;
    glm::dvec3 centre_{0.0}, surroundings_{0.0};
    double mean_ = 0.0, peak_ = 0.0;
};

}  // namespace

std::optional<Light> takeSun(Environment& environment) {
    validateEnvironment(environment);
    if (environment.picture.height < minRows || environment.picture.width < 2 * minRows) return std::nullopt;
    SunSearch search(environment.picture);
    const std::optional<SunSearch::Sun> found = search.find();
    if (!found) return std::nullopt;
    const glm::dvec3 towards = glm::normalize(found->towards());
    const glm::dvec3 illuminance =
        glm::max(towards * found->flux, glm::dvec3(0.0)) * double{environment.intensity};
    const double strongest = std::max({illuminance.r, illuminance.g, illuminance.b});
    if (!(strongest > 0.0) || strongest > maxIntensity) return std::nullopt;
    search.remove();
    Light sun;
    sun.name = "sun";
    sun.type = LightType::directional;
    sun.color = glm::vec3(illuminance / strongest);
    sun.intensity = static_cast<float>(strongest);
    sun.direction = glm::normalize(environment.rotation * glm::vec3(-towards));
    return sun;
}

glm::quat rotationAboutUp(double degrees) {
    ErrorContext("environment").requireFinite("the angle of its rotation", degrees);
    const double half = std::remainder(degrees, 360.0) / 2.0 * radians;
    return {static_cast<float>(portableCos(half)), 0.0f, static_cast<float>(portableSin(half)), 0.0f};
}

}  // namespace candela
