#include "support/evaluated_image.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace candela::test {

namespace {

constexpr double unit = 1.0 / 16777216.0;  // 2^-24, the unit roundoff of single precision
constexpr double positionUnits = 2.0;
constexpr double normalError = 2.0 * unit;
constexpr double relativeError = 1.0e-5;
constexpr double windowError = 4.0 * unit;
constexpr double cosineError = 4.0 * unit;
constexpr double lobeError = 4.0e-5;

struct ShadingContext {
    BrdfModel model;
    SurfacePoint surface;
    glm::dvec3 eye;
    double reach;  ///< The magnitude of the coordinates from which the position is computed.
};

glm::dvec3 light(const ShadingContext& lit, const SurfacePoint& surface, const WorldLight& light) {
    return reflectedRadiance(lit.model, surface, lit.eye, light);
}

/// The largest change by the displacements of `evaluatedImage`, summed over their kinds.
glm::dvec3 spread(const ShadingContext& lit, const WorldLight& one, const glm::dvec3& exact) {
    glm::dvec3 sum(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = 1.0;
        glm::dvec3 byPosition(0.0), byNormal(0.0);
        for (const double sign : {-1.0, 1.0}) {
            SurfacePoint moved = lit.surface;
            moved.position += step * (sign * positionUnits * unit * lit.reach);
            byPosition = glm::max(byPosition, glm::abs(light(lit, moved, one) - exact));
            SurfacePoint rotated = lit.surface;
            rotated.normal = glm::normalize(rotated.normal + step * (sign * normalError));
            if (rotated.extended) {
                glm::dvec3& coatNormal = rotated.extended->clearcoatNormal;
                coatNormal = glm::normalize(coatNormal + step * (sign * normalError));
            }
            byNormal = glm::max(byNormal, glm::abs(light(lit, rotated, one) - exact));
        }
        sum += byPosition + byNormal;
    }
    return sum;
}

glm::dvec3 unwindowed(const ShadingContext& lit, WorldLight one) {
    one.range = std::max(one.range * 1.0e3f, 1.0e3f);
    return light(lit, lit.surface, one);
}

/// The change of a spot's factor, times the light without it.
glm::dvec3 spotSpread(const ShadingContext& lit, const WorldLight& one) {
    WorldLight point = one;
    point.type = LightType::point;
    const glm::dvec3 toPoint = lit.surface.position - glm::dvec3(one.position);
    const double cosine = glm::dot(glm::dvec3(one.direction), glm::normalize(toPoint));
    const auto factor = [&](double c) { return spotFactor(c, one.innerConeAngle, one.outerConeAngle); };
    const double change = std::max(std::abs(factor(cosine + cosineError) - factor(cosine)),
                                   std::abs(factor(cosine - cosineError) - factor(cosine)));
    return light(lit, lit.surface, point) * change;
}

void add(ExpectedPixel& pixel, const ShadingContext& lit, const WorldLight& one) {
    const bool local = one.type != LightType::directional;
    const double distance = glm::distance(lit.surface.position, glm::dvec3(one.position));
    if (local && distance > 1.001 * one.range) return;
    const glm::dvec3 exact = light(lit, lit.surface, one);
    pixel.radiance += exact;
    pixel.tolerance += (lit.surface.extended ? lobeError : relativeError) * exact + spread(lit, one, exact);
    if (local) pixel.tolerance += windowError * unwindowed(lit, one);
    if (one.type == LightType::spot) pixel.tolerance += spotSpread(lit, one);
}

}  // namespace

std::vector<ExpectedPixel> evaluatedImage(BrdfModel model, const AovReader& aovs, int width, int height,
                                          const CameraView& view, std::span<const WorldLight> lights,
                                          const LobePixels* lobes) {
    std::vector<ExpectedPixel> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            ExpectedPixel& pixel = pixels.emplace_back();
            pixel.radiance = aovs.vector("emission", x, y);
            pixel.tolerance = relativeError * pixel.radiance;
            const glm::vec3 normal = aovs.vector("N", x, y);
            if (normal == glm::vec3(0.0f)) continue;
            ShadingContext lit{model, {}, view.eye(), 0.0};
            lit.surface.position = aovs.vector("P", x, y);
            lit.surface.normal = glm::normalize(glm::dvec3(normal));
            lit.surface.lobes.baseColor = aovs.vector("base_color", x, y);
            lit.surface.lobes.metallic = aovs.scalar("metallic", x, y);
            lit.surface.lobes.roughness = aovs.scalar("roughness", x, y);
            if (lobes != nullptr) lit.surface.extended = lobes->at(x, y, normal);
            const glm::dvec3 reach = glm::abs(lit.eye) + glm::abs(lit.surface.position - lit.eye);
            lit.reach = std::max({reach.x, reach.y, reach.z});
            // The direction to the eye of an orthographic view is the same everywhere.
            if (view.orthographicHeight) lit.eye = lit.surface.position + glm::dvec3(view.worldFromCamera[2]);
            for (const WorldLight& one : lights) add(pixel, lit, one);
        }
    }
    return pixels;
}

std::vector<WorldLight> withRanges(std::span<const WorldLight> lights, const LightReport& report) {
    std::vector<WorldLight> ranged(lights.begin(), lights.end());
    for (WorldLight& light : ranged) {
        if (light.type == LightType::directional || light.range > 0.0f) continue;
        const float brightest = std::max({light.intensity.r, light.intensity.g, light.intensity.b});
        light.range = static_cast<float>(std::sqrt(brightest / report.rangeIrradiance));
    }
    return ranged;
}

}  // namespace candela::test
