#include "gl/state_guard.h"
#include "render/debug/aovs.h"
#include "render/debug/motion.h"
#include "render/gbuffer/readback.h"
#include "render/renderer_state.h"

#include <algorithm>
#include <array>
#include <utility>

namespace candela {

namespace {

/// What each pixel shows, rows from the bottom.
struct SurfaceIds {
    std::vector<SurfaceId> surfaces;
    std::vector<float> nodes, materials, instances;  ///< Counted from 1; 0: none.
};

SurfaceIds listIds(const GpuScene::State& scene, std::vector<SurfaceId> surfaces) {
    SurfaceIds ids;
    ids.surfaces = std::move(surfaces);
    const std::uint32_t none = scene.draws.noMaterial() + 1;
    for (const auto& [instance, material] : ids.surfaces) {
        const std::uint32_t node = instance == 0 ? 0 : scene.instances[instance - 1].node + 1;
        ids.nodes.push_back(static_cast<float>(node));
        ids.materials.push_back(material == none ? 0.0f : static_cast<float>(material));
        ids.instances.push_back(static_cast<float>(instance));
    }
    return ids;
}

}  // namespace

std::vector<std::string> Renderer::aovNames() {
    std::vector<std::string> names;
    for (const ChannelRow& row : channelRows()) {
        if (row.source != ChannelSource::ambientOcclusion || hasShadows())
            names.emplace_back(row.channel.name);
    }
    return names;
}

std::vector<Aov> Frame::aovs(const std::vector<std::string>& names) const {
    const std::vector<const ChannelRow*> rows = findAovs(names);
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, "a Frame");
    state.bindFrame();
    ShadedSurfaces& shown = state.frame->hasTransparent ? state.drawMasked(*scene()) : state.frameSurfaces;
    const GBufferTargets& targets = *shown.targets;
    std::vector<float> emission, lightCount, shadowedCount, ambientOcclusion;
    if (usesSource(rows, ChannelSource::emission)) {
        emission = readColor(state.drawEmission(*scene()).radiance, targets.width, targets.height);
    }
    const auto environmentOf = [&](ChannelSource source, EnvironmentPass::Parts parts) {
        if (!usesSource(rows, source)) return std::vector<float>{};
        return readColor(state.drawEnvironment(*scene(), shown, parts).radiance, targets.width,
                         targets.height);
    };
    const std::vector<float> environment = environmentOf(ChannelSource::environment, {});
    const std::vector<float> environmentDiffuse =
        environmentOf(ChannelSource::environmentDiffuse, {.diffuse = 1.0f, .specular = 0.0f});
    const std::vector<float> environmentSpecular =
        environmentOf(ChannelSource::environmentSpecular, {.diffuse = 0.0f, .specular = 1.0f});
    if (usesSource(rows, ChannelSource::lightCount)) {
        const std::shared_ptr<GpuScene::State> scene = this->scene();
        const LightingInputs inputs = state.lightingInputs(*scene, shown);
        state.lighting.bind(inputs);
        lightCount = state.lighting.counter().litPerPixel(inputs);
    }
    if (usesSource(rows, ChannelSource::shadowedCount))
        shadowedCount = state.countShadowed(*scene(), targets);
    if (usesSource(rows, ChannelSource::ambientOcclusion))
        ambientOcclusion = state.traceAmbientOcclusion(*scene(), targets);
    const bool findsIds = std::ranges::any_of(std::array{ChannelSource::nodeId, ChannelSource::materialId,
                                                         ChannelSource::instanceId, ChannelSource::motion},
                                              [&](ChannelSource source) { return usesSource(rows, source); });
    const SurfaceIds ids =
        findsIds ? listIds(*scene(), state.surfaceIds(*scene(), wholeOf(targets))) : SurfaceIds{};
    const std::vector<GBufferTexel> surfaces = readSurfaces(targets);
    const std::vector<float> depth = readDepth(targets);
    std::vector<float> motion;
    if (usesSource(rows, ChannelSource::motion)) {
        const DrawnFrame& frame = *state.frame;
        motion = motionOf({frame.uniforms, frame.pixels, frame.view,
                           frame.settings.previousView.value_or(frame.view), scene()->instances, depth,
                           ids.surfaces, state.previousPositions(*scene(), ids.surfaces)});
    }
    const AovSources sources{
        targets.width, targets.height, state.frame->uniforms, state.frame->origin, depth,
        surfaces,      emission,       environment,           environmentDiffuse,  environmentSpecular,
        lightCount,    shadowedCount,  ambientOcclusion,      ids.nodes,           ids.materials,
        ids.instances, motion};
    std::vector<Aov> result;
    for (const ChannelRow* row : rows) result.push_back(makeAov(*row, sources));
    return result;
}

}  // namespace candela
