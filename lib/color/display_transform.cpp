#include <candela/color.h>
#include <candela/error.h>

#include "color/display_transform.h"

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace candela {

namespace {

using KeptSteps = std::shared_ptr<const OwnedDisplaySteps>;

KeptSteps makeSteps(const DisplayTransform::State& state) {
    const auto baked = BakedTransform::make(state.processor, 0);
    return std::make_shared<OwnedDisplaySteps>(baked ? baked->steps() : exactStep(state.cpu));
}

/// Transforms that differ in exposure alone have the same steps, which are kept for the last few processors.
KeptSteps keptSteps(const DisplayTransform::State& state) {
    constexpr std::size_t maxKept = 16;
    static std::mutex mutex;
    static std::deque<std::pair<std::string, KeptSteps>> kept;
    const std::string id = state.processor->getCacheID();
    const std::lock_guard lock(mutex);
    for (const auto& [known, steps] : kept)
        if (known == id) return steps;
    if (kept.size() == maxKept) kept.pop_front();
    return kept.emplace_back(id, makeSteps(state)).second;
}

}  // namespace

DisplayTransform::DisplayTransform(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const DisplayOptions& DisplayTransform::options() const {
    return state_->options;
}
DisplayEncoding DisplayTransform::encoding() const {
    return state_->encoding;
}

void DisplayTransform::apply(std::span<float> rgba) const {
    if (rgba.size() % 4 != 0)
        throw Error(ErrorKind::badInput, {},
                    "a display transform was given " + std::to_string(rgba.size()) +
                        " numbers; 4 per pixel were expected");
    const auto exposure = float(std::exp2(state_->options.exposure));
    // OpenColorIO sees an alpha of 1, as in the shader: a config's matrix may read it.
    constexpr std::size_t chunk = 4096;
    std::vector<float> pixels(std::min(rgba.size(), 4 * chunk));
    for (std::size_t start = 0; start < rgba.size(); start += pixels.size()) {
        const std::span<float> part = rgba.subspan(start, std::min(pixels.size(), rgba.size() - start));
        for (std::size_t i = 0; i < part.size(); ++i)
            pixels[i] = i % 4 == 3 ? 1.0f : sanitizedRadiance(part[i] * exposure);
        OCIO::PackedImageDesc image(pixels.data(), long(part.size() / 4), 1, 4);
        state_->cpu->apply(image);
        for (std::size_t i = 0; i < part.size(); ++i)
            if (i % 4 != 3) part[i] = sanitizedCode(pixels[i]);
    }
}

std::span<const DisplayStep> displaySteps(const DisplayTransform& transform) {
    const DisplayTransform::State& state = transform.state();
    std::call_once(state.stepsOnce, [&] { state.steps = keptSteps(state); });
    return state.steps->steps;
}

}  // namespace candela
