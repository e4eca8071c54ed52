#include "support/random_rig.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace candela::test {

namespace {

double sizeOf(const glm::dmat4& m) {
    return std::sqrt(glm::dot(glm::dvec3(m[0]), glm::dvec3(m[0])) +
                     glm::dot(glm::dvec3(m[1]), glm::dvec3(m[1])) +
                     glm::dot(glm::dvec3(m[2]), glm::dvec3(m[2])));
}

/// A vertex after its morph targets, the matrix that moves it, and the sizes of what was summed.
struct Vertex {
    glm::dvec3 position, normal, tangent;
    double side = 0.0;
    glm::dmat4 matrix{0.0};
    double reach = 0.0;        ///< Of the position's terms.
    double normalReach = 0.0;  ///< Of the normal's.
    double tangentReach = 0.0;
    double stretch = 0.0;  ///< Of the linear parts' terms.
    double shift = 0.0;    ///< Of the translations' terms.
};

class Evaluation {
  public:
    Evaluation(const Scene& scene, std::uint32_t node, std::span<const glm::mat4> world)
        : node_(scene.nodes[node]), mesh_(scene.meshes[*node_.mesh]) {
        if (!node_.skin) {
            joints_.assign(1, glm::dmat4(world[node]));
            return;
        }
        const Skin& skin = scene.skins[*node_.skin];
        // The first joint is the origin, as the renderer has it: rounding then does not depend on the
        // distance to the world's origin.
        origin_ = glm::dvec3(world[skin.joints.front()][3]);
        for (std::size_t i = 0; i < skin.joints.size(); ++i) {
            glm::dmat4 joint(world[skin.joints[i]]);
            joint[3] -= glm::dvec4(origin_, 0.0);
            joints_.push_back(joint * glm::dmat4(skin.inverseBindMatrices[i]));
        }
    }

    const glm::dvec3& origin() const { return origin_; }

    Vertex at(std::size_t index) const {
        Vertex vertex;
        morph(index, vertex);
        if (!node_.skin) {
            blend(1.0, joints_[0], vertex);
            return vertex;
        }
        double sum = 0.0;
        for (std::size_t i = index * mesh_.influenceCount; i < (index + 1) * mesh_.influenceCount; ++i) {
            blend(mesh_.jointWeights[i], joints_[mesh_.joints[i]], vertex);
            sum += mesh_.jointWeights[i];
        }
        vertex.matrix /= sum;
        return vertex;
    }

  private:
    void morph(std::size_t index, Vertex& vertex) const {
        vertex.position = glm::dvec3(mesh_.positions[index]);
        vertex.normal = glm::dvec3(mesh_.normals[index]);
        vertex.reach = glm::length(vertex.position);
        vertex.normalReach = vertex.tangentReach = 1.0;
        if (!mesh_.tangents.empty()) {
            vertex.tangent = glm::dvec3(mesh_.tangents[index]);
            vertex.side = mesh_.tangents[index].w;
        }
        for (std::size_t i = 0; i < node_.morphWeights.size(); ++i) {
            const double weight = node_.morphWeights[i];
            const auto add = [&](const std::vector<glm::vec3>& offsets, glm::dvec3& to, double& reach) {
                if (offsets.empty()) return;
                to += weight * glm::dvec3(offsets[index]);
                reach += std::abs(weight) * glm::length(glm::dvec3(offsets[index]));
            };
            add(mesh_.morphTargets[i].offsets, vertex.position, vertex.reach);
            add(mesh_.morphTargets[i].normalOffsets, vertex.normal, vertex.normalReach);
            add(mesh_.morphTargets[i].tangentOffsets, vertex.tangent, vertex.tangentReach);
        }
    }

    static void blend(double weight, const glm::dmat4& joint, Vertex& vertex) {
        vertex.matrix += weight * joint;
        vertex.stretch += weight * sizeOf(joint);
        vertex.shift += weight * glm::length(glm::dvec3(joint[3]));
    }

    const Node& node_;
    const Mesh& mesh_;
    std::vector<glm::dmat4> joints_;
    glm::dvec3 origin_{0.0};
};

}  // namespace

DeformedVertices evaluateDeformation(const Scene& scene, std::uint32_t node,
                                     std::span<const glm::mat4> world) {
    const Evaluation evaluation(scene, node, world);
    const Mesh& mesh = scene.meshes[*scene.nodes[node].mesh];
    DeformedVertices vertices;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vertex vertex = evaluation.at(i);
        const glm::dmat3 linear(vertex.matrix);
        vertices.positions.push_back(evaluation.origin() +
                                     glm::dvec3(vertex.matrix * glm::dvec4(vertex.position, 1.0)));
        vertices.normals.push_back(glm::normalize(glm::transpose(glm::inverse(linear)) * vertex.normal));
        if (mesh.tangents.empty()) continue;
        vertices.tangents.emplace_back(glm::normalize(linear * vertex.tangent),
                                       glm::determinant(linear) < 0.0 ? -vertex.side : vertex.side);
    }
    return vertices;
}

void expectDeformed(const DeformedVertices& vertices, const Scene& scene, std::uint32_t node,
                    std::span<const glm::mat4> world) {
    const Evaluation evaluation(scene, node, world);
    const DeformedVertices expected = evaluateDeformation(scene, node, world);
    ASSERT_EQ(vertices.positions.size(), expected.positions.size());
    ASSERT_EQ(vertices.tangents.size(), expected.tangents.size());
    // At most 8 influences of 4 products each are summed, after some targets: 48 roundings of 6e-8 of the
    // terms' sizes.
    constexpr double rounding = 48 * 6e-8;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < expected.positions.size(); ++i) {
        const Vertex vertex = evaluation.at(i);
        const double positionTolerance = rounding * (vertex.stretch * vertex.reach + vertex.shift);
        ASSERT_LE(glm::distance(vertices.positions[i], expected.positions[i]), positionTolerance)
            << "vertex " << i;
        const glm::dmat3 linear(vertex.matrix);
        const double volume = std::abs(glm::determinant(linear)) / std::pow(vertex.stretch, 3);
        // A matrix that nearly flattens the vertex leaves its directions undetermined.
        if (volume < 1e-3) continue;
        ++compared;
        // The cofactors are products of two numbers of the size of the stretch. The kernels' reciprocal
        // square root adds two roundings.
        const double cofactor =
            glm::length(glm::determinant(linear) * (glm::transpose(glm::inverse(linear)) * vertex.normal));
        const double normalTolerance =
            rounding * (1.0 + 4.0 * vertex.stretch * vertex.stretch * vertex.normalReach / cofactor);
        ASSERT_LE(glm::distance(vertices.normals[i], expected.normals[i]), normalTolerance) << "vertex " << i;
        if (expected.tangents.empty()) continue;
        const double tangentTolerance = rounding * (1.0 + 2.0 * vertex.stretch * vertex.tangentReach /
                                                              glm::length(linear * vertex.tangent));
        ASSERT_LE(glm::distance(glm::dvec3(vertices.tangents[i]), glm::dvec3(expected.tangents[i])),
                  tangentTolerance)
            << "vertex " << i;
        ASSERT_EQ(vertices.tangents[i].w, expected.tangents[i].w) << "vertex " << i;
    }
    EXPECT_GT(compared, expected.positions.size() / 2);
}

}  // namespace candela::test
