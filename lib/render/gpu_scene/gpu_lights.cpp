#include "render/gpu_scene/gpu_lights.h"

#include "base/thread_pool.h"
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

// Lights that one worker converts at a time.
constexpr std::size_t lightsPerChunk = 8192;

std::span<const WorldLight> chunkOf(std::span<const WorldLight> lights, std::size_t index) {
    const std::size_t first = index * lightsPerChunk;
    return lights.subspan(first, std::min(lightsPerChunk, lights.size() - first));
}

bool isLocal(const WorldLight& light) {
    return light.type != LightType::directional;
}

bool isSphere(const WorldLight& light) {
    return light.radius > 0.0f && isLocal(light);
}

bool isRangeless(const WorldLight& light) {
    return !(light.range > 0.0f) && isLocal(light);
}

}  // namespace

/// Numbers of consecutive lights; with those of all chunks before, the places of their records.
struct GpuLights::Chunk {
    LightCounts counts;
    std::uint32_t lights = 0, rangeless = 0, spheres = 0;
    std::uint32_t faulty = UINT32_MAX;  ///< The first light with a fault.

    void add(const WorldLight& light) {
        ++lights;
        counts.points += light.type == LightType::point;
        counts.spots += light.type == LightType::spot;
        counts.directionals += light.type == LightType::directional;
        counts.shadowed += light.castsShadow;
        rangeless += isRangeless(light);
        spheres += isSphere(light);
    }
    void add(const Chunk& other) {
        lights += other.lights;
        counts.points += other.counts.points;
        counts.spots += other.counts.spots;
        counts.directionals += other.counts.directionals;
        counts.shadowed += other.counts.shadowed;
        rangeless += other.rangeless;
        spheres += other.spheres;
        faulty = std::min(faulty, other.faulty);
    }
    std::size_t local() const {
        return static_cast<std::size_t>(counts.points) + static_cast<std::size_t>(counts.spots);
    }
    /// Are the records in the order of the lights?
    bool isOrdered() const {
        const auto all = static_cast<int>(lights);
        return counts.points == all || counts.spots == all || counts.directionals == all;
    }
};

void LightReaches::reserve(std::size_t size) {
    for (auto* column : {&x, &y, &z, &range}) column->reserve(size + padding);
}

void LightReaches::resize(std::size_t size) {
    for (auto* column : {&x, &y, &z, &range}) column->resize(size + padding, 0.0f);
}

GpuLights::GpuLights(const glm::dmat3& workingFromRec709, LightUpload when)
    : workingFromRec709_(workingFromRec709),
      when_(when),
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
        if (isFinite(position)) writePosition(recordOf(sphere.index), position);
    }
}

void GpuLights::setSample(std::uint32_t sample) {
    if (sample != sample_) placeSpheres(sample);
    sample_ = sample;
}

/// Those of a light without a range are for `assignRanges` to write.
void GpuLights::writeLocal(std::uint32_t record, const WorldLight& light) {
    const float range = isRangeless(light) ? 0.0f : glm::clamp(light.range, minRange, maxRange);
    reaches_.x[record] = light.position.x;
    reaches_.y[record] = light.position.y;
    reaches_.z[record] = light.position.z;
    reaches_.range[record] = range;
    const std::span<glm::vec4> texels = records_.fill(record);
    texels[0] = glm::vec4(light.position, isRangeless(light) ? 0.0f : 1.0f / (range * range));
    texels[1] = intensityTexel(light);
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
    assigned_ = rule;
}

void GpuLights::writeDirectional(std::span<glm::vec4> record, const WorldLight& light) const {
    record[0] = glm::vec4(-light.direction, 0.0f);
    record[1] = intensityTexel(light);
}

void GpuLights::reserve(const Chunk& all) {
    const auto makeRoom = [this](RecordBuffer<glm::vec4>& buffer, std::size_t records) {
        if (when_ == LightUpload::atOnce)
            buffer.reserve(records);
        else
            buffer.reserveMemory(records);
    };
    makeRoom(records_, all.lights);
    makeRoom(cones_, static_cast<std::size_t>(all.counts.spots));
    reaches_.reserve(all.local());
    if (!all.isOrdered()) recordOf_.reserve(all.lights);
    rangeless_.reserve(all.rangeless);
    if (all.rangeless > 0) isRangeless_.reserve(all.local());
    spheres_.reserve(all.spheres);
}

void GpuLights::resize(const Chunk& all) {
    records_.resize(all.lights);
    cones_.resize(static_cast<std::size_t>(all.counts.spots));
    reaches_.resize(all.local());
    recordOf_.resize(all.isOrdered() ? 0 : all.lights);
    rangeless_.resize(all.rangeless);
    spheres_.resize(all.spheres);
}

void GpuLights::write(std::span<const WorldLight> lights, Chunk to) {
    for (const WorldLight& light : lights) {
        std::uint32_t record = 0;
        if (light.type == LightType::directional) {
            record = static_cast<std::uint32_t>(counts_.points + counts_.spots + to.counts.directionals);
            writeDirectional(records_.fill(record), light);
        } else {
            const bool isSpot = light.type == LightType::spot;
            record = static_cast<std::uint32_t>(isSpot ? counts_.points + to.counts.spots : to.counts.points);
            if (isSpot) cones_.fill(coneOf(record))[0] = coneRecord(light);
            writeLocal(record, light);
        }
        if (!recordOf_.empty()) recordOf_[to.lights] = record;
        if (isRangeless(light)) rangeless_[to.rangeless] = record;
        if (isSphere(light)) spheres_[to.spheres] = {to.lights, light.position, light.radius};
        to.add(light);
    }
}

std::vector<GpuLights::Chunk> GpuLights::countLights(std::span<const WorldLight> lights, ThreadPool& pool) {
    std::vector<Chunk> chunks((lights.size() + lightsPerChunk - 1) / lightsPerChunk);
    pool.run(chunks.size(), [&](std::size_t i, unsigned) {
        const std::span<const WorldLight> chunk = chunkOf(lights, i);
        for (std::size_t k = 0; k < chunk.size(); ++k) {
            if (chunks[i].faulty == UINT32_MAX && fault(chunk[k]) != nullptr)
                chunks[i].faulty = static_cast<std::uint32_t>(i * lightsPerChunk + k);
            chunks[i].add(chunk[k]);
        }
    });
    return chunks;
}

GpuLights::Chunk GpuLights::sumUp(std::vector<Chunk>& chunks) {
    Chunk sum;
    for (Chunk& chunk : chunks) {
        const Chunk own = chunk;
        chunk = sum;
        sum.add(own);
    }
    return sum;
}

void GpuLights::set(std::span<const WorldLight> lights, const RangeRule& rule) {
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    std::vector<Chunk> chunks = countLights(lights, *pool);
    const Chunk all = sumUp(chunks);
    if (all.faulty != UINT32_MAX) {
        throw Error(ErrorKind::badInput, "",
                    "light " + std::to_string(all.faulty) + ": " + fault(lights[all.faulty]));
    }
    reserve(all);
    // From here on nothing throws.
    counts_ = all.counts;
    report_ = {.lights = lights.size()};
    sample_ = 0;
    resize(all);
    pool->run(chunks.size(), [&](std::size_t i, unsigned) { write(chunkOf(lights, i), chunks[i]); });
    isRangeless_.assign(rangeless_.empty() ? 0 : reaches_.size(), false);
    for (const std::uint32_t record : rangeless_) isRangeless_[record] = true;
    if (hasRangeless()) assignRanges(rule);
    upload();
}

void GpuLights::move(std::uint32_t index, const WorldLight& light) {
    if (fault(light) != nullptr) return;
    const std::uint32_t record = recordOf(index);
    if (light.type == LightType::directional) {
        writeDirectional(records_.edit(record), light);
        return;
    }
    if (light.type == LightType::spot) cones_.edit(coneOf(record))[0] = coneRecord(light);
    glm::vec3 position = light.position;
    const auto sphere = std::ranges::lower_bound(spheres_, index, {}, &Sphere::index);
    if (sphere != spheres_.end() && sphere->index == index) {
        sphere->center = position;
        position += sphere->radius * glm::vec3(lightPoint(sample_, index));
    }
    writePosition(record, position);
    rangelessMoved_ = rangelessMoved_ || (hasRangeless() && isRangeless_[record]);
}

void GpuLights::change(std::uint32_t index, const WorldLight& light) {
    if (fault(light) != nullptr) return;
    const std::uint32_t record = recordOf(index);
    records_.edit(record)[1] = intensityTexel(light);
    if (isLocal(light) && !isRangeless(light))
        writeRange(record, glm::clamp(light.range, minRange, maxRange));
    move(index, light);
}

std::size_t GpuLights::upload() {
    if (when_ == LightUpload::whenBound) {
        cones_.countEdited();
        return records_.countEdited();
    }
    cones_.upload();
    return records_.upload();
}

const gl::BufferTexture& GpuLights::uploaded(RecordBuffer<glm::vec4>& buffer) const {
    if (when_ == LightUpload::whenBound) buffer.upload();
    return buffer.texture();
}

}  // namespace candela
