#include "support/cage_scenes.h"

#include "support/procedural_scene.h"

#include <candela/plugin_registry.h>

#include <algorithm>
#include <utility>

namespace candela::test {

const Subdivider& subdivider() {
    static const PluginRegistry registry({CANDELA_TEST_PLUGINS});
    static const Subdivider found = registry.subdivider().value();
    return found;
}

Cage makeCubeCage(float halfSize) {
    Cage cage;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1) != 0 ? 1.0f : -1.0f, (i & 2) != 0 ? 1.0f : -1.0f,
                               (i & 4) != 0 ? 1.0f : -1.0f);
        cage.positions.push_back(halfSize * corner);
    }
    cage.faceSizes.assign(6, 4);
    cage.faceVertices = {4, 5, 7, 6, 1, 0, 2, 3, 5, 1, 3, 7, 0, 4, 6, 2, 6, 7, 3, 2, 0, 1, 5, 4};
    for (std::uint32_t corner = 0; corner < 24; ++corner) {
        const std::uint32_t i = corner % 4;
        cage.uvs.emplace_back(i == 1 || i == 2 ? 1.0f : 0.0f, i < 2 ? 1.0f : 0.0f);
        cage.faceUvs.push_back(corner);
    }
    return cage;
}

Cage makeSharpCubeCage(float halfSize) {
    Cage cage = makeCubeCage(halfSize);
    for (std::uint32_t a = 0; a < 8; ++a) {
        for (const std::uint32_t axis : {1u, 2u, 4u}) {
            if ((a & axis) == 0) cage.creases.push_back({a, a | axis, infiniteSharpness});
        }
    }
    return cage;
}

Cage makeSheetCage(float halfSize, std::uint32_t cells) {
    Cage cage;
    const std::uint32_t side = cells + 1;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const glm::vec2 at = glm::vec2(x, y) / static_cast<float>(cells);
            cage.positions.emplace_back(halfSize * (2.0f * at - 1.0f), 0.0f);
            cage.uvs.emplace_back(at.x, 1.0f - at.y);
        }
    }
    for (std::uint32_t y = 0; y < cells; ++y) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t a = y * side + x;
            cage.faceSizes.push_back(4);
            cage.faceVertices.insert(cage.faceVertices.end(), {a, a + 1, a + side + 1, a + side});
        }
    }
    cage.faceUvs = cage.faceVertices;
    return cage;
}

std::vector<glm::vec3> jittered(const std::vector<glm::vec3>& points, float distance, std::uint32_t seed) {
    std::vector<glm::vec3> moved = points;
    for (std::uint32_t i = 0; i < moved.size(); ++i) {
        const glm::vec3 random(hashed(seed, i), hashed(seed + 1, i), hashed(seed + 2, i));
        moved[i] += distance * (2.0f * random - 1.0f);
    }
    return moved;
}

std::uint32_t placeCage(Scene& scene, Cage cage, const Material& material, const glm::mat4& transform) {
    cage.faceMaterials.assign(cage.faceSizes.size(), static_cast<std::uint32_t>(scene.materials.size()));
    Node node;
    node.cage = static_cast<std::uint32_t>(scene.cages.size());
    node.transform = transform;
    scene.materials.push_back(material);
    scene.cages.push_back(std::move(cage));
    scene.nodes.push_back(node);
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

Scene sceneOfCage(Cage cage, const Material& material, const glm::mat4& transform) {
    Scene scene;
    placeCage(scene, std::move(cage), material, transform);
    return scene;
}

GpuSceneOptions subdividing(std::optional<std::uint32_t> level) {
    GpuSceneOptions options;
    options.subdivider = subdivider();
    options.subdivision.level = level;
    return options;
}

DrawnVertices drawnVertices(GpuScene& scene, std::uint32_t index) {
    const GpuCages& cages = scene.state().cages;
    const LimitSurface& limit = cages.surface(cages.instances()[index].surface);
    DrawnVertices vertices;
    vertices.positions.resize(limit.vertexCount());
    vertices.normals.resize(limit.vertexCount());
    const auto bytes = static_cast<GLsizeiptr>(limit.vertexCount() * sizeof(glm::vec3));
    const GLuint surface = limit.buffers().surface.name();
    glGetNamedBufferSubData(surface, 0, bytes, vertices.positions.data());
    glGetNamedBufferSubData(surface, bytes, bytes, vertices.normals.data());
    return vertices;
}

}  // namespace candela::test
