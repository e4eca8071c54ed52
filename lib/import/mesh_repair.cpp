#include "import/mesh_repair.h"

#include "scene/geometry/normals.h"
#include "scene/geometry/perpendicular.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace candela {

// Lengths are taken in double precision, where neither the greatest nor the least float is lost when squared.

std::size_t repairNormals(Mesh& mesh) {
    if (mesh.normals.empty()) return 0;
    const std::size_t replaced = replaceZeroNormals(mesh);
    for (glm::vec3& normal : mesh.normals) normal = glm::vec3(glm::normalize(glm::dvec3(normal)));
    return replaced;
}

std::size_t repairTangents(Mesh& mesh) {
    std::size_t replaced = 0;
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        glm::vec4& tangent = mesh.tangents[i];
        glm::dvec3 direction(tangent);
        if (!(glm::length(direction) > 0.0)) {
            direction = anyPerpendicular(glm::dvec3(mesh.normals[i]));
            ++replaced;
        }
        tangent = glm::vec4(glm::vec3(glm::normalize(direction)), tangent.w < 0.0f ? -1.0f : 1.0f);
    }
    return replaced;
}

}  // namespace candela
