#include "render/lighting/volumes/sphere_proxy.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace candela {

namespace {

SphereProxy icosahedron() {
    constexpr float a = 0.525731f,
                    b = 0.850651f;  // sides of the golden rectangle whose corners are on the unit sphere
    return {{{-a, b, 0},
             {a, b, 0},
             {-a, -b, 0},
             {a, -b, 0},
             {0, -a, b},
             {0, a, b},
             {0, -a, -b},
             {0, a, -b},
             {b, 0, -a},
             {b, 0, a},
             {-b, 0, -a},
             {-b, 0, a}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// The distance of the nearest face from the origin.
float innerRadius(const SphereProxy& proxy) {
    float least = 1.0f;
    for (const auto& [i, j, k] : proxy.triangles) {
        const glm::vec3 &p = proxy.vertices[i], &q = proxy.vertices[j], &r = proxy.vertices[k];
        least = std::min(least, glm::dot(glm::normalize(glm::cross(q - p, r - p)), p));
    }
    return least;
}

}  // namespace

SphereProxy makeSphereProxy() {
    SphereProxy proxy = icosahedron();
    // A little more than needed, against the rounding of vertices in the shader.
    const float scale = 1.0001f / innerRadius(proxy);
    for (glm::vec3& vertex : proxy.vertices) vertex *= scale;
    proxy.radius = scale;
    return proxy;
}

}  // namespace candela
