#pragma once

#include <candela/color.h>

#include <string>
#include <vector>

namespace candela {

/// A look-up texture that a display transform's shader samples, clamped to its edges.
struct LookupTexture {
    enum class Filter { nearest, linear };
    std::string sampler;  ///< Name of the sampler uniform in the shader's text.
    int dimensions = 2;   ///< 1, 2 or 3: sampler1D, sampler2D, sampler3D.
    int width = 1, height = 1, depth = 1;
    int channels = 3;  ///< 1 (red) or 3 (RGB).
    Filter filter = Filter::linear;
    std::vector<float>
        values;  ///< width × height × depth × channels, x fastest; to be kept in 32-bit floats.
};

/// A display transform as GLSL (4.0 and later): a function `vec4 displayTransform(vec4 radiance)` that takes
/// exposed working-space colour to code values 0..1 and does not change alpha, with the samplers it needs.
/// Exposure is not in it: the display pass multiplies by 2^exposure before the call. How it treats NaN and
/// infinity is documented in color/display_transform.h. Other names in the text begin with `ocio`, `candela`
/// or `sanitized`.
struct DisplayShader {
    std::string glsl;
    std::vector<LookupTexture> textures;
    /// Values of the `samplerBuffer candelaCurves`, two floats (RG32F) a texel; empty where there is none.
    std::vector<float> curves;
};

/// The shader of a transform. Created once per transform, on the first call, from any thread; the reference
/// lives as long as the transform. Throws `Error` (unsupported) when the transform needs what a shader cannot
/// be given.
const DisplayShader& displayShader(const DisplayTransform& transform);

/// The same transform with its curves baked into tables (see color/baked_transform.h and docs/color.md), or
/// null where fewer than two curves can be baked or the error exceeds a quarter of an 8-bit code. Created
/// once per transform, as `displayShader`. Whether it is faster depends on the device.
const DisplayShader* bakedDisplayShader(const DisplayTransform& transform);

}  // namespace candela
