#pragma once

#include "render/occlusion/gpu_occlusion.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace candela::test {

struct Ray {
    glm::vec3 from;
    float tMin;
    glm::vec3 way;
    float tMax;
};

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float number() { return uniform_(engine_); }
    glm::vec3 vector() { return {number(), number(), number()}; }

  private:
    std::mt19937 engine_;
    std::uniform_real_distribution<float> uniform_{-1.0f, 1.0f};
};

inline void addTriangle(OcclusionMesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
}

inline OcclusionMesh soup(Random& random, int count, float extent, float size) {
    OcclusionMesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = extent * random.vector();
        addTriangle(mesh, center + size * random.vector(), center + size * random.vector(),
                    center + size * random.vector());
    }
    return mesh;
}

/// A closed sphere whose triangles share vertices.
inline OcclusionMesh sphere(float radius, unsigned columns, unsigned rows) {
    OcclusionMesh mesh;
    for (unsigned row = 0; row <= rows; ++row) {
        for (unsigned column = 0; column < columns; ++column) {
            const double polar = std::acos(-1.0) * row / rows,
                         angle = 2.0 * std::acos(-1.0) * column / columns;
            const double ring = row == 0 || row == rows ? 0.0 : std::sin(polar);
            mesh.positions.push_back(
                radius * glm::vec3(ring * std::cos(angle), std::cos(polar), ring * std::sin(angle)));
        }
    }
    for (unsigned row = 0; row < rows; ++row) {
        for (unsigned column = 0; column < columns; ++column) {
            const unsigned next = (column + 1) % columns, a = row * columns, b = a + columns;
            mesh.triangles.push_back({a + column, a + next, b + column});
            mesh.triangles.push_back({a + next, b + next, b + column});
        }
    }
    return mesh;
}

/// A wall in x and y, `thickness` thick, of cells of two triangles; both sides.
inline OcclusionMesh wall(float half, unsigned cells, float thickness) {
    OcclusionMesh mesh;
    for (unsigned sideOfWall = 0; sideOfWall < 2; ++sideOfWall) {
        const auto first = static_cast<unsigned>(mesh.positions.size());
        for (unsigned y = 0; y <= cells; ++y) {
            for (unsigned x = 0; x <= cells; ++x) {
                const glm::vec2 p = half * (2.0f * glm::vec2(x, y) / float(cells) - 1.0f);
                mesh.positions.emplace_back(p, sideOfWall == 0 ? 0.0f : thickness);
            }
        }
        for (unsigned y = 0; y < cells; ++y) {
            for (unsigned x = 0; x < cells; ++x) {
                const unsigned a = first + y * (cells + 1) + x, b = a + cells + 1;
                mesh.triangles.push_back({a, a + 1, b});
                mesh.triangles.push_back({a + 1, b + 1, b});
            }
        }
    }
    return mesh;
}

struct TestScene {
    std::vector<OcclusionMesh> meshes;
    std::vector<OcclusionInstance> instances;

    std::vector<Bounds> boxes() const {
        std::vector<Bounds> result;
        for (const OcclusionInstance& instance : instances) {
            Bounds box;
            if (instance.castsShadow) {
                for (const glm::vec3& local : meshes[instance.mesh].positions) {
                    const glm::vec3 p(instance.worldFromLocal * glm::vec4(local, 1.0f));
                    box.add({p, p});
                }
            }
            result.push_back(box);
        }
        return result;
    }
};

inline TriangleSpan trianglesOf(const OcclusionMesh& mesh) {
    return {mesh.positions, mesh.triangles};
}

/// `tree` is the one of the scene before, or an empty one.
inline void setInstances(GpuOcclusion& structure, const TestScene& scene, InstanceTree& tree) {
    std::vector<InstanceTree::Change> boxes;
    for (const Bounds& box : scene.boxes()) boxes.push_back({static_cast<std::uint32_t>(boxes.size()), box});
    tree.update(boxes);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) structure.setInstance(i, scene.instances[i]);
    structure.setTree(tree.nodes(), tree.depth(), tree.takeChanges());
}

inline void setInstances(GpuOcclusion& structure, const TestScene& scene) {
    InstanceTree tree;
    setInstances(structure, scene, tree);
}

inline void upload(GpuOcclusion& structure, const TestScene& scene) {
    for (std::uint32_t i = 0; i < scene.meshes.size(); ++i)
        structure.setMesh(i, scene.meshes[i], buildWideTree(trianglesOf(scene.meshes[i])));
    setInstances(structure, scene);
}

inline glm::mat4 randomRotation(Random& random) {
    return glm::rotate(glm::mat4(1.0f), 3.0f * random.number(), glm::normalize(random.vector() + 0.01f));
}

/// Instances of the scales 1e-3, 1 and 1e3, mirrored and skewed, all 1 to 3 m large in the world.
inline TestScene mixedScene(unsigned seed) {
    Random random(seed);
    TestScene scene;
    for (const float unit : {1000.0f, 1.0f, 0.001f}) {
        scene.meshes.push_back(soup(random, 120, unit, 0.4f * unit));
        scene.meshes.push_back(sphere(unit, 12, 7));
        scene.meshes.push_back(wall(unit, 4, 0.001f * unit));
    }
    for (std::uint32_t i = 0; i < 45; ++i) {
        const std::uint32_t mesh = i % 9;
        const float scale = mesh < 3 ? 0.001f : mesh < 6 ? 1.0f : 1000.0f;
        glm::mat4 shape = glm::scale(randomRotation(random), glm::vec3(scale));
        if (i % 2 == 0) shape = glm::scale(shape, {-1.0f, 1.5f, 0.7f});
        if (i % 5 == 0) shape[0] += 0.8f * shape[1];
        scene.instances.push_back(
            {mesh, glm::translate(glm::mat4(1.0f), 8.0f * random.vector()) * shape, true});
    }
    return scene;
}

inline std::vector<Ray> randomRays(unsigned seed, std::size_t count, float extent) {
    Random random(seed);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 from = extent * random.vector(), to = extent * random.vector();
        Ray ray{from, 1e-4f, to - from, 1.0f};
        // Along an axis or a plane of two axes.
        if (i % 7 == 0) ray.way[static_cast<int>(i / 7) % 3] = 0.0f;
        if (i % 21 == 0) ray.way[(static_cast<int>(i / 7) + 1) % 3] = 0.0f;
        if (i % 5 == 0) ray.tMax = 1e30f;
        rays.push_back(ray);
    }
    return rays;
}

}  // namespace candela::test
