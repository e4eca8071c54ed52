#include "render/gpu_scene/gpu_lights.h"

#include "render/layout.h"
#include "render/sampling/sample_sequence.h"
#include "scene/model/light_range.h"

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
    if (!(light.radius >= 0.0f) || !std::isfinite(light.radius))
        return "its radius has to be 0 (a point) or more metres";
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

// The shader's inverse square of a range must stay a normal number.
constexpr float minRange = 1.0e-15f, maxRange = 1.0e15f;
// Of a light that lights nothing.
constexpr float unlitRange = 1.0e-3f;

}  // namespace

void LightReaches::reserve(std::size_t size) {
    for (auto* column : {&x, &y, &z, &range}) column->reserve(size + padding);
}

void LightReaches::resize(std::size_t size) {
    for (auto* column : {&x, &y, &z, &range}) column->resize(size + padding, 0.0f);
}

GpuLights::GpuLights(const glm::dmat3& workingFromRec709)
    : workingFromRec709_(workingFromRec709),
      records_(GL_RGBA32F, layout::LIGHT_TEXELS, "lights"),
      cones_(GL_RGBA32F, 1, "spot cones") {}

glm::vec4 GpuLights::intensityTexel(const WorldLight& light) const {
    const glm::vec3 working(workingFromRec709_ * glm::dvec3(light.intensity));
    return glm::vec4(working, light.castsShadow ? 1.0f : 0.0f);
}

float GpuLights::brightestChannel(std::uint32_t record) const {
    const glm::vec4& intensity = records_.texels()[record * layout::LIGHT_TEXELS + 1];
    return std::max({intensity.r, intensity.g, intensity.b, 0.0f});
}

void GpuLights::writeRange(std::uint32_t record, float range) {
    if (range == reaches_.range[record]) return;
    reaches_.range[record] = range;
    records_.edit(record)[0].w = 1.0f / (range * range);
}

void GpuLights::writePosition(std::uint32_t record, const glm::vec3& position) {
    reaches_.x[record] = position.x;
    reaches_.y[record] = position.y;
    reaches_.z[record] = position.z;
    glm::vec4& texel = records_.edit(record)[0];
    texel = glm::vec4(position, texel.w);
}

void GpuLights::placeSpheres(std::uint32_t sample) {
    for (const Sphere& sphere : spheres_) {
        const glm::vec3 position =
            sphere.center + sphere.radius * glm::vec3(lightPoint(sample, sphere.index));
        if (isFinite(position)) writePosition(recordOf_[sphere.index], position);
    }
}

void GpuLights::setSample(std::uint32_t sample) {
    if (sample != sample_) placeSpheres(sample);
    sample_ = sample;
}

void GpuLights::writeLocal(std::uint32_t record, const WorldLight& light) {
    writePosition(record, light.position);
    const std::span<glm::vec4> texels = records_.edit(record);
    texels[0].w = 0.0f;
    texels[1] = intensityTexel(light);
    reaches_.range[record] = 0.0f;
    isRangeless_[record] = !(light.range > 0.0f);
    if (isRangeless_[record]) {
        rangeless_.push_back(record);
    } else {
        writeRange(record, glm::clamp(light.range, minRange, maxRange));
    }
}

void GpuLights::assignRanges(const RangeRule& rule) {
    if (sample_ != 0) placeSpheres(0);
    std::vector<RangelessLight> lights;
    lights.reserve(rangeless_.size());
    for (const std::uint32_t record : rangeless_)
        lights.push_back({reaches_.position(record), brightestChannel(record)});
    report_.rangesAssigned = rangeless_.size();
    report_.rangeIrradiance = rangeIrradiance(lights, rule.region, rule.maxLoss);
    report_.minRange = report_.maxRange = 0.0f;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double range = std::sqrt(lights[i].intensity / report_.rangeIrradiance);
        // Without intensity or without a surface there is nothing to reach.
        writeRange(rangeless_[i], std::isfinite(range) && range > 0.0
                                      ? glm::clamp(static_cast<float>(range), minRange, maxRange)
                                      : unlitRange);
        const float written = reaches_.range[rangeless_[i]];
        report_.minRange = i == 0 ? written : std::min(report_.minRange, written);
        report_.maxRange = std::max(report_.maxRange, written);
    }
    if (sample_ != 0) placeSpheres(sample_);
    rangelessMoved_ = false;
}

void GpuLights::writeDirectional(std::uint32_t record, const WorldLight& light) {
    const std::span<glm::vec4> texels = records_.edit(record);
    texels[0] = glm::vec4(-light.direction, 0.0f);
    texels[1] = intensityTexel(light);
}

void GpuLights::writeCone(std::uint32_t record, const WorldLight& light) {
    cones_.edit(record - static_cast<std::uint32_t>(counts_.points))[0] = coneRecord(light);
}

void GpuLights::reserve(const LightCounts& counts) {
    const auto local = static_cast<std::size_t>(counts.points) + static_cast<std::size_t>(counts.spots);
    const std::size_t all = local + static_cast<std::size_t>(counts.directionals);
    records_.reserve(all);
    cones_.reserve(static_cast<std::size_t>(counts.spots));
    reaches_.reserve(local);
    recordOf_.reserve(all);
    rangeless_.reserve(local);
    spheres_.reserve(local);
    isRangeless_.reserve(local);
}

void GpuLights::set(std::span<const WorldLight> lights, const RangeRule& rule) {
    LightCounts counts;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (const char* text = fault(lights[i]))
            throw Error(ErrorKind::badInput, "", "light " + std::to_string(i) + ": " + text);
        counts.points += lights[i].type == LightType::point;
        counts.spots += lights[i].type == LightType::spot;
        counts.directionals += lights[i].type == LightType::directional;
        counts.shadowed += lights[i].castsShadow;
    }
    reserve(counts);
    // From here on nothing throws.
    counts_ = counts;
    report_ = {.lights = lights.size()};
    records_.resize(lights.size());
    cones_.resize(static_cast<std::size_t>(counts.spots));
    reaches_.resize(static_cast<std::size_t>(counts.points + counts.spots));
    recordOf_.clear();
    rangeless_.clear();
    spheres_.clear();
    sample_ = 0;
    isRangeless_.assign(reaches_.size(), false);
    auto point = 0u, spot = static_cast<std::uint32_t>(counts.points);
    auto directional = static_cast<std::uint32_t>(counts.points + counts.spots);
    for (const WorldLight& light : lights) {
        if (light.type == LightType::point) {
            writeLocal(point, light);
            recordOf_.push_back(point++);
        } else if (light.type == LightType::spot) {
            writeCone(spot, light);
            writeLocal(spot, light);
            recordOf_.push_back(spot++);
        } else {
            writeDirectional(directional, light);
            recordOf_.push_back(directional++);
        }
        if (light.radius > 0.0f && light.type != LightType::directional)
            spheres_.push_back(
                {static_cast<std::uint32_t>(recordOf_.size() - 1), light.position, light.radius});
    }
    if (hasRangeless()) assignRanges(rule);
    upload();
}

void GpuLights::move(std::uint32_t index, const WorldLight& light) {
    if (fault(light) != nullptr) return;
    const std::uint32_t record = recordOf_[index];
    if (light.type == LightType::directional) {
        writeDirectional(record, light);
        return;
    }
    if (light.type == LightType::spot) writeCone(record, light);
    glm::vec3 position = light.position;
    const auto sphere = std::ranges::lower_bound(spheres_, index, {}, &Sphere::index);
    if (sphere != spheres_.end() && sphere->index == index) {
        sphere->center = position;
        position += sphere->radius * glm::vec3(lightPoint(sample_, index));
    }
    writePosition(record, position);
    rangelessMoved_ = rangelessMoved_ || isRangeless_[record];
}

std::size_t GpuLights::upload() {
    cones_.upload();
    return records_.upload();
}

}  // namespace candela
