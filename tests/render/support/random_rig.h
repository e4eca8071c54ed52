#pragma once

#include <candela/scene.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace candela::test {

/// What a random rig has at most.
struct RigSize {
    std::uint32_t vertices = 300, joints = 40, influences = 8, targets = 4;
    bool tangents = true;
};

/// A scene with one skinned mesh, on node 0, and its skeleton: a random tree of joints with rotations,
/// non-uniform scales and mirroring, and random bind matrices. All is within some metres of `center`.
Scene randomRig(std::uint32_t seed, const RigSize& size, const glm::vec3& center = glm::vec3(0.0f));

/// A pose of such a rig: other transforms of all joints, and other morph weights.
void poseRandomly(Scene& scene, std::uint32_t seed, const glm::vec3& center = glm::vec3(0.0f));

/// Positions, normals and tangents of a deformed mesh.
struct DeformedVertices {
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec4> tangents;
};

/// The mesh of node `node` in world space, in double precision by the formulas of glTF 2.0, 3.7.2.2 and
/// 3.7.3.3: morph targets, then the blended matrix for positions and tangents and its inverse transpose for
/// normals. The node's morph weights are its own; `world` are the matrices of the joints.
DeformedVertices evaluateDeformation(const Scene& scene, std::uint32_t node,
                                     std::span<const glm::mat4> world);

/// That the vertices are those of `evaluateDeformation`, within what single precision rounds.
void expectDeformed(const DeformedVertices& vertices, const Scene& scene, std::uint32_t node,
                    std::span<const glm::mat4> world);

}  // namespace candela::test
