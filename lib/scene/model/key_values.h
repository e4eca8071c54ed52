#pragma once

#include <candela/animation.h>

#include <cstddef>
#include <span>

namespace candela {

/// Where a time falls among keys.
struct Moment {
    std::size_t key = 0;
    double t = 0.0;         ///< From 0 at the key to 1 at the next one.
    double duration = 0.0;  ///< Seconds from the key to the next one; 0: the value of the key.
};

/// The keys of a channel, and what lies between them (glTF 2.0, appendix C). There is at least one key, and
/// the keys have as many numbers as they require.
struct KeyValues {
    /// Which of a key's values; a cubic spline has three, the others one.
    enum class Part { inTangent, value, outTangent };

    Interpolation interpolation = Interpolation::linear;
    std::span<const float> times, values;

    std::size_t numbersPerValue() const;
    /// The numbers of a key's value.
    const float* value(std::size_t key, Part part = Part::value) const;
    Moment momentAt(double time) const;
    /// Number `index` of the value, interpolated on its own.
    double numberAt(std::size_t index, const Moment& moment) const;

  private:
    double number(std::size_t index, std::size_t key, Part part = Part::value) const;
    double cubicSpline(std::size_t index, const Moment& moment) const;
};

}  // namespace candela
