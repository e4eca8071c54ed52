#include "render/layers/layer_draws.h"

#include "render/layout.h"

#include <algorithm>
#include <array>
#include <limits>

namespace candela {

namespace {

/// Fewer layers are not worth a pass over the surfaces.
constexpr std::uint32_t minLayers = 3;

/// Does `next` draw the same vertices as `command`, with the record that follows those of `command`?
bool continues(const DrawCommand& command, const DrawCommand& next) {
    return command.firstIndex == next.firstIndex && command.count == next.count &&
           command.baseVertex == next.baseVertex &&
           command.baseInstance + command.instanceCount == next.baseInstance;
}

}  // namespace

void LayerDraws::collect(const GpuScene::State& scene, const DrawSelection& draws,
                         const TriangleFilter* filter) {
    sources_.clear();
    draws_.clear();
    firstNumber_ = std::numeric_limits<std::uint32_t>::max();
    endNumber_ = 0;
    if (filter != nullptr) {
        for (const TriangleFilter::Run& run : filter->runs()) {
            if (run.key.isIn(SurfaceSet::transparent)) add(scene, run, filter->commands(run));
        }
        return;
    }
    for (const DrawBatch& batch : draws.batches()) {
        if (batch.key.isIn(SurfaceSet::transparent))
            add(scene, {batch.key, false, 0, 0}, draws.commands(batch));
    }
}

void LayerDraws::add(const GpuScene::State& scene, const TriangleFilter::Run& source,
                     std::span<const DrawCommand> commands) {
    sources_.push_back(source);
    for (const DrawCommand& command : commands) {
        DrawCommand single = command;
        single.instanceCount = 1;
        for (std::uint32_t i = 0; i < command.instanceCount; ++i, ++single.baseInstance) {
            const std::uint32_t number = scene.draws.numberOfRecord(single.baseInstance);
            draws_.push_back({sources_.size() - 1, single, number});
            firstNumber_ = std::min(firstNumber_, number);
            endNumber_ = std::max(endNumber_, number + 1);
        }
    }
}

std::vector<std::uint64_t> LayerDraws::findLayers(const std::function<void()>& find) {
    const std::size_t count = endNumber_ - firstNumber_;
    const std::vector<std::uint64_t> none(count, 0);
    layersOfDraws_.upload(std::span<const std::uint64_t>(none));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::LAYERS_OF_DRAWS_STORAGE, layersOfDraws_.name());
    find();
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return layersOfDraws_.read<std::uint64_t>(0, count);
}

void LayerDraws::list(std::uint64_t layerBit, std::span<const std::uint64_t> layersOf) {
    firstRun_.push_back(runs_.size());
    std::size_t source = sources_.size();
    for (const Draw& draw : draws_) {
        if ((layersOf[draw.number - firstNumber_] & layerBit) == 0) continue;
        if (draw.run != source) {
            TriangleFilter::Run run = sources_[source = draw.run];
            run.firstCommand = static_cast<std::uint32_t>(commands_.size());
            run.commandCount = 0;
            runs_.push_back(run);
        }
        if (runs_.back().commandCount > 0 && continues(commands_.back(), draw.command)) {
            ++commands_.back().instanceCount;
            continue;
        }
        commands_.push_back(draw.command);
        ++runs_.back().commandCount;
    }
}

void LayerDraws::sort(std::uint32_t layers, const std::function<void()>& find) {
    commands_.clear();
    runs_.clear();
    firstRun_.clear();
    if (layers < minLayers || draws_.size() < 2) return;
    const std::vector<std::uint64_t> layersOf = findLayers(find);
    for (std::uint32_t layer = 0; layer < layers; ++layer) list(std::uint64_t{1} << layer, layersOf);
    firstRun_.push_back(runs_.size());
    commandBuffer_.upload(std::span<const DrawCommand>(commands_));
}

std::optional<DrawRuns> LayerDraws::runs(std::uint32_t layer) const {
    if (firstRun_.empty()) return std::nullopt;
    const std::size_t first = firstRun_[layer];
    return DrawRuns{std::span(runs_).subspan(first, firstRun_[layer + 1] - first), commandBuffer_.name()};
}

}  // namespace candela
