// What `validate` demands of skins and morph targets of meshes; tests of cages hold what both have in common.

#include <candela/scene.h>

#include "validate/broken_rule.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

/// A triangle with two joints a vertex and two morph targets, and its skin of nodes 1 and 2.
Scene deformedScene() {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = "arm";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    mesh.influenceCount = 2;
    mesh.joints = {0, 1, 0, 1, 0, 1};
    mesh.jointWeights = {1, 0, 0.5f, 0.5f, 0, 1};
    mesh.morphTargets.resize(2);
    for (MorphTarget& target : mesh.morphTargets) target.offsets.assign(3, {0, 0, 1});
    mesh.morphTargets[0].normalOffsets.assign(3, {1, 0, 0});
    scene.skins.push_back({"bones", {1, 2}, {2, glm::mat4(1.0f)}});
    scene.nodes.resize(3);
    scene.nodes[0].name = "body";
    scene.nodes[0].mesh = 0;
    scene.nodes[0].skin = 0;
    scene.nodes[0].morphWeights = {0.5f, -1.0f};
    return scene;
}

TEST(ValidateDeformation, AcceptsValidScenes) {
    EXPECT_NO_THROW(validate(deformedScene()));
    Scene scene = deformedScene();
    scene.nodes[0].skin.reset();
    scene.nodes[0].morphWeights.clear();
    EXPECT_NO_THROW(validate(scene));
}

TEST(ValidateDeformation, Meshes) {
    expectMessages(
        deformedScene(),
        {{"mesh 0 'arm': has 5 joints for 6 influences", [](Scene& s) { s.meshes[0].joints.pop_back(); }},
         {"mesh 0 'arm': the joint weights of vertex 1 have the sum 1.25, but 1 was expected",
          [](Scene& s) { s.meshes[0].jointWeights[2] = 0.75f; }},
         {"mesh 0 'arm': a joint weight of vertex 0 is not 0 or more",
          [](Scene& s) { s.meshes[0].jointWeights[1] = std::numeric_limits<float>::quiet_NaN(); }},
         {"mesh 0 'arm': has 2 offsets in morph target 1 for 3 vertices",
          [](Scene& s) { s.meshes[0].morphTargets[1].offsets.pop_back(); }},
         {"mesh 0 'arm': has 1 normal offsets in morph target 0 for 3 vertices",
          [](Scene& s) { s.meshes[0].morphTargets[0].normalOffsets.resize(1); }},
         {"mesh 0 'arm': morph target 0: tangent offset 0 is not a finite number", [](Scene& s) {
              s.meshes[0].morphTargets[0].tangentOffsets.assign(
                  3, glm::vec3(std::numeric_limits<float>::infinity()));
          }}});
}

TEST(ValidateDeformation, Nodes) {
    expectMessages(deformedScene(),
                   {{"node 0 'body': refers to skin 1, but the scene has 1 (counted from 0)",
                     [](Scene& s) { s.nodes[0].skin = 1; }},
                    {"node 0 'body': its mesh names joint 2, but its skin has 2",
                     [](Scene& s) { s.meshes[0].joints[1] = 2; }},
                    {"node 1: has a skin, but no joint moves a vertex of its mesh or its cage",
                     [](Scene& s) { s.nodes[1].skin = 0; }},
                    {"node 0 'body': has 1 morph weights, but its mesh has 2 morph targets",
                     [](Scene& s) { s.nodes[0].morphWeights.pop_back(); }},
                    {"node 1: has morph weights, but its mesh and its cage have no morph targets",
                     [](Scene& s) { s.nodes[1].morphWeights = {1.0f}; }},
                    {"node 0 'body': morph weight 1 must be a finite number of at most 1e9",
                     [](Scene& s) { s.nodes[0].morphWeights[1] = 2e9f; }},
                    {"node 0 'body': mesh 0 'arm' is farther than 1e9 metres from the world's origin, or its "
                     "position is not finite",
                     [](Scene& s) {
                         s.nodes[1].transform = Transform{{2e9f, 0, 0}};
                     }}});
}

TEST(ValidateDeformation, TheNodeOfASkinnedMeshMayStandAnywhere) {
    Scene scene = deformedScene();
    scene.nodes[0].transform = Transform{{2e9f, 0, 0}};
    EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace candela
