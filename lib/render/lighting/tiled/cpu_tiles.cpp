#include "render/lighting/tiled/cpu_tiles.h"

#include "base/thread_pool.h"
#include "render/environment/gpu_environment.h"
#include "render/gbuffer/readback.h"
#include "render/gbuffer/srgb.h"
#include "render/occlusion/occlusion_scene.h"
#include "shading/directional_albedo.h"
#include "shading/sheen_albedo.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

void copy(float (&to)[3], const glm::vec3& from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

void readLights(TileFrame& frame, const LightReaches& reaches, std::span<const glm::vec4> records,
                std::span<const glm::vec4> cones) {
    const std::vector<float>* columns[] = {&reaches.x, &reaches.y, &reaches.z, &reaches.range};
    for (int i = 0; i < 4; ++i) frame.reach[i] = columns[i]->data();
    frame.records = reinterpret_cast<const float*>(records.data());
    frame.cones = reinterpret_cast<const float*>(cones.data());
}

}  // namespace

void readView(TileFrame& frame, const layout::FrameUniforms& uniforms) {
    copy(frame.eye, glm::vec3(uniforms.eye));
    frame.nearPlane = uniforms.eye.w;
    copy(frame.rayCorner, glm::vec3(uniforms.rayCorner));
    copy(frame.rayStepX, glm::vec3(uniforms.rayStepX));
    copy(frame.rayStepY, glm::vec3(uniforms.rayStepY));
    copy(frame.right, glm::vec3(uniforms.cameraRight));
    copy(frame.up, glm::vec3(uniforms.cameraUp));
    copy(frame.forward, glm::vec3(uniforms.cameraForward));
    frame.orthographic = uniforms.depthRange.w != 0.0f;
    frame.nearOverFar = uniforms.depthRange.x;
    frame.depthScale = uniforms.depthRange.y;
    frame.farPlane = uniforms.depthRange.y;
    frame.depthRange = uniforms.depthRange.z;
    (frame.orthographic ? frame.base : frame.halfExtent)[0] = uniforms.cameraRight.w;
    (frame.orthographic ? frame.base : frame.halfExtent)[1] = uniforms.cameraUp.w;
    frame.shift[0] = uniforms.rayStepX.w;
    frame.shift[1] = uniforms.rayStepY.w;
    frame.pixelSide = glm::length(glm::vec3(uniforms.rayStepY));
}

CpuTiles::CpuTiles(const TileKernel& kernel, std::uint64_t maxListWords)
    : kernel_(kernel), bins_(maxListWords) {
    for (std::size_t code = 0; code < srgbDecode_.size(); ++code)
        srgbDecode_[code] = srgbDecode(static_cast<float>(code) / 255.0f);
}

void CpuTiles::Worker::reserve(std::size_t lights) {
    const std::size_t room = lights + listPadding, levels = boxLevels + 1;
    if (indices.size() >= room * levels) return;
    floats.resize(room * levels * 4);
    indices.resize(room * levels);
    for (std::size_t level = 0; level < levels; ++level) {
        float* columns = floats.data() + level * room * 4;
        scratch->levels[level] = {columns, columns + room, columns + 2 * room, columns + 3 * room,
                                  indices.data() + level * room};
    }
}

void CpuTiles::Worker::reserveShadows(std::size_t lights, std::size_t directionals,
                                      const OcclusionView& occlusion) {
    ShadowScratch& shadows = scratch->shadows;
    if (instances.size() < lights + directionals) {
        instances.resize(lights + directionals);
        pixels.resize(3 * (lights + directionals));
    }
    if (lightOfSlot.size() < lights) lightOfSlot.resize(lights);
    const std::size_t all = instances.size();
    shadows.locals = instances.data();
    shadows.directionals = instances.data() + (all - directionals);
    shadows.lightOfSlot = lightOfSlot.data();
    shadows.visible = pixels.data();
    shadows.hidden = pixels.data() + all;
    shadows.dimmed = pixels.data() + 2 * all;
    if (occlusion.blends) transmittance.resize(all * std::size_t{RayPacket::size});
    shadows.transmittance = occlusion.blends ? transmittance.data() : nullptr;
}

GBufferCopy& CpuTiles::copyOf(const LightingInputs& inputs) {
    if (inputs.copy != nullptr) return *inputs.copy;
    copy_.reset(inputs.targets);
    return copy_;
}

TileFrame CpuTiles::frameOf(const LightingInputs& inputs) {
    const layout::FrameUniforms& uniforms = inputs.uniforms;
    const GpuLights& lights = inputs.lights;
    const LightCounts& counts = lights.counts();
    TileFrame frame{};
    readView(frame, uniforms);
    frame.width = inputs.targets.width;
    frame.height = inputs.targets.height;
    GBufferCopy& copy = copyOf(inputs);
    rectangle_ = copy.rectangle();
    frame.surfaces = copy.surfaces().data();
    frame.depth = copy.depth().data();
    frame.environment = inputs.environment == nullptr ? nullptr : &inputs.environment->view();
    frame.environmentVisibility = inputs.environmentVisibility;
    frame.shadowWords = inputs.occlusion == nullptr ? nullptr : copy.shadowWords().data();
    frame.lobeWords = inputs.targets.parts.lobes ? copy.lobeWords().data() : nullptr;
    frame.diffuseTransmission = inputs.targets.parts.lobes ? copy.diffuseTransmission().data() : nullptr;
    frame.occlusion = inputs.occlusion == nullptr ? nullptr : &inputs.occlusion->view();
    radiance_.resize(4 * copy.depth().size());
    frame.radiance = radiance_.data();
    frame.loadRadiance = inputs.emissionDrawn;
    readLights(frame, lights.reaches(), lights.recordData(), lights.coneData());
    frame.pointCount = static_cast<std::uint32_t>(counts.points);
    frame.localCount = static_cast<std::uint32_t>(counts.points + counts.spots);
    frame.directionalCount = static_cast<std::uint32_t>(counts.directionals);
    frame.srgbDecode = srgbDecode_.data();
    frame.albedoTable = directionalAlbedoTable(inputs.brdf).data();
    frame.sheenTable = inputs.targets.parts.lobes ? sheenAlbedoTable().data() : nullptr;
    frame.albedoTableSize = albedoTableSize;
    return frame;
}

bool CpuTiles::isShaded(int tileX, int tileY) const {
    const auto overlaps = [](int tile, int first, int size) {
        return tile * tileSize < first + size && (tile + 1) * tileSize > first;
    };
    return overlaps(tileX, rectangle_.x, rectangle_.width) &&
           overlaps(tileY, rectangle_.y, rectangle_.height);
}

void CpuTiles::shadeTiles(const TileFrame& frame, BrdfModel brdf, ThreadPool& pool) {
    for (Worker& worker : workers_) {
        worker.reserve(bins_.longest());
        if (frame.occlusion != nullptr) {
            worker.reserveShadows(bins_.longest(), frame.directionalCount, *frame.occlusion);
        }
    }
    const auto shade = kernel_.shade[static_cast<std::size_t>(brdf)];
    pool.run(bins_.order().size(), [&](std::size_t i, unsigned worker) {
        const std::uint32_t tile = bins_.order()[i];
        const int x = static_cast<int>(tile) % bins_.columns(), y = static_cast<int>(tile) / bins_.columns();
        if (!isShaded(x, y)) return;
        const auto lights = bins_.lights(tile);
        shade(frame, x, y, lights.data(), static_cast<std::uint32_t>(lights.size()),
              *workers_[worker].scratch);
    });
}

void CpuTiles::shadeAll(TileFrame frame, BrdfModel brdf) {
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    workers_.resize(pool->size());
    for (Worker& worker : workers_) {
        worker.scratch->pairsEvaluated = 0;
        worker.scratch->shadows.raysAsked = worker.scratch->shadows.raysTraced = 0;
    }
    listBytes_ = 0;
    std::uint32_t binned = 0;
    do {
        binned = bins_.fill(frame, binned, kernel_, *pool);
        listBytes_ = std::max(listBytes_, bins_.bytes());
        shadeTiles(frame, brdf, *pool);
        // What follows adds to the first part, which has the directional lights and the environment.
        frame.loadRadiance = true;
        frame.directionalCount = 0;
        frame.environment = nullptr;
    } while (binned < frame.localCount);
}

void CpuTiles::capture(const LightingInputs& inputs) {
    frame_ = frameOf(inputs);
    if (inputs.emissionDrawn) readRadiance(inputs.targets, rectangle_, radiance_);
    brdf_ = inputs.brdf;
}

void CpuTiles::keepLights(const GpuLights& lights) {
    keptReaches_ = lights.reaches();
    keptRecords_.assign(lights.recordData().begin(), lights.recordData().end());
    keptCones_.assign(lights.coneData().begin(), lights.coneData().end());
    readLights(frame_, keptReaches_, keptRecords_, keptCones_);
}

void CpuTiles::shade() {
    shadeAll(frame_, brdf_);
}

void CpuTiles::shadeOnto(std::span<float> sum) {
    TileFrame frame = frame_;
    frame.radiance = sum.data();
    frame.loadRadiance = true;
    shadeAll(frame, brdf_);
}

void CpuTiles::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    capture(inputs);
    shade();
    inputs.targets.memory = result();
}

std::vector<float> CpuTiles::shadowedPerPixel(const LightingInputs& inputs) {
    TileFrame frame = frameOf(inputs);
    std::vector<float> counts(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
    frame.shadowedCounts = counts.data();
    frame.environment = nullptr;
    frame.loadRadiance = true;  // Nothing is written to it.
    shadeAll(frame, inputs.brdf);
    return counts;
}

std::uint64_t CpuTiles::countEvaluated(const LightingInputs&, PairCounter&) {
    std::uint64_t pairs = 0;
    for (const Worker& worker : workers_) pairs += worker.scratch->pairsEvaluated;
    return pairs;
}

ShadowCounts CpuTiles::shadowCounts() const {
    ShadowCounts counts;
    for (const Worker& worker : workers_) {
        counts.raysAsked += worker.scratch->shadows.raysAsked;
        counts.raysTraced += worker.scratch->shadows.raysTraced;
    }
    counts.raysSaved = counts.raysAsked - counts.raysTraced;
    return counts;
}

}  // namespace candela
