#include "render/lighting/tiled/software_tiles.h"

#include "base/thread_pool.h"
#include "render/gbuffer/readback.h"
#include "render/gbuffer/srgb.h"
#include "shading/directional_albedo.h"

#include <glm/vec3.hpp>

namespace candela {

namespace {

void copy(float (&to)[3], const glm::vec3& from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

}  // namespace

SoftwareTiles::SoftwareTiles(const TileKernel& kernel) : kernel_(kernel) {
    for (std::size_t code = 0; code < srgbDecode_.size(); ++code)
        srgbDecode_[code] = srgbDecode(static_cast<float>(code) / 255.0f);
}

void SoftwareTiles::Worker::reserve(std::size_t lights) {
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

void SoftwareTiles::readTargets(const LightingInputs& inputs) {
    const GBufferTargets& targets = inputs.targets;
    const std::size_t pixels =
        static_cast<std::size_t>(targets.width) * static_cast<std::size_t>(targets.height);
    surfaces_.resize(2 * pixels);
    depth_.resize(pixels);
    radiance_.resize(4 * pixels);
    readSurfaces(targets, surfaces_);
    readDepth(targets, depth_);
    if (inputs.emissionDrawn) readColor(targets.radiance, targets.width, targets.height, radiance_);
}

TileFrame SoftwareTiles::frameOf(const LightingInputs& inputs) {
    const layout::FrameUniforms& uniforms = inputs.uniforms;
    const GpuLights& lights = inputs.lights;
    const LightCounts& counts = lights.counts();
    TileFrame frame{};
    copy(frame.eye, glm::vec3(uniforms.eye));
    frame.nearPlane = uniforms.eye.w;
    copy(frame.rayCorner, glm::vec3(uniforms.rayCorner));
    copy(frame.rayStepX, glm::vec3(uniforms.rayStepX));
    copy(frame.rayStepY, glm::vec3(uniforms.rayStepY));
    inputs.frustum.copyTo(frame);
    frame.width = inputs.targets.width;
    frame.height = inputs.targets.height;
    frame.surfaces = surfaces_.data();
    frame.depth = depth_.data();
    frame.radiance = radiance_.data();
    frame.keepsEmission = inputs.emissionDrawn;
    const LightReaches& reaches = lights.reaches();
    const std::vector<float>* columns[] = {&reaches.x, &reaches.y, &reaches.z, &reaches.range};
    for (int i = 0; i < 4; ++i) frame.reach[i] = columns[i]->data();
    frame.records = reinterpret_cast<const float*>(lights.recordData().data());
    frame.cones = reinterpret_cast<const float*>(lights.coneData().data());
    frame.pointCount = static_cast<std::uint32_t>(counts.points);
    frame.localCount = static_cast<std::uint32_t>(counts.points + counts.spots);
    frame.directionalCount = static_cast<std::uint32_t>(counts.directionals);
    frame.srgbDecode = srgbDecode_.data();
    frame.albedoTable = directionalAlbedoTable().data();
    frame.albedoTableSize = albedoTableSize;
    return frame;
}

void SoftwareTiles::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    readTargets(inputs);
    const TileFrame frame = frameOf(inputs);
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    bins_.fill(frame, kernel_, *pool);
    workers_.resize(pool->size());
    for (Worker& worker : workers_) {
        worker.reserve(bins_.longest());
        worker.scratch->pairsEvaluated = 0;
    }
    const auto shade = kernel_.shade[static_cast<std::size_t>(inputs.brdf)];
    pool->run(bins_.order().size(), [&](std::size_t i, unsigned worker) {
        const std::uint32_t tile = bins_.order()[i];
        const auto lights = bins_.lights(tile);
        const int x = static_cast<int>(tile) % bins_.columns(), y = static_cast<int>(tile) / bins_.columns();
        shade(frame, x, y, lights.data(), static_cast<std::uint32_t>(lights.size()),
              *workers_[worker].scratch);
    });
    glTextureSubImage2D(inputs.targets.radiance.name(), 0, 0, 0, frame.width, frame.height, GL_RGBA, GL_FLOAT,
                        radiance_.data());
}

std::uint64_t SoftwareTiles::countEvaluated(const LightingInputs&, PairCounter&) {
    std::uint64_t pairs = 0;
    for (const Worker& worker : workers_) pairs += worker.scratch->pairsEvaluated;
    return pairs;
}

}  // namespace candela
