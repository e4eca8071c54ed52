#include "base/error_context.h"
#include "render/sampling/sample_sequence.h"

#include <candela/error.h>
#include <candela/sampling.h>

#include <cmath>
#include <numbers>
#include <string>

namespace candela {

namespace {

constexpr std::uint32_t maxBlades = 64;

void checkLens(const Lens& lens) {
    const ErrorContext element("lens");
    element.requirePositive("its f-number", lens.fNumber);
    element.requirePositive("its focus distance", lens.focusDistance);
    element.requirePositive("its sensor height", lens.sensorHeight);
    element.require(lens.blades == 0 || (lens.blades >= 3 && lens.blades <= maxBlades),
                    "it must have 0 blades (a round aperture) or 3 to 64");
}

void checkSample(const SamplingSettings& settings, std::uint32_t sample) {
    checkSampling(settings);
    if (sample < settings.count) return;
    throw Error(ErrorKind::badInput, "",
                "sample " + std::to_string(sample) + " is asked for of a picture of " +
                    std::to_string(settings.count) + " samples (counted from 0)");
}

/// Moves the eye to a point of the lens, and the picture so that it shows the same of the focus plane.
void moveOnLens(CameraView& view, const Lens& lens, double aspect, std::uint32_t sample) {
    const glm::dvec2 point =
        0.5 * apertureDiameter(lens, view.verticalFov) * aperturePoint(sample, lens.blades);
    const glm::dmat4 frame(view.worldFromCamera);
    view.worldFromCamera[3] = glm::vec4(frame[3] + point.x * frame[0] + point.y * frame[1]);
    const double height = 2.0 * std::tan(0.5 * view.verticalFov) * lens.focusDistance;
    const double ratio = view.aspect ? static_cast<double>(*view.aspect) : aspect;
    view.shift -= glm::vec2(point / (height * glm::dvec2(ratio, 1.0)));
}

}  // namespace

float apertureDiameter(const Lens& lens, float verticalFov) {
    checkLens(lens);
    if (!(verticalFov > 0.0f && verticalFov < std::numbers::pi_v<float>))
        throw Error(ErrorKind::badInput, "", "the field of view must lie between 0 and 180 degrees");
    return static_cast<float>(lens.sensorHeight / (2.0 * lens.fNumber * std::tan(0.5 * verticalFov)));
}

void checkSampling(const SamplingSettings& settings) {
    const ErrorContext element("sampling");
    element.require(settings.count >= 1 && settings.count <= maxSamples,
                    "its count of samples must be from 1 to 65536");
    if (settings.lens) checkLens(*settings.lens);
    element.require(settings.shutter >= 0.0 && settings.shutter <= 1.0,
                    "its shutter must be from 0 to 1 of a frame");
    element.require(settings.framesPerSecond > 0.0 && std::isfinite(settings.framesPerSecond),
                    "its frames per second must be finite and over 0");
}

CameraView sampleView(const CameraView& view, const SamplingSettings& settings, int width, int height,
                      std::uint32_t sample) {
    checkSample(settings, sample);
    if (width < 1 || height < 1)
        throw Error(ErrorKind::badInput, "", "a picture's width and height have to be 1 or more");
    if (settings.lens && view.orthographicHeight) {
        throw Error(ErrorKind::badInput, "",
                    "a lens is asked for of an orthographic view; only perspective ones have a lens");
    }
    CameraView moved = view;
    const glm::dvec2 offset = pixelOffset(sample) / glm::dvec2(width, height);
    moved.shift += glm::vec2(offset);
    if (settings.lens) moveOnLens(moved, *settings.lens, static_cast<double>(width) / height, sample);
    return moved;
}

double sampleTime(double seconds, const SamplingSettings& settings, std::uint32_t sample) {
    checkSample(settings, sample);
    if (!std::isfinite(seconds)) throw Error(ErrorKind::badInput, "", "the time must be a finite number");
    const double fromMiddle = sampleCoordinate(sample, SampleDimension::time) - 0.5;
    return seconds + fromMiddle * settings.shutter / settings.framesPerSecond;
}

}  // namespace candela
