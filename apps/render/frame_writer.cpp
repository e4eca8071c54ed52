#include "frame_writer.h"

#include "common/output_file.h"

#include <algorithm>
#include <chrono>
#include <string>

candela::FrameSettings frameSettings(const Options& options) {
    candela::FrameSettings settings;
    settings.width = options.width;
    settings.height = options.height;
    settings.brdf = options.brdf;
    settings.technique = options.technique;
    settings.tileBackend = options.tileBackend;
    settings.shadows = options.shadows;
    settings.specularAntialiasing = options.specularAntialiasing;
    settings.layers = options.layers;
    settings.environmentOcclusion.rays = options.environmentRays;
    settings.pointSize = options.pointSize;
    settings.lineWidth = options.lineWidth;
    settings.debugView = options.debug.view;
    settings.overlays = options.debug.overlays;
    settings.ambientOcclusion = options.ambientOcclusion;
    return settings;
}

namespace {

/// Samples that are drawn in one call, after which the progress is shown.
constexpr std::uint32_t samplesTogether = 16;

/// Adds the times of passes to those of the same name.
void addPasses(const std::vector<candela::PassTime>& added, std::vector<candela::PassTime>& sums) {
    for (const candela::PassTime& pass : added) {
        const auto sum = std::ranges::find(sums, pass.name, &candela::PassTime::name);
        if (sum == sums.end())
            sums.push_back(pass);
        else
            sum->milliseconds += pass.milliseconds;
    }
}

}  // namespace

FrameWriter::FrameWriter(const candela::Context& context, candela::Renderer& renderer,
                         candela::GpuScene& scene, const candela::ColorConfig& color,
                         const std::optional<candela::DisplayTransform>& display, const Options& options)
    : renderer_(renderer),
      scene_(scene),
      color_(color),
      display_(display),
      options_(options),
      isSoftware_(context.isSoftware()),
      samples_(options.samplingSettings().count) {
    if (samples_ > 1)
        accumulator_.emplace(context, candela::AccumulatorOptions{options.aovs, options.aovFilter});
}

void FrameWriter::drawSamples(const SampleSource& source, FrameTiming& timing) {
    accumulator_->reset();
    // On a GPU the times of a frame's passes are known when it has ended; only --stats is worth the wait.
    const bool timed = options_.stats.has_value();
    const std::uint32_t together = source.moves || (timed && !isSoftware_) ? 1 : samplesTogether;
    for (std::uint32_t first = 0; first < samples_; first += together) {
        const std::uint32_t end = std::min(first + together, samples_);
        frame_.emplace(accumulator_->addSamples(renderer_, scene_, source.viewOf(first),
                                                frameSettings(options_), options_.samplingSettings(), first,
                                                end));
        if (timed) addPasses(frame_->passTimes(), timing.passes);
        if (timed && end < samples_) addPasses(accumulator_->passTimes(), timing.passes);
    }
    if (display_) pixels_ = accumulator_->displayPicture(*display_);
    addPasses(accumulator_->passTimes(), timing.passes);  // waits for the last frame to end
}

FrameTiming FrameWriter::draw(const SampleSource& source) {
    const auto start = std::chrono::steady_clock::now();
    FrameTiming timing;
    if (accumulator_) {
        drawSamples(source, timing);
    } else {
        frame_.emplace(renderer_.render(scene_, source.viewOf(0), frameSettings(options_)));
        if (display_) pixels_ = frame_->displayPicture(*display_);
        timing.passes = frame_->passTimes();  // waits for the frame to end
    }
    timing.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return timing;
}

candela::HdrImage FrameWriter::radiance() const {
    return accumulator_ ? accumulator_->radiance() : frame_->radiance();
}

candela::ExposureCounts FrameWriter::exposureCounts() const {
    candela::ExposureCounts counts = candela::countExposure(radiance(), color_.luminanceWeights(),
                                                            display_ ? display_->options().exposure : 0.0);
    if (display_) return counts;
    counts.overBlack = counts.lit;
    counts.overWhite = 0;
    return counts;
}

void FrameWriter::writeExr(const std::filesystem::path& path) const {
    if (!accumulator_) {
        std::vector<candela::Aov> aovs;
        if (!options_.aovs.empty()) aovs = frame_->aovs(options_.aovs);
        return writeRadiance(path, frame_->radiance(), aovs, color_);
    }
    std::vector<candela::ExrAttribute> attributes{{"samples", std::to_string(samples_)}};
    for (const std::string& aov : options_.aovs)
        attributes.push_back({"filter." + aov, candela::toString(accumulator_->filterOf(aov))});
    writeRadiance(path, accumulator_->radiance(), accumulator_->aovs(), color_, attributes);
}

void FrameWriter::write(const std::filesystem::path& path) {
    if (display_)
        writeDisplayedFrame(path, options_.width, options_.height, pixels_, *display_);
    else
        writeExr(path);
}
