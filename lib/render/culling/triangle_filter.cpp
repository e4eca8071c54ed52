#include "render/culling/triangle_filter.h"

#include "render/gpu_scene/gpu_scene_state.h"

namespace candela {

TriangleFilter::TriangleFilter(const GpuScene::State& scene) : scene_(scene) {
    describeMeshes();
}

void TriangleFilter::describeMeshes() {
    scene_.describeMeshes(vertexArray_);
}

std::optional<ClusterRange> TriangleFilter::clustersOf(const PipelineKey& key, const DrawCommand& command,
                                                       const Scope& scope) const {
    if (key.geometry.kind != DrawGeometry::Kind::meshes || key.topology != Topology::triangles ||
        key.furtherUvPairs != 0 || !key.isIn(scope.surfaces) || command.count < scope.minIndices ||
        indexCount_ + std::size_t{command.count} * command.instanceCount > scope.maxIndices)
        return std::nullopt;
    const std::uint32_t mesh = *scene_.instances[scene_.draws.instanceOfRecord(command.baseInstance)].mesh;
    const std::uint32_t firstIndex = scene_.meshes.places()[mesh].firstIndex;
    return scene_.clusters.of(mesh, command.firstIndex - firstIndex, command.count);
}

void TriangleFilter::addCommand(const PipelineKey& key, bool filtered, const DrawCommand& command) {
    if (runs_.empty() || runs_.back().filtered != filtered || runs_.back().key != key)
        runs_.push_back({key, filtered, static_cast<std::uint32_t>(commands_.size()), 0});
    commands_.push_back(command);
    ++runs_.back().commandCount;
}

void TriangleFilter::plan(const DrawSelection& selection, const Scope& scope) {
    draws_.clear();
    commands_.clear();
    runs_.clear();
    indexCount_ = 0;
    for (const DrawBatch& batch : selection.batches()) {
        const float facing = batch.key.doubleSided ? 0.0f : batch.key.mirrored ? -1.0f : 1.0f;
        for (const DrawCommand& command : selection.commands(batch)) {
            const std::optional<ClusterRange> clusters = clustersOf(batch.key, command, scope);
            if (!clusters) {
                addCommand(batch.key, false, command);
                continue;
            }
            DrawCommand single = command;
            single.instanceCount = 1;
            for (std::uint32_t i = 0; i < command.instanceCount; ++i, ++single.baseInstance) {
                const std::uint32_t instance = scene_.draws.instanceOfRecord(single.baseInstance);
                draws_.push_back({single, *clusters, instance, facing, commands_.size()});
                addCommand(batch.key, true, single);
                indexCount_ += single.count;
            }
        }
    }
}

layout::FilterView TriangleFilter::viewOf(const Draw& draw, const FilterCamera& camera) const {
    const BoundingSphere& sphere = scene_.meshes.places()[*scene_.instances[draw.instance].mesh].sphere;
    return camera.view(scene_.instances.record(draw.instance), sphere, draw.facing);
}

void TriangleFilter::draw(const Run& run) {
    DrawSelection::draw({run.key, run.firstCommand, run.commandCount});
}

}  // namespace candela
