#include <candela/accumulator.h>

#include "gl/pass_timer.h"
#include "gl/state_guard.h"
#include "render/accumulation/sample_sums.h"
#include "render/debug/aovs.h"
#include "render/display/display_pass.h"
#include "render/display/display_target.h"
#include "render/display/memory_display.h"
#include "render/gbuffer/readback.h"
#include "render/host/pending_pictures.h"
#include "render/host/pixel_transfer.h"
#include "render/renderer_state.h"

#include <candela/error.h>
#include <candela/renderer.h>
#include <candela/sampling.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace candela {

namespace {

constexpr const char* user = "an Accumulator";

[[noreturn]] void refuse(const std::string& text) {
    throw Error(ErrorKind::badInput, "", text);
}

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

AovFilter resolved(AovFilter filter, const GBufferChannel& channel) {
    if (filter != AovFilter::automatic) return filter;
    return channel.filter == SampleFilter::average ? AovFilter::average : AovFilter::first;
}

/// The mean, where the sums are in memory; else without radiance.
MemoryPicture meanInMemory(SampleSums& sums, const glm::ivec2& place) {
    return {sums.isInMemory() ? sums.meanInMemory() : std::span<const float>{}, sums.width(), sums.height(),
            place};
}

/// The sum of the samples of an AOV, or its first sample.
struct AovSum {
    AovFilter filter;
    Aov first;
    std::vector<std::vector<double>> sums = {};  ///< Of `AovFilter::average`: as `Aov::values`.

    void add(const Aov& sample) {
        sums.resize(sample.values.size());
        for (std::size_t c = 0; c < sums.size(); ++c) {
            const std::vector<float>& values = sample.values[c];
            sums[c].resize(values.size());
            for (std::size_t i = 0; i < values.size(); ++i) sums[c][i] += static_cast<double>(values[i]);
        }
    }
    Aov mean(std::uint32_t count) const {
        Aov result = first;
        if (filter == AovFilter::first) return result;
        for (std::size_t c = 0; c < sums.size(); ++c)
            for (std::size_t i = 0; i < sums[c].size(); ++i)
                result.values[c][i] = static_cast<float>(sums[c][i] / count);
        return result;
    }
};

}  // namespace

struct Accumulator::State {
    State(const Context& context, AccumulatorOptions requested)
        : binding(context.state().binding),
          options(std::move(requested)),
          timer(context.isSoftware() ? gl::PassTimer::Clock::wallAroundFinish
                                     : gl::PassTimer::Clock::gpuQueries),
          display(context.isSoftware() ? DisplayPass::Baking::always : DisplayPass::Baking::never) {
        for (const ChannelRow* row : findAovs(options.aovs))
            filters.push_back(resolved(options.aovFilter, row->channel));
    }

    void addAovs(const Frame& frame);
    /// Shows the mean in a complete framebuffer.
    void show(const DisplayTransform& transform, const FrameTarget& target);
    /// The mean as it is shown in an own target.
    const DisplayTarget& shownTarget(const DisplayTransform& transform);

    std::shared_ptr<gl::ContextBinding> binding;
    AccumulatorOptions options;
    std::vector<AovFilter> filters;  ///< Of `options.aovs`.
    std::optional<SampleSums> sums;  ///< Of the size of the first frame.
    glm::ivec2 place{0, 0};          ///< Of the last frame's lower left pixel in its picture.
    std::vector<AovSum> aovSums;     ///< As `options.aovs`; empty before the first frame.
    gl::PassTimer timer;
    DisplayPass display;
    MemoryDisplay memoryDisplay;
    std::optional<DisplayTarget> displayTarget;
};

void Accumulator::State::addAovs(const Frame& frame) {
    if (options.aovs.empty()) return;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < filters.size(); ++i)
        if (aovSums.empty() || filters[i] == AovFilter::average) names.push_back(options.aovs[i]);
    if (names.empty()) return;
    std::vector<Aov> samples = frame.aovs(names);
    if (aovSums.empty())
        for (std::size_t i = 0; i < filters.size(); ++i) aovSums.push_back({filters[i], samples[i]});
    auto sample = samples.begin();
    for (AovSum& sum : aovSums) {
        if (sum.first.name != sample->name) continue;
        if (sum.filter == AovFilter::average) sum.add(*sample);
        if (++sample == samples.end()) return;
    }
}

Accumulator::Accumulator(const Context& context, AccumulatorOptions options) {
    context.makeCurrent();
    const std::shared_ptr<gl::ContextBinding>& binding = context.state().binding;
    const gl::StateGuard guard(*binding, user);
    state_ = std::shared_ptr<State>(new State(context, std::move(options)),
                                    gl::ContextDeleter<State>{binding, "Accumulator"});
}

Accumulator::Accumulator(Accumulator&&) noexcept = default;
Accumulator& Accumulator::operator=(Accumulator&&) noexcept = default;
Accumulator::~Accumulator() = default;

Accumulator::State& Accumulator::state() const {
    if (!state_) refuse("an Accumulator is used that was moved from");
    return *state_;
}

Accumulator::State& Accumulator::filled() const {
    State& state = this->state();
    if (count() == 0) refuse("an Accumulator is asked for its mean before a frame was added");
    return state;
}

void Accumulator::add(const Frame& frame) {
    State& state = this->state();
    const auto& renderer = frame.state();
    const DrawnFrame& drawn = *renderer.frame;
    const int width = drawn.settings.width, height = drawn.settings.height;
    if (!renderer.binding->isSameAs(*state.binding))
        refuse(
            "a Frame of another Context is added to an Accumulator; both have to be created for the same "
            "one");
    if (drawn.settings.debugView != DebugView::none)
        refuse("a Frame that shows a debug view is added to an Accumulator; it takes lit frames");
    if (count() > 0 && (width != state.sums->width() || height != state.sums->height())) {
        refuse("a Frame of " + sizeText(width, height) + " pixels is added to an Accumulator of frames of " +
               sizeText(state.sums->width(), state.sums->height()));
    }
    if (count() >= maxSamples) throw Error(ErrorKind::limit, "", "an Accumulator holds at most 65536 frames");
    const gl::StateGuard guard(*state.binding, user);
    if (!state.sums || width != state.sums->width() || height != state.sums->height()) {
        state.sums.emplace(width, height);
        state.displayTarget.reset();
    }
    state.place = {drawn.pixels.left, drawn.pixels.bottom};
    state.addAovs(frame);
    state.timer.beginFrame();
    const gl::PassTimer::Scope pass(state.timer, "accumulate");
    state.sums->add(*renderer.targets);
}

Frame Accumulator::addSamples(Renderer& renderer, GpuScene& scene, const CameraView& view,
                              const FrameSettings& settings, const SamplingSettings& sampling,
                              std::uint32_t first, std::uint32_t end) {
    State& state = this->state();
    if (first >= end) refuse("no samples are added to an Accumulator: the first one has to be below the end");
    if (end > maxSamples || count() > maxSamples - (end - first))
        throw Error(ErrorKind::limit, "", "an Accumulator holds at most 65536 frames");
    const auto viewOf = [&](std::uint32_t sample) {
        const FramePixels pixels = framePixels(settings);
        return sampleView(view, sampling, pixels.pictureWidth, pixels.pictureHeight, sample);
    };
    viewOf(end - 1);  // refuses a sample beyond the count before anything is drawn
    std::optional<Frame> frame;
    for (std::uint32_t i = first; i < end; ++i) {
        FrameSettings sampled = settings;
        sampled.sample = i;
        frame.emplace(renderer.render(scene, viewOf(i), sampled));
        add(*frame);
        auto& drawing = *renderer.state_;
        if (i + 1 == end || !state.options.aovs.empty() || !state.sums->isInMemory() ||
            !drawing.canOverlapSamples(*scene.state_))
            continue;
        const gl::StateGuard guard(*state.binding, user);
        drawing.drawSamples(*scene.state_, {i + 1, end}, viewOf, *state.sums);
        return Frame(renderer.state_, scene.state_, drawing.frameNumber);
    }
    return std::move(*frame);
}

void Accumulator::reset() {
    State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    if (state.sums) state.sums->clear();
    state.aovSums.clear();
}

std::uint32_t Accumulator::count() const {
    const State& state = this->state();
    return state.sums ? state.sums->count() : 0;
}

int Accumulator::width() const {
    return filled().sums->width();
}

int Accumulator::height() const {
    return filled().sums->height();
}

void Accumulator::State::show(const DisplayTransform& transform, const FrameTarget& target) {
    const gl::PassTimer::Scope pass(timer, "display");
    if (const MemoryPicture mean = meanInMemory(*sums, place);
        !mean.radiance.empty() && MemoryDisplay::suits(target)) {
        memoryDisplay.render(mean, transform, target);
    } else {
        display.render({sums->mean(), sums->width(), sums->height(), transform, target, place});
    }
}

const DisplayTarget& Accumulator::State::shownTarget(const DisplayTransform& transform) {
    if (!displayTarget) displayTarget.emplace(sums->width(), sums->height());
    show(transform, {.framebuffer = displayTarget->framebuffer.name()});
    return *displayTarget;
}

void Accumulator::display(const DisplayTransform& transform, const FrameTarget& target) const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    requireTarget(target);
    state.show(transform, target);
}

std::vector<std::uint8_t> Accumulator::displayPicture(const DisplayTransform& transform) const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    if (const MemoryPicture mean = meanInMemory(*state.sums, state.place); !mean.radiance.empty()) {
        const gl::PassTimer::Scope pass(state.timer, "display");
        return state.memoryDisplay.codes(mean, transform);
    }
    return state.shownTarget(transform).read();
}

HdrImage Accumulator::radiance() const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    const int width = state.sums->width(), height = state.sums->height();
    const MemoryPicture mean = meanInMemory(*state.sums, state.place);
    HdrImage image{width, height,
                   mean.radiance.empty() ? readColor(state.sums->mean(), width, height)
                                         : std::vector<float>(mean.radiance.begin(), mean.radiance.end())};
    flipRows(image.rgba, width, height);
    return image;
}

PendingPicture Accumulator::readDisplayPicture(const DisplayTransform& transform) const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    const MemoryPicture mean = meanInMemory(*state.sums, state.place);
    if (!mean.radiance.empty()) return showLater(state.binding, mean, transform);
    return transferPicture(state.binding, state.shownTarget(transform));
}

PendingRadiance Accumulator::readRadiance() const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    const int width = state.sums->width(), height = state.sums->height();
    const auto turned = [width, height](std::vector<float> rgba) {
        flipRows(rgba, width, height);
        return HdrImage{width, height, std::move(rgba)};
    };
    if (const MemoryPicture mean = meanInMemory(*state.sums, state.place); !mean.radiance.empty()) {
        std::vector<float> copy(mean.radiance.begin(), mean.radiance.end());
        return computeLater<HdrImage>(
            state.binding, [turned, copy = std::move(copy)]() mutable { return turned(std::move(copy)); });
    }
    const auto transfer = std::make_shared<PixelTransfer>();
    transfer->start(
        std::array{PixelTransfer::Source{state.sums->mean(), GL_RGBA, GL_FLOAT, width, height, 16}});
    return makePending<HdrImage>(
        state.binding, [transfer] { return transfer->isReady(); },
        [transfer, turned] { return turned(elementsOf<float>(transfer->read(0))); });
}

FrameTexture Accumulator::radianceTexture() const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    return {"radiance",
            state.sums->mean().name(),
            GL_TEXTURE_2D,
            GL_RGBA32F,
            state.sums->width(),
            state.sums->height(),
            "mean radiance in the working space; alpha: the share of the samples that surfaces cover"};
}

FrameTexture Accumulator::displayTexture(const DisplayTransform& transform) const {
    State& state = filled();
    const gl::StateGuard guard(*state.binding, user);
    const DisplayTarget& shown = state.shownTarget(transform);
    return {"display",    shown.texture.name(),        GL_TEXTURE_2D, GL_RGBA8, shown.width,
            shown.height, "code values of the display"};
}

std::vector<Aov> Accumulator::aovs() const {
    const State& state = filled();
    std::vector<Aov> result;
    for (const AovSum& sum : state.aovSums) result.push_back(sum.mean(count()));
    return result;
}

std::vector<PassTime> Accumulator::passTimes() const {
    State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    std::vector<PassTime> times;
    for (const auto& [name, milliseconds] : state.timer.results()) times.push_back({name, milliseconds});
    return times;
}

AovFilter Accumulator::filterOf(const std::string& aov) const {
    const State& state = this->state();
    const auto found = std::ranges::find(state.options.aovs, aov);
    if (found == state.options.aovs.end())
        refuse("the AOV '" + aov + "' is not among those that the Accumulator holds");
    return state.filters[static_cast<std::size_t>(found - state.options.aovs.begin())];
}

const char* toString(AovFilter filter) {
    switch (filter) {
        case AovFilter::average:
            return "average";
        case AovFilter::first:
            return "first";
        default:
            return "auto";
    }
}

}  // namespace candela
