// The crowd: each character has its own mesh and skeleton, stands where its root is at rest, and walks.
#include "procedural_scene.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace candela {
namespace {

Scene crowd(const std::string& count) {
    return importProcedural("crowd:" + count).scene;
}

std::vector<std::uint32_t> charactersOf(const Scene& scene) {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].skin) nodes.push_back(i);
    return nodes;
}

TEST(Crowd, HasTenThousandVerticesAndSixtyJointsEach) {
    const Scene scene = crowd("5");
    const std::vector<std::uint32_t> characters = charactersOf(scene);
    ASSERT_EQ(characters.size(), 5u);
    std::set<std::uint32_t> meshes;
    for (const std::uint32_t node : characters) {
        const Mesh& mesh = scene.meshes[*scene.nodes[node].mesh];
        EXPECT_EQ(mesh.positions.size(), 10'000u);
        EXPECT_EQ(mesh.influenceCount, 4u);
        EXPECT_EQ(scene.skins[*scene.nodes[node].skin].joints.size(), 60u);
        meshes.insert(*scene.nodes[node].mesh);
    }
    EXPECT_EQ(meshes.size(), 5u);
}

TEST(Crowd, NormalsPointOutOfTheTriangles) {
    const Scene scene = crowd("1");
    const Mesh& mesh = scene.meshes[*scene.nodes[charactersOf(scene)[0]].mesh];
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
                        &c = mesh.positions[mesh.indices[i + 2]];
        const glm::vec3 face = glm::cross(b - a, c - a);
        if (glm::length(face) < 1e-9f) continue;  // at the ends of a tube
        ASSERT_GT(glm::dot(face, mesh.normals[mesh.indices[i]]), 0.0f) << "triangle " << i / 3;
    }
}

TEST(Crowd, CharactersStandOnTheGroundAndMove) {
    const Scene scene = crowd("9");
    const std::vector<glm::mat4> rest = worldTransforms(scene), moved = worldTransforms(scene, 0.3);
    for (const std::uint32_t node : charactersOf(scene)) {
        const Bounds bounds = nodeBounds(scene, node, rest);
        EXPECT_NEAR(bounds.min.y, 0.0f, 0.25f) << "node " << node;
        EXPECT_NEAR(bounds.max.y, 1.8f, 0.2f) << "node " << node;
        EXPECT_NE(poseMesh(scene, node, rest).points, poseMesh(scene, node, moved, 0.3).points);
    }
}

TEST(Crowd, AllWalkInOneAnimation) {
    const Scene scene = crowd("5");
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].channels.size(), 5u * 60u);
}

TEST(Crowd, RefusesTooMany) {
    EXPECT_THROW(crowd("5000"), Error);
    EXPECT_THROW(crowd("many"), Error);
    EXPECT_NO_THROW(crowd("0"));
}

}  // namespace
}  // namespace candela
