#include "render/gpu_scene/instance_records.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

struct NormalMatrix {
    glm::mat3 matrix;
    bool mirrored;  ///< The instance's matrix turns the winding round.
};

/// The matrix that takes normals to the world: the cofactors of the linear part, which are det(M) times the
/// inverse transpose and defined for singular matrices too. The sign is that of the inverse transpose, so
/// that normals of mirrored instances point outwards; the largest element is brought to 1, so that lengths of
/// normals neither overflow nor vanish, however large or small the instance is.
NormalMatrix normalMatrix(const glm::mat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const bool mirrored = glm::dot(x, cofactors[0]) < 0.0;
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
    }
    if (largest == 0.0) return {glm::mat3(0.0f), mirrored};
    return {glm::mat3(cofactors * ((mirrored ? -1.0 : 1.0) / largest)), mirrored};
}

}  // namespace

float maxScale(const glm::mat4& m) {
    // The Frobenius norm bounds the largest singular value, sheared matrices included.
    const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
    return std::sqrt(glm::dot(x, x) + glm::dot(y, y) + glm::dot(z, z));
}

glm::vec4 worldSphere(const glm::mat4& worldFromLocal, const glm::vec3& center, float radius) {
    return {glm::vec3(worldFromLocal * glm::vec4(center, 1.0f)), radius * maxScale(worldFromLocal)};
}

bool appendInstanceRecord(std::vector<glm::vec4>& records, const glm::mat4& worldFromLocal) {
    const glm::mat4 rows = glm::transpose(worldFromLocal);
    const NormalMatrix normals = normalMatrix(worldFromLocal);
    const glm::mat3 normalRows = glm::transpose(normals.matrix);
    for (int row = 0; row < 3; ++row) records.push_back(rows[row]);
    const float handedness = normals.mirrored ? -1.0f : 1.0f;
    for (int row = 0; row < 3; ++row) records.emplace_back(normalRows[row], handedness);
    return normals.mirrored;
}

}  // namespace candela
