#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// A function of one number, or of each channel of a colour, as a table of linear segments. A segment is
/// indexed by the bits of a floating-point number: no logarithm is needed to distribute them over octaves.
///
/// The domain is 0 to `curveEnd`; arguments beyond it are clamped. NaN gives the value of either end.
class CurveTable {
  public:
    /// A value of the function for each channel, of the same number.
    struct Values {
        float red, green, blue;
    };
    using Function = std::function<void(std::span<Values>)>;

    /// Samples `function`, which is given numbers in all channels and replaces them by its values.
    explicit CurveTable(const Function& function);

    /// The value at `x`, in the arithmetic of the GLSL function.
    float at(int channel, float x) const;

    /// Clamps the values to 0..1: for a table whose values are display codes.
    void clampToCodes();

    /// Whether one row of segments serves all channels.
    bool isShared() const { return rows_.size() == 1; }
    /// Appends the segments to `texels`, two floats each (value at the segment's start, slope), and returns
    /// the index of the first texel. Shared rows are appended once, others red, green, blue.
    int appendTo(std::vector<float>& texels) const;

    /// The number of texels of a row.
    static int rowLength();
    /// The GLSL function `float candelaCurve(int firstTexel, float x)` with its sampler `candelaCurves`.
    static std::string glsl();

  private:
    using Row = std::vector<float>;  ///< The values at the ends of the segments.
    std::vector<Row> rows_;
};

}  // namespace candela
