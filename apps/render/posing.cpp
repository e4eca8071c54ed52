#include "posing.h"

#include "common/scene_lights.h"
#include "frame_writer.h"

#include <candela/exposure.h>

#include <algorithm>
#include <sstream>

namespace {

/// The size of a picture that is only measured: at most this many pixels wide and high.
constexpr int measuredPixels = 256;

candela::FrameSettings measuredSettings(const Options& options) {
    candela::FrameSettings settings = frameSettings(options);
    settings.debugView = candela::DebugView::none;
    settings.overlays = {};
    const int larger = std::max({settings.width, settings.height, measuredPixels});
    settings.width = std::max(1, settings.width * measuredPixels / larger);
    settings.height = std::max(1, settings.height * measuredPixels / larger);
    return settings;
}

/// A picture of each camera; on a turntable of each quarter.
std::vector<PlannedPicture> measuredPictures(const Options& options, const PicturePlan& plan) {
    constexpr int quarters = 4;
    std::vector<PlannedPicture> pictures;
    for (std::size_t camera = 0; camera < plan.cameras().size(); ++camera)
        for (int quarter = 0; quarter < (options.turntable ? quarters : 1); ++quarter)
            pictures.push_back({0, quarter * options.turntable.value_or(0) / quarters, camera, {}});
    return pictures;
}

}  // namespace

Lighting::Lighting(RunReport& report, const Options& options, const candela::Scene& scene,
                   candela::GpuScene& gpuScene)
    : options_(options),
      scene_(scene),
      gpuScene_(gpuScene),
      added_(usesDefaultLights(scene, options.defaultLights)) {
    if (added_ && options.defaultLights == DefaultLights::automatic) report.note(defaultLightsNote);
}

void Lighting::pose(double time, const candela::CameraView& view) {
    if (candela::isAnimated(scene_)) gpuScene_.setTime(time);
    if (!added_) return;
    // An EXR takes no exposure.
    const bool exposed = options_.format != PictureFormat::exr;
    gpuScene_.setLights(lightsWithDefaults(scene_, time, view, exposed ? options_.display.exposure : 0.0));
}

Samples::Samples(const Options& options, const candela::Scene& scene, Lighting& lighting,
                 const PicturePlan& plan, const PlannedPicture& picture)
    : options_(options),
      scene_(scene),
      lighting_(lighting),
      plan_(plan),
      picture_(picture),
      settings_(options.samplingSettings()),
      time_(plan.timeOf(picture.frame)) {}

candela::CameraView Samples::view(std::uint32_t sample) {
    const double time = poseTime(scene_, options_, candela::sampleTime(time_, settings_, sample));
    if (!posed_ || *posed_ != time) {
        view_ = plan_.view(picture_, time);
        lighting_.pose(time, view_);
        posed_ = time;
    }
    return view_;
}

std::optional<candela::CameraView> Samples::keepFrameBefore() {
    if (std::ranges::find(options_.aovs, "motion") == options_.aovs.end()) return std::nullopt;
    PlannedPicture before = picture_;
    --before.frame;
    // On a turntable the scene rests.
    const double earlier = options_.turntable ? time_ : time_ - 1.0 / options_.sampling.framesPerSecond;
    const double time = poseTime(scene_, options_, earlier);
    const candela::CameraView view = plan_.view(before, time);
    lighting_.pose(time, view);
    lighting_.keepPoses();
    return view;
}

double measureExposure(RunReport& report, const Options& options, candela::Renderer& renderer,
                       candela::GpuScene& gpuScene, Lighting& lighting, const PicturePlan& plan,
                       const std::vector<double>& times, const glm::vec3& luminanceWeights) {
    report.work("measuring the exposure");
    const candela::FrameSettings settings = measuredSettings(options);
    std::vector<candela::HdrImage> frames;
    for (const PlannedPicture& picture : measuredPictures(options, plan)) {
        for (const double time : times) {
            const candela::CameraView view = plan.view(picture, time);
            lighting.pose(time, view);
            frames.push_back(renderer.render(gpuScene, view, settings).radiance());
        }
    }
    const std::optional<double> exposure = candela::autoExposure(frames, luminanceWeights);
    std::ostringstream text;
    text << "--exposure auto is " << exposure.value_or(0.0) << (exposure ? " stops" : ": nothing is lit");
    report.note(text.str());
    return exposure.value_or(0.0);
}
