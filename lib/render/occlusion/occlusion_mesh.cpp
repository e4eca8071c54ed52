#include "render/occlusion/occlusion_mesh.h"

#include "base/error_context.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

// shaders/shared/alpha_cutout.h over GLM's vectors.
namespace shared {

using glm::uint;
using glm::vec2;
using std::floor;
using std::max;
using std::min;

using AlphaTexels = const AlphaImage&;

inline float alphaTexel(AlphaTexels image, int index) {
    return static_cast<float>(image.alpha[static_cast<std::size_t>(index)]) / 255.0f;
}

#define SHARED_FUNCTION inline
#include "shared/alpha_cutout.h"
#undef SHARED_FUNCTION

static_assert(ALPHA_REPEAT == uint(AlphaWrap::repeat) && ALPHA_CLAMP == uint(AlphaWrap::clampToEdge) &&
              ALPHA_MIRROR == uint(AlphaWrap::mirroredRepeat));

}  // namespace shared

}  // namespace

float transmittance(const OcclusionMesh& mesh, std::uint32_t cutout, const glm::vec3& weights) {
    const CutoutTriangle& triangle = mesh.cutouts[cutout];
    float alpha =
        weights.x * triangle.alpha[0] + weights.y * triangle.alpha[1] + weights.z * triangle.alpha[2];
    if (triangle.image != CutoutTriangle::noImage) {
        const AlphaImage& image = *mesh.images[triangle.image];
        const glm::vec2 uv =
            weights.x * triangle.uv[0] + weights.y * triangle.uv[1] + weights.z * triangle.uv[2];
        const shared::AlphaSampling sampling{static_cast<int>(image.width), static_cast<int>(image.height),
                                             static_cast<std::uint32_t>(triangle.wrapS),
                                             static_cast<std::uint32_t>(triangle.wrapT), triangle.nearest};
        alpha *= shared::sampleAlpha(image, sampling, uv);
    }
    return shared::alphaTransmittance(alpha, triangle.cutoff, triangle.blends, triangle.transmitted);
}

std::size_t OcclusionMesh::bytes() const {
    return positions.size() * sizeof(glm::vec3) + triangles.size() * sizeof(glm::uvec3) +
           cutouts.size() * sizeof(CutoutTriangle);
}

bool isInvertible(const glm::mat4& worldFromLocal) {
    if (!allFinite(worldFromLocal)) return false;
    return std::isfinite(1.0 / glm::determinant(glm::dmat3(worldFromLocal))) &&
           allFinite(glm::inverse(worldFromLocal));
}

}  // namespace candela
