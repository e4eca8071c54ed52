#include "render/subdivision/edge_length.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

Sight sightOf(const CameraView& view, int width, int height) {
    const auto pixels = static_cast<float>(height);
    return {Frustum(view, static_cast<float>(width) / pixels), view.eye(), view.nearPlane,
            0.5f * pixels / std::tan(0.5f * view.verticalFov)};
}

std::optional<float> longestEdge(const Sight& sight, std::span<const glm::vec3> points,
                                 std::span<const CageEdge> edges) {
    std::optional<float> longest;
    for (const auto& [first, second] : edges) {
        const glm::vec3 &a = points[first], &b = points[second];
        const float length = glm::distance(a, b);
        const float nearest = std::min(glm::distance(a, sight.eye), glm::distance(b, sight.eye));
        const float pixels = length * sight.pixelsAtOneMetre / std::max(nearest, sight.nearPlane);
        if (longest && pixels <= *longest) continue;
        if (sight.frustum.meets(0.5f * (a + b), 0.5f * length)) longest = pixels;
    }
    return longest;
}

}  // namespace candela
