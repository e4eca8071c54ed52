#include "render/gpu_scene/gpu_lights.h"

#include <candela/brdf.h>
#include <candela/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace candela {

namespace {

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What is wrong with a light; null when nothing is.
const char* fault(const WorldLight& light) {
    constexpr float brightest = 1.0e20f;
    if (!isFinite(light.position)) return "its position has to be finite";
    if (!isFinite(light.intensity) || glm::any(glm::lessThan(light.intensity, glm::vec3(0.0f))) ||
        glm::any(glm::greaterThan(light.intensity, glm::vec3(brightest)))) {
        return "its intensity has to be from 0 to 1e20";
    }
    if (!(light.range >= 0.0f) || !std::isfinite(light.range))
        return "its range has to be 0 (none) or more metres";
    if (light.type == LightType::point) return nullptr;
    if (!isFinite(light.direction) || std::abs(glm::dot(light.direction, light.direction) - 1.0f) > 1e-3f) {
        return "its direction has to be of unit length";
    }
    if (light.type == LightType::directional) return nullptr;
    const bool cone = light.innerConeAngle >= 0.0f && light.innerConeAngle < light.outerConeAngle &&
                      light.outerConeAngle <= 1.5708f;
    return cone ? nullptr : "its cone angles have to be 0 <= inner < outer <= pi / 2";
}

/// Direction times the ramp's scale, and the ramp's offset, as KHR_lights_punctual recommends.
glm::vec4 coneRecord(const WorldLight& light) {
    const float outer = std::cos(light.outerConeAngle);
    const float scale = 1.0f / std::max(0.001f, std::cos(light.innerConeAngle) - outer);
    return {light.direction * scale, -outer * scale};
}

}  // namespace

void LightReaches::resize(std::size_t size) {
    for (auto* column : {&x, &y, &z, &range}) column->resize(size + padding, 0.0f);
}

GpuLights::GpuLights(const GpuSceneOptions& options)
    : options_(options), records_(GL_RGBA32F, "lights"), cones_(GL_RGBA32F, "spot cones") {
    if (!(options.irradianceThreshold > 0.0f) || !std::isfinite(options.irradianceThreshold)) {
        throw Error(ErrorKind::badInput, "", "the irradiance threshold has to be over 0 lux");
    }
}

float GpuLights::rangeOf(const WorldLight& light, const glm::vec3& intensity) {
    if (light.range > 0.0f) return light.range;
    const float brightest = std::max({intensity.r, intensity.g, intensity.b, 0.0f});
    // At its range a light would still give the threshold: that is the most the window takes, but no more
    // than the light gives at all.
    constexpr float distance = static_cast<float>(minDistance);
    ++report_.rangesAssigned;
    report_.irradianceCut += std::min(brightest / (distance * distance), options_.irradianceThreshold);
    // A light without intensity keeps a range, so that no record divides by zero.
    return std::max(std::sqrt(brightest / options_.irradianceThreshold), 1.0e-3f);
}

void GpuLights::writeLocal(std::size_t index, const WorldLight& light) {
    const glm::vec3 intensity(options_.workingFromRec709 * glm::dvec3(light.intensity));
    const float range = rangeOf(light, intensity);
    // The shader's inverse square of the range must stay a normal number.
    const float held = glm::clamp(range, 1.0e-15f, 1.0e15f);
    reaches_.x[index] = light.position.x;
    reaches_.y[index] = light.position.y;
    reaches_.z[index] = light.position.z;
    reaches_.range[index] = held;
    recordData_[2 * index] = glm::vec4(light.position, 1.0f / (held * held));
    recordData_[2 * index + 1] = glm::vec4(intensity, 0.0f);
}

void GpuLights::set(std::span<const WorldLight> lights) {
    LightCounts counts;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (const char* text = fault(lights[i]))
            throw Error(ErrorKind::badInput, "", "light " + std::to_string(i) + ": " + text);
        counts.points += lights[i].type == LightType::point;
        counts.spots += lights[i].type == LightType::spot;
        counts.directionals += lights[i].type == LightType::directional;
    }
    counts_ = counts;
    report_ = {.lights = lights.size()};
    recordData_.resize(2 * lights.size());
    reaches_.resize(static_cast<std::size_t>(counts.points + counts.spots));
    coneData_.resize(static_cast<std::size_t>(counts.spots));
    std::size_t point = 0, spot = static_cast<std::size_t>(counts.points), directional = reaches_.size();
    for (const WorldLight& light : lights) {
        if (light.type == LightType::point) {
            writeLocal(point++, light);
        } else if (light.type == LightType::spot) {
            coneData_[spot - static_cast<std::size_t>(counts.points)] = coneRecord(light);
            writeLocal(spot++, light);
        } else {
            recordData_[2 * directional] = glm::vec4(-light.direction, 0.0f);
            recordData_[2 * directional + 1] =
                glm::vec4(glm::vec3(options_.workingFromRec709 * glm::dvec3(light.intensity)), 0.0f);
            ++directional;
        }
    }
    records_.upload(std::span<const glm::vec4>(recordData_));
    cones_.upload(std::span<const glm::vec4>(coneData_));
}

}  // namespace candela
