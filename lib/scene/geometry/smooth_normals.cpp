#include <candela/geometry.h>

#include "base/error_context.h"
#include "scene/geometry/tangents.h"
#include "scene/geometry/topology.h"
#include "scene/geometry/vertex_copy.h"
#include "scene/model/uv_sets.h"
#include "scene/validate/scene_rules.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

namespace candela {

namespace {

constexpr glm::vec3 up(0.0f, 1.0f, 0.0f);
constexpr std::uint32_t none = 0xffffffffu;
/// Of more triangles at one edge none are joined: the pairs would take quadratic time.
constexpr std::size_t maxAtEdge = 32;

std::uint32_t next(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
std::uint32_t previous(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// The corners of the triangles, counted over triangles alone, as places in `Mesh::indices`.
std::vector<std::uint32_t> cornerPlaces(const Mesh& mesh) {
    std::vector<std::uint32_t> places;
    forEachTriangle(mesh, [&](std::size_t first) {
        for (std::size_t place = first; place < first + 3; ++place)
            places.push_back(static_cast<std::uint32_t>(place));
    });
    return places;
}

/// For each vertex the first one of the same position.
std::vector<std::uint32_t> weldPositions(const std::vector<glm::vec3>& positions) {
    const auto key = [&](std::uint32_t vertex) {
        // Adding 0 maps -0 to 0.
        const glm::vec3 p = positions[vertex] + 0.0f;
        return std::array{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                          std::bit_cast<std::uint32_t>(p.z)};
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, key);
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// Sets of corners that share a normal.
class CornerGroups {
  public:
    explicit CornerGroups(std::size_t corners) : parents_(corners) {
        std::iota(parents_.begin(), parents_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t corner) {
        while (parents_[corner] != corner) corner = parents_[corner] = parents_[parents_[corner]];
        return corner;
    }
    /// The lowest corner identifies a group, so that it does not depend on the order of the calls.
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t first = find(a), second = find(b);
        parents_[std::max(first, second)] = std::min(first, second);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

/// The unit normal of each triangle; (0, 0, 0) without an area.
std::vector<glm::dvec3> triangleNormals(const Mesh& mesh, const std::vector<std::uint32_t>& places,
                                        const std::vector<glm::vec3>& positions) {
    std::vector<glm::dvec3> normals;
    for (std::size_t i = 0; i < places.size(); i += 3) {
        const auto at = [&](std::size_t corner) {
            return glm::dvec3(positions[mesh.indices[places[i + corner]]]);
        };
        const glm::dvec3 cross = glm::cross(at(1) - at(0), at(2) - at(0));
        const double length = glm::length(cross);
        normals.push_back(length > 0.0 && std::isfinite(length) ? cross / length : glm::dvec3(0.0));
    }
    return normals;
}

/// The edge from a corner to the next one.
struct Edge {
    std::uint32_t low, high, corner;
    bool rising;
};

class Smoothing {
  public:
    Smoothing(const Mesh& mesh, double creaseAngle)
        : places_(cornerPlaces(mesh)),
          pointCount_(mesh.positions.size()),
          groups_(places_.size()),
          normals_(triangleNormals(mesh, places_, mesh.positions)) {
        const std::vector<std::uint32_t> points = weldPositions(mesh.positions);
        for (const std::uint32_t place : places_) pointsOfCorners_.push_back(points[mesh.indices[place]]);
        joinAcrossEdges(creaseAngle);
    }

    const std::vector<std::uint32_t>& places() const { return places_; }

    /// The normal of each corner where the vertices of the mesh are at `positions`. `mesh` may have got more
    /// vertices meanwhile.
    std::vector<glm::vec3> cornerNormals(const Mesh& mesh, const std::vector<glm::vec3>& positions) {
        const std::vector<glm::dvec3> normals = triangleNormals(mesh, places_, positions);
        std::vector<glm::dvec3> sums(places_.size(), glm::dvec3(0.0));
        for (std::uint32_t corner = 0; corner < places_.size(); ++corner)
            sums[groups_.find(corner)] += angleAt(mesh, positions, corner) * normals[corner / 3];
        std::vector<std::uint32_t> firstAtPoint(pointCount_, none);
        const auto hasNormal = [&](std::uint32_t corner) {
            return glm::length(sums[groups_.find(corner)]) > 1e-9;
        };
        for (std::uint32_t corner = 0; corner < places_.size(); ++corner) {
            std::uint32_t& first = firstAtPoint[pointOf(corner)];
            if (first == none && hasNormal(corner)) first = corner;
        }
        std::vector<glm::vec3> result(places_.size(), up);
        for (std::uint32_t corner = 0; corner < places_.size(); ++corner) {
            const std::uint32_t source = hasNormal(corner) ? corner : firstAtPoint[pointOf(corner)];
            if (source != none) result[corner] = glm::vec3(glm::normalize(sums[groups_.find(source)]));
        }
        return result;
    }

  private:
    std::uint32_t pointOf(std::uint32_t corner) const { return pointsOfCorners_[corner]; }

    double angleAt(const Mesh& mesh, const std::vector<glm::vec3>& positions, std::uint32_t corner) const {
        const auto at = [&](std::uint32_t c) { return glm::dvec3(positions[mesh.indices[places_[c]]]); };
        const glm::dvec3 a = at(next(corner)) - at(corner), b = at(previous(corner)) - at(corner);
        // Exact for small angles too.
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }

    std::vector<Edge> sortedEdges() const {
        std::vector<Edge> edges;
        for (std::uint32_t corner = 0; corner < places_.size(); ++corner) {
            if (normals_[corner / 3] == glm::dvec3(0.0)) continue;
            const std::uint32_t a = pointsOfCorners_[corner], b = pointsOfCorners_[next(corner)];
            edges.push_back({std::min(a, b), std::max(a, b), corner, a < b});
        }
        std::ranges::stable_sort(edges, [](const Edge& a, const Edge& b) {
            return a.low != b.low ? a.low < b.low : a.high < b.high;
        });
        return edges;
    }

    void joinAcrossEdges(double creaseAngle) {
        const std::vector<Edge> edges = sortedEdges();
        for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
            while (end < edges.size() && edges[end].low == edges[first].low &&
                   edges[end].high == edges[first].high) {
                ++end;
            }
            if (end - first > maxAtEdge) continue;
            for (std::size_t i = first; i < end; ++i) {
                for (std::size_t k = i + 1; k < end; ++k) joinTriangles(edges[i], edges[k], creaseAngle);
            }
        }
    }

    void joinTriangles(const Edge& a, const Edge& b, double creaseAngle) {
        if (a.rising == b.rising) return;
        const glm::dvec3 &m = normals_[a.corner / 3], &n = normals_[b.corner / 3];
        const double angle = std::atan2(glm::length(glm::cross(m, n)), glm::dot(m, n));
        if (!(angle < creaseAngle)) return;
        groups_.join(a.corner, next(b.corner));
        groups_.join(next(a.corner), b.corner);
    }

    std::vector<std::uint32_t> places_, pointsOfCorners_;
    std::size_t pointCount_;
    CornerGroups groups_;
    std::vector<glm::dvec3> normals_;
};

/// Gives the corners their normals. Vertices of which lines or points have a use keep theirs.
void setNormals(Mesh& mesh, const std::vector<std::uint32_t>& places, const std::vector<glm::vec3>& normals) {
    const std::size_t vertices = mesh.positions.size();
    std::vector<bool> isSet(vertices, false), isTriangleCorner(mesh.indices.size(), false);
    for (const std::uint32_t place : places) isTriangleCorner[place] = true;
    const bool hadNormals = !mesh.normals.empty();
    if (!hadNormals) mesh.normals.assign(vertices, up);
    for (std::size_t place = 0; place < mesh.indices.size(); ++place) {
        if (isTriangleCorner[place]) continue;
        isSet[mesh.indices[place]] = true;
        if (!hadNormals) mesh.normals[mesh.indices[place]] = glm::vec3(0.0f);
    }
    std::vector<std::uint32_t> nextCopy(vertices, none);
    for (std::size_t corner = 0; corner < places.size(); ++corner) {
        std::uint32_t vertex = mesh.indices[places[corner]];
        if (!isSet[vertex]) {
            isSet[vertex] = true;
            mesh.normals[vertex] = normals[corner];
        }
        while (mesh.normals[vertex] != normals[corner] && nextCopy[vertex] != none) vertex = nextCopy[vertex];
        if (mesh.normals[vertex] != normals[corner]) {
            const std::uint32_t copy = appendVertexCopy(mesh, vertex);
            mesh.normals[copy] = normals[corner];
            nextCopy.push_back(none);
            nextCopy[vertex] = copy;
            vertex = copy;
        }
        mesh.indices[places[corner]] = vertex;
    }
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        if (!isSet[vertex]) mesh.normals[vertex] = up;
    }
}

void setMorphedNormals(Mesh& mesh, Smoothing& smoothing) {
    for (MorphTarget& target : mesh.morphTargets) {
        std::vector<glm::vec3> moved = mesh.positions;
        for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += target.offsets[i];
        const std::vector<glm::vec3> normals = smoothing.cornerNormals(mesh, moved);
        target.tangentOffsets.clear();
        target.normalOffsets.assign(moved.size(), glm::vec3(0.0f));
        for (std::size_t corner = 0; corner < normals.size(); ++corner) {
            const std::uint32_t vertex = mesh.indices[smoothing.places()[corner]];
            target.normalOffsets[vertex] = normals[corner] - mesh.normals[vertex];
        }
    }
}

void requireArrays(const Mesh& mesh, const ErrorContext& element) {
    requireIndices(mesh, element);
    element.requireEachFinite("position", mesh.positions);
    const auto requireAllOrNone = [&](std::size_t size) {
        element.require(size == 0 || size == mesh.positions.size(),
                        "an array has neither no element nor one per vertex");
    };
    for (const std::size_t size : {mesh.normals.size(), mesh.uv0.size(), mesh.uv1.size(), mesh.colors.size()})
        requireAllOrNone(size);
    for (const std::vector<glm::vec2>& uvs : mesh.furtherUvs) requireAllOrNone(uvs.size());
    const DeformableVertices shape(mesh);
    requireInfluences(shape, element);
    requireMorphTargets(shape, element);
}

}  // namespace

void computeNormals(Mesh& mesh, float creaseAngle) {
    const ErrorContext element("mesh", {}, mesh.name);
    element.requireWithin("the crease angle", creaseAngle, 0.0, std::numbers::pi_v<float>);
    requireArrays(mesh, element);
    mesh.tangents.clear();
    for (MorphTarget& target : mesh.morphTargets) target.normalOffsets.clear();
    // At the largest angle even triangles that lie back to back are joined.
    const double limit = creaseAngle < std::numbers::pi_v<float> ? creaseAngle : 4.0;
    Smoothing smoothing(mesh, limit);
    setNormals(mesh, smoothing.places(), smoothing.cornerNormals(mesh, mesh.positions));
    setMorphedNormals(mesh, smoothing);
}

void computeTangents(Mesh& mesh, std::uint32_t uvSet) {
    const ErrorContext element("mesh", {}, mesh.name);
    element.requireWithin("the set of texture coordinates", uvSet, 0, maxUvSets - 1);
    generateTangents(mesh, uvSet);
}

}  // namespace candela
