#pragma once

#include <candela/camera.h>
#include <candela/export.h>

#include <cstdint>
#include <optional>

namespace candela {

/// Pictures of many samples: frames drawn from slightly different views at slightly different times, whose
/// mean is the picture (`Accumulator`). docs/sampling.md derives all of it.

/// The largest number of samples of a picture.
inline constexpr std::uint32_t maxSamples = 65536;

/// What a coordinate of a sample is for.
enum class SampleDimension : std::uint32_t {
    pixelX,  ///< Offset within the pixel's filter.
    pixelY,
    lensX,  ///< Point on the lens.
    lensY,
    time,    ///< Time within the shutter interval.
    lightX,  ///< Point within each light's sphere.
    lightY,
    lightZ,
};

/// A coordinate of sample `sample`, 0 or more and under 1: a multiple of 2^-32, the same on every machine.
/// Sample 0 is 0.5 in every dimension, and each aligned power of two of consecutive samples is stratified:
/// the Sobol sequence, scrambled after Owen by a hash (Burley, "Practical hash-based Owen scrambling", 2020).
/// `stream` selects one of many sequences of the light's dimensions; the others ignore it.
CANDELA_API double sampleCoordinate(std::uint32_t sample, SampleDimension dimension,
                                    std::uint32_t stream = 0);

/// A thin lens: what is at the focus distance is sharp.
struct Lens {
    float fNumber = 2.8f;        ///< Over 0 and finite.
    float focusDistance = 1.0f;  ///< Metres along the view axis, over 0 and finite.
    std::uint32_t blades = 0;  ///< 0: a round aperture; 3 to 64: a regular polygon with a corner at the top.
    float sensorHeight = 0.024f;  ///< Metres, over 0 and finite; default: 24 mm, full frame.
};

/// The diameter of the lens's aperture, metres: its focal length over its f-number, where the focal length
/// follows from the sensor and the field of view: sensorHeight / (2 fNumber tan(verticalFov / 2)). Of an
/// aperture with blades it is the diameter of the circle through the corners. Throws `Error` (badInput) when
/// a number is not in the range that it states.
CANDELA_API float apertureDiameter(const Lens& lens, float verticalFov);

/// How the samples of a picture are distributed.
struct SamplingSettings {
    std::uint32_t count = 16;       ///< Samples a pixel, 1 to `maxSamples`.
    std::optional<Lens> lens = {};  ///< None: a pinhole. Views have to be perspective ones.
    double shutter = 0.0;           ///< How long it is open, as a share of a frame: 0 (an instant) to 1.
    double framesPerSecond = 24.0;  ///< Over 0 and finite.
};

/// Throws `Error` (badInput) when a setting is not in the range that it states.
CANDELA_API void checkSampling(const SamplingSettings& settings);

/// The view of sample `sample` of a picture of `width` × `height` pixels that is seen from `view`: moved by
/// less than a pixel (`CameraView::shift`), distributed as a Blackman-Harris kernel 1.5 pixels wide, and to
/// a point of the lens, around which the plane at the focus distance stays where it is. Sample 0 of a
/// pinhole and of a lens is `view`. Throws `Error` (badInput) when a setting is not in the range that it
/// states, `sample` is not below the count, a side is not 1 or more, or there is a lens and `view` is
/// orthographic.
CANDELA_API CameraView sampleView(const CameraView& view, const SamplingSettings& settings, int width,
                                  int height, std::uint32_t sample);

/// The time of sample `sample` of a picture at `seconds`, which is the middle of the shutter interval; that
/// of sample 0 is `seconds`. Throws `Error` (badInput) as `sampleView` does, and when `seconds` is not
/// finite.
CANDELA_API double sampleTime(double seconds, const SamplingSettings& settings, std::uint32_t sample);

}  // namespace candela
