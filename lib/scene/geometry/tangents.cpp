#include "scene/geometry/tangents.h"

#include "base/error_context.h"
#include "base/thread_pool.h"
#include "scene/geometry/axes.h"
#include "scene/geometry/tangent_groups.h"
#include "scene/geometry/topology.h"
#include "scene/geometry/vertex_copy.h"
#include "scene/model/uv_sets.h"
#include "scene/validate/scene_rules.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace candela {

namespace {

glm::dvec3 unitOrZero(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return length > 0.0 && std::isfinite(length) ? vector / length : glm::dvec3(0.0);
}

glm::dvec3 inPlane(const glm::dvec3& vector, const glm::dvec3& normal) {
    return unitOrZero(vector - normal * glm::dot(normal, vector));
}

// The direction of increasing u on a triangle, of any length.
glm::dvec3 uDirection(const Mesh& mesh, const std::vector<glm::vec2>& uv, std::size_t triangle,
                      bool mirrored) {
    const std::uint32_t* index = mesh.indices.data() + triangle * 3;
    const glm::dvec3 origin(mesh.positions[index[0]]);
    const glm::dvec3 edge1 = glm::dvec3(mesh.positions[index[1]]) - origin;
    const glm::dvec3 edge2 = glm::dvec3(mesh.positions[index[2]]) - origin;
    const double v1 = static_cast<double>(uv[index[1]].y) - uv[index[0]].y;
    const double v2 = static_cast<double>(uv[index[2]].y) - uv[index[0]].y;
    return (edge1 * v2 - edge2 * v1) * (mirrored ? -1.0 : 1.0);
}

using TriangleTerms = std::array<glm::vec3, 3>;

// The contributions of a triangle's corners to the sums of their groups.
TriangleTerms termsOf(const Mesh& mesh, const std::vector<glm::vec2>& uv, std::size_t triangle,
                      bool mirrored) {
    const glm::dvec3 direction = uDirection(mesh, uv, triangle, mirrored);
    const std::uint32_t* index = mesh.indices.data() + triangle * 3;
    TriangleTerms terms;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 here(mesh.positions[index[i]]);
        const glm::dvec3 normal = unitOrZero(glm::dvec3(mesh.normals[index[i]]));
        const glm::dvec3 next = inPlane(glm::dvec3(mesh.positions[index[(i + 1) % 3]]) - here, normal);
        const glm::dvec3 last = inPlane(glm::dvec3(mesh.positions[index[(i + 2) % 3]]) - here, normal);
        const double angle = std::acos(glm::clamp(glm::dot(next, last), -1.0, 1.0));
        terms[i] = glm::vec3(inPlane(direction, normal) * angle);
    }
    return terms;
}

// The sum of each group, by the corner that identifies it. Terms are computed in parallel, a block of
// triangles at a time to bound the memory, and added in the order of triangles: the sums do not depend on the
// number of threads.
std::vector<glm::vec3> sumTerms(const Mesh& mesh, const std::vector<glm::vec2>& uv,
                                const TangentGroups& groups) {
    constexpr std::size_t blockSize = 1 << 18, chunkSize = 1 << 11;
    const std::size_t triangles = groups.kinds.size();
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    std::vector<glm::vec3> sums(mesh.indices.size(), glm::vec3(0.0f));
    std::vector<TriangleTerms> terms(std::min(triangles, blockSize));
    for (std::size_t block = 0; block < triangles; block += blockSize) {
        const std::size_t end = std::min(triangles, block + blockSize);
        pool->run((end - block + chunkSize - 1) / chunkSize, [&](std::size_t chunk, unsigned) {
            const std::size_t first = block + chunk * chunkSize, last = std::min(end, first + chunkSize);
            for (std::size_t i = first; i < last; ++i) {
                if (groups.kinds[i] == TriangleKind::whole)
                    terms[i - block] = termsOf(mesh, uv, i, groups.mirrored[i]);
            }
        });
        for (std::size_t i = block; i < end; ++i) {
            if (groups.kinds[i] != TriangleKind::whole) continue;
            for (std::size_t corner = 0; corner < 3; ++corner)
                sums[groups.groupOfCorner[i * 3 + corner]] += terms[i - block][corner];
        }
    }
    return sums;
}

bool hasDirection(const glm::vec3& sum) {
    const float length = glm::length(sum);
    return length > 0.0f && std::isfinite(length);
}

// For each corner the group whose tangent it has: its own when that has one, else the first at the same
// vertex that has, else noCorner.
std::vector<std::uint32_t> groupsOfCorners(const Mesh& mesh, const TangentGroups& groups,
                                           const std::vector<glm::vec3>& sums) {
    const std::size_t corners = mesh.indices.size();
    std::vector<std::uint32_t> firstAtVertex(mesh.positions.size(), noCorner);
    for (std::size_t corner = 0; corner < corners; ++corner) {
        std::uint32_t& first = firstAtVertex[groups.vertexOfCorner[corner]];
        if (first == noCorner && hasDirection(sums[groups.groupOfCorner[corner]])) {
            first = groups.groupOfCorner[corner];
        }
    }
    std::vector<std::uint32_t> chosen(groups.groupOfCorner);
    for (std::size_t corner = 0; corner < corners; ++corner) {
        if (!hasDirection(sums[chosen[corner]]))
            chosen[corner] = firstAtVertex[groups.vertexOfCorner[corner]];
    }
    return chosen;
}

// A corner whose vertex already has another group's tangent.
struct Split {
    std::uint32_t vertex, group, corner;

    bool sameVertexAs(const Split& other) const { return vertex == other.vertex && group == other.group; }
};

// Gives each vertex one group, splitting where its corners disagree. Returns the groups, noCorner for none.
std::vector<std::uint32_t> splitVertices(Mesh& mesh, const std::vector<std::uint32_t>& chosen) {
    std::vector<std::uint32_t> groupOfVertex(mesh.positions.size(), noCorner);
    std::vector<bool> used(mesh.positions.size());
    std::vector<Split> splits;
    for (std::uint32_t corner = 0; corner < mesh.indices.size(); ++corner) {
        const std::uint32_t vertex = mesh.indices[corner];
        if (!used[vertex]) {
            used[vertex] = true;
            groupOfVertex[vertex] = chosen[corner];
        } else if (groupOfVertex[vertex] != chosen[corner]) {
            splits.push_back({vertex, chosen[corner], corner});
        }
    }
    std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
        return std::tie(a.vertex, a.group, a.corner) < std::tie(b.vertex, b.group, b.corner);
    });
    for (std::size_t i = 0; i < splits.size(); ++i) {
        if (i == 0 || !splits[i].sameVertexAs(splits[i - 1])) {
            appendVertexCopy(mesh, splits[i].vertex);
            groupOfVertex.push_back(splits[i].group);
        }
        mesh.indices[splits[i].corner] = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }
    return groupOfVertex;
}

glm::vec4 anyTangent(const glm::vec3& normal) {
    const glm::dvec3 axis = unitOrZero(glm::dvec3(normal));
    if (axis == glm::dvec3(0.0)) return {1.0f, 0.0f, 0.0f, 1.0f};
    return {glm::vec3(anyPerpendicular(axis)), 1.0f};
}

void requireArrays(const Mesh& mesh, std::uint32_t uvSet) {
    const ErrorContext element("mesh", {}, mesh.name);
    requireIndices(mesh, element);
    const std::size_t vertices = mesh.positions.size();
    element.require(mesh.normals.size() == vertices, "tangents need one normal per vertex");
    element.require(uvsOf(mesh, uvSet).size() == vertices, "tangents need one texture coordinate per vertex");
    const auto requireAllOrNone = [&](std::size_t size) {
        element.require(size == 0 || size == vertices, "an array has neither no element nor one per vertex");
    };
    for (const std::size_t size : {mesh.uv0.size(), mesh.uv1.size(), mesh.colors.size()})
        requireAllOrNone(size);
    for (const std::vector<glm::vec2>& uvs : mesh.furtherUvs) requireAllOrNone(uvs.size());
    const DeformableVertices shape(mesh);
    requireInfluences(shape, element);
    requireMorphTargets(shape, element);
}

/// Of a mesh with lines or points too, whose indices stay.
void generateForTriangles(Mesh& mesh, std::uint32_t uvSet) {
    std::vector<std::uint32_t> all = mesh.indices, corners;
    forEachTriangle(mesh, [&](std::size_t first) {
        corners.insert(corners.end(), all.begin() + static_cast<std::ptrdiff_t>(first),
                       all.begin() + static_cast<std::ptrdiff_t>(first + 3));
    });
    std::vector<Submesh> submeshes = std::exchange(mesh.submeshes, {});
    mesh.indices = std::move(corners);
    generateTangents(mesh, uvSet);
    corners = std::move(mesh.indices);
    mesh.submeshes = std::move(submeshes);
    std::size_t next = 0;
    forEachTriangle(mesh, [&](std::size_t first) {
        for (std::size_t corner = first; corner < first + 3; ++corner) all[corner] = corners[next++];
    });
    mesh.indices = std::move(all);
}

}  // namespace

void generateTangents(Mesh& mesh, std::uint32_t uvSet) {
    requireArrays(mesh, uvSet);
    if (!hasOnlyTriangles(mesh)) return generateForTriangles(mesh, uvSet);
    const std::vector<glm::vec2>& uv = uvsOf(mesh, uvSet);
    const TangentGroups groups = tangentGroups(mesh, uv);
    const std::vector<glm::vec3> sums = sumTerms(mesh, uv, groups);
    mesh.tangents.clear();
    const std::vector<std::uint32_t> groupOfVertex = splitVertices(mesh, groupsOfCorners(mesh, groups, sums));
    mesh.tangents.reserve(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        const std::uint32_t group = groupOfVertex[vertex];
        if (group == noCorner) {
            mesh.tangents.push_back(anyTangent(mesh.normals[vertex]));
            continue;
        }
        // v increases down the image, bitangents point up: an unmirrored triangle has w = -1.
        const float side = groups.mirrored[group / 3] ? 1.0f : -1.0f;
        mesh.tangents.emplace_back(glm::normalize(sums[group]), side);
    }
}

}  // namespace candela
