#pragma once

#include "shading/directional_albedo.h"

namespace candela {

/// E and W of `LobeAlbedo` of a specular lobe with two alphas, which has no table: the means over 64
/// reflections of `v`, with the biases of shaders/shared/shading_constants.h. `v` is in the frame of tangent,
/// bitangent and normal, with v.z over 0. `maskingRoughness` is that of the masking of `course`.
LobeAlbedo anisotropicAlbedo(BrdfModel model, const glm::dvec3& v, double tangentAlpha, double bitangentAlpha,
                             double maskingRoughness);

}  // namespace candela
