#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// A function of one number, or of each channel of a colour, as a table of straight pieces that are found by
/// the bits of a floating-point number: no logarithm is needed to spread them evenly over the octaves.
///
/// The table reaches from 0 to `end`; below and above it keeps the values of its ends. NaN gives either.
class CurveTable {
  public:
    static constexpr float end = 131072.0f;  ///< Twice the largest radiance.

    /// A value of the function for each channel, of the same number.
    struct Values {
        float red, green, blue;
    };
    using Function = std::function<void(std::span<Values>)>;

    /// Samples `function`, which is given numbers in all channels and replaces them by its values.
    explicit CurveTable(const Function& function);

    /// What GLSL makes of `x`, in the same arithmetic.
    float at(int channel, float x) const;

    /// Limits the values to 0..1: for a table whose values are a display's codes.
    void limitToCodes();

    /// Whether one row of pieces serves all channels.
    bool isShared() const { return rows_.size() == 1; }
    /// Appends the pieces to `texels`, two floats each (value at the piece's start, slope), and returns the
    /// index of the first texel. Shared rows are appended once, others red, green, blue.
    int appendTo(std::vector<float>& texels) const;

    /// Texels a row takes.
    static int rowLength();
    /// The GLSL function `float candelaCurve(int firstTexel, float x)` with its sampler `candelaCurves`.
    static std::string glsl();

  private:
    using Row = std::vector<float>;  ///< The values at the ends of the pieces.
    std::vector<Row> rows_;
};

}  // namespace candela
