#include "frame_writer.h"

#include "picture_band.h"

#include <candela/panorama.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <utility>

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
      samples_(options.samplingSettings().count),
      parts_(candela::pictureParts(options.width, options.height, options.frameSize().width,
                                   options.frameSize().height)) {
    if (samples_ > 1)
        accumulator_.emplace(context, candela::AccumulatorOptions{options.aovs, options.aovFilter});
}

candela::FrameSettings FrameWriter::settings(const SampleSource& source) const {
    candela::FrameSettings settings = frameSettings(options_);
    settings.previousView = source.previousView;
    return settings;
}

void FrameWriter::drawSamples(const SampleSource& source, const Piece& piece, FrameTiming& timing) {
    accumulator_->reset();
    // On a GPU the times of a frame's passes are known when it has ended; only --stats is worth the wait.
    const bool timed = options_.stats.has_value();
    const std::uint32_t together = source.moves || (timed && !isSoftware_) ? 1 : samplesTogether;
    for (std::uint32_t first = 0; first < samples_; first += together) {
        const std::uint32_t end = std::min(first + together, samples_);
        const candela::CameraView view = source.viewOf(first);
        if (first == 0) view_ = view;
        frame_.emplace(accumulator_->addSamples(renderer_, scene_, piece.view.value_or(view), piece.settings,
                                                options_.samplingSettings(), first, end));
        if (timed) addPasses(frame_->passTimes(), timing.passes);
        if (timed && end < samples_) addPasses(accumulator_->passTimes(), timing.passes);
    }
    if (display_) pixels_ = accumulator_->displayPicture(*display_);
    addPasses(accumulator_->passTimes(), timing.passes);  // waits for the last frame to end
}

void FrameWriter::begin() {
    exposure_ = {};
    layerCounts_ = {};
    counters_ = {};
    panorama_.reset();
    panoramaAovs_.clear();
}

void FrameWriter::drawPiece(const SampleSource& source, const Piece& piece, FrameTiming& timing) {
    const auto start = std::chrono::steady_clock::now();
    if (accumulator_) {
        drawSamples(source, piece, timing);
    } else {
        view_ = source.viewOf(0);
        frame_.emplace(renderer_.render(scene_, piece.view.value_or(view_), piece.settings));
        if (display_) pixels_ = frame_->displayPicture(*display_);
        addPasses(frame_->passTimes(), timing.passes);  // waits for the frame to end
    }
    timing.milliseconds +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const candela::LayerCounts layers = frame_->layerCounts();
    layerCounts_.layers = std::max(layerCounts_.layers, layers.layers);
    layerCounts_.fragmentsBeyond += layers.fragmentsBeyond;
    if (isOfPieces() && options_.stats) addCounters();
}

void FrameWriter::addCounters() {
    const candela::PairCounts added = frame_->countPairs();
    candela::PairCounts& pairs = counters_.pairs;
    pairs.lightsVisible = std::max(pairs.lightsVisible, added.lightsVisible);
    pairs.lightListBytes = std::max(pairs.lightListBytes, added.lightListBytes);
    pairs.pairsLit += added.pairsLit;
    pairs.pairsEvaluated += added.pairsEvaluated;
    pairs.lightsDropped += added.lightsDropped;
    const candela::ShadowCounts before =
        counters_.shadows ? counters_.shadows->rays : candela::ShadowCounts{};
    // Debug views show no light.
    if (options_.debug.view != candela::DebugView::none) return;
    counters_.shadows = shadowStats(*frame_, scene_, options_.shadows);
    if (!counters_.shadows) return;
    candela::ShadowCounts& rays = counters_.shadows->rays;
    rays.raysAsked += before.raysAsked;
    rays.raysTraced += before.raysTraced;
    rays.raysSaved += before.raysSaved;
}

PictureCounters FrameWriter::counters() {
    if (!isOfPieces()) addCounters();
    return std::exchange(counters_, {});
}

FrameTiming FrameWriter::drawBands(const SampleSource& source, const BandSink& bands) {
    begin();
    FrameTiming timing;
    const candela::FrameSettings whole = settings(source);
    for (std::size_t first = 0; first < parts_.size();) {
        PictureBand band(options_.width, parts_[first]);
        std::size_t i = first;
        for (; i < parts_.size() && parts_[i].y == parts_[first].y; ++i) {
            drawPiece(source, {parts_[i].settings(whole), std::nullopt}, timing);
            exposure_ = sum(exposure_, countsOf(withoutMargins(parts_[i], radiance())));
            band.add(parts_[i], takePiece());
        }
        bands(band.take());
        first = i;
    }
    return timing;
}

void FrameWriter::drawPanorama(const SampleSource& source, FrameTiming& timing) {
    const candela::PanoramaFaces faces = candela::panoramaFaces(source.viewOf(0), options_.width);
    Piece piece{settings(source), std::nullopt};
    piece.settings.width = piece.settings.height = faces.size;
    std::array<candela::HdrImage, 6> pictures;
    std::array<std::vector<candela::Aov>, 6> aovs;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        piece.view = faces.views[i];
        drawPiece(source, piece, timing);
        pictures[i] = radiance();
        if (!options_.aovs.empty()) aovs[i] = frameAovs();
    }
    const auto start = std::chrono::steady_clock::now();
    panorama_ = candela::panorama(pictures, options_.width);
    panoramaAovs_ = candela::panoramaAovs(aovs, options_.width);
    if (display_) pixels_ = candela::displayPicture(*panorama_, *display_);
    timing.milliseconds +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

FrameTiming FrameWriter::draw(const SampleSource& source) {
    begin();
    FrameTiming timing;
    if (options_.panorama) {
        drawPanorama(source, timing);
    } else {
        drawPiece(source, {settings(source), std::nullopt}, timing);
    }
    return timing;
}

std::vector<candela::Aov> FrameWriter::frameAovs() const {
    return accumulator_ ? accumulator_->aovs() : frame_->aovs(options_.aovs);
}

candela::HdrImage FrameWriter::radiance() const {
    if (panorama_) return *panorama_;
    return accumulator_ ? accumulator_->radiance() : frame_->radiance();
}

candela::ExposureCounts FrameWriter::exposureCounts(const DrawnPicture& picture) const {
    if (isParted()) return exposure_;
    return countsOf(display_ ? radiance() : picture.radiance);
}

candela::ExposureCounts FrameWriter::countsOf(const candela::HdrImage& radiance) const {
    const glm::vec3 weights = color_.luminanceWeights();
    if (display_) return candela::countExposure(radiance, weights, display_->options().exposure);
    candela::ExposureCounts counts = candela::countExposure(radiance, weights, 0.0);
    counts.overBlack = counts.lit;
    counts.overWhite = 0;
    return counts;
}

void FrameWriter::takeRadiance(DrawnPicture& picture) const {
    picture.chromaticities = color_.chromaticities();
    picture.radiance = radiance();
    if (panorama_) {
        picture.aovs = panoramaAovs_;
    } else if (!options_.aovs.empty()) {
        picture.aovs = frameAovs();
    }
    if (!accumulator_) return;
    picture.attributes.push_back({"samples", std::to_string(samples_)});
    for (const std::string& aov : options_.aovs)
        picture.attributes.push_back({"filter." + aov, candela::toString(accumulator_->filterOf(aov))});
}

DrawnPicture FrameWriter::take() {
    DrawnPicture picture = takePiece();
    picture.width = options_.width;
    picture.height = options_.height;
    return picture;
}

DrawnPicture FrameWriter::takePiece() {
    DrawnPicture picture;
    picture.width = frame_->width();
    picture.height = frame_->height();
    if (display_) {
        picture.encoding = display_->encoding();
        picture.rgba = std::move(pixels_);
    } else {
        takeRadiance(picture);
    }
    return picture;
}
