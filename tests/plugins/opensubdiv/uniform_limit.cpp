#include "uniform_limit.h"

#include "osd_topology.h"
#include "reference.h"

#include <opensubdiv/far/primvarRefiner.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace candela {
namespace {

namespace Far = OpenSubdiv::Far;

/// The values that Far's refiner interpolates.
struct Point {
    glm::dvec3 value{0.0};

    void Clear(void* = nullptr) { value = glm::dvec3(0.0); }
    void AddWithWeight(const Point& other, double weight) { value += other.value * weight; }
};

/// A corner of a face at a level of refinement.
struct FaceCorner {
    int face, vertex;

    void descend(const Far::TopologyLevel& level, const Far::TopologyLevel& next) {
        vertex = level.GetVertexChildVertex(vertex);
        for (const int child : level.GetFaceChildFaces(face)) {
            if (next.GetFaceVertices(child).FindIndex(vertex) < 0) continue;
            face = child;
            return;
        }
    }
};

struct UniformRefinement {
    std::unique_ptr<Far::TopologyRefiner> topology;
    std::vector<Point> positions, uvs;
    std::vector<FaceCorner> corners;
};

UniformRefinement unrefined(const Cage& cage) {
    UniformRefinement start{osdTopology(cage), {}, {}, {}};
    for (const glm::vec3& position : cage.positions) start.positions.push_back({glm::dvec3(position)});
    for (const glm::vec2& uv : cage.uvs) start.uvs.push_back({glm::dvec3(uv, 0.0)});
    std::size_t corner = 0;
    for (std::size_t face = 0; face < cage.faceSizes.size(); ++face) {
        for (std::uint32_t i = 0; i < cage.faceSizes[face]; ++i, ++corner) {
            start.corners.push_back({static_cast<int>(face), static_cast<int>(cage.faceVertices[corner])});
        }
    }
    return start;
}

void refineUniformly(UniformRefinement& refinement, int levels) {
    Far::TopologyRefiner& topology = *refinement.topology;
    Far::TopologyRefiner::UniformOptions options(levels);
    options.fullTopologyInLastLevel = true;
    topology.RefineUniform(options);
    const Far::PrimvarRefinerReal<double> refiner(topology);
    for (int level = 1; level <= levels; ++level) {
        const Far::TopologyLevel& next = topology.GetLevel(level);
        std::vector<Point> positions(static_cast<std::size_t>(next.GetNumVertices()));
        refiner.Interpolate(level, refinement.positions, positions);
        refinement.positions = std::move(positions);
        for (FaceCorner& corner : refinement.corners) corner.descend(topology.GetLevel(level - 1), next);
        if (refinement.uvs.empty()) continue;
        std::vector<Point> uvs(static_cast<std::size_t>(next.GetNumFVarValues()));
        refiner.InterpolateFaceVarying(level, refinement.uvs, uvs);
        refinement.uvs = std::move(uvs);
    }
}

}  // namespace

UniformLimit uniformLimit(const Cage& cage) {
    // At least two levels: the limit masks assume faces of the regular size.
    const int levels = std::max(2, semiSharpLevels(cage));
    UniformRefinement refinement = unrefined(cage);
    refineUniformly(refinement, levels);
    const Far::PrimvarRefinerReal<double> refiner(*refinement.topology);
    std::vector<Point> positions(refinement.positions.size()), uvs(refinement.uvs.size());
    std::vector<Point> tangents0(positions.size()), tangents1(positions.size());
    refiner.Limit(refinement.positions, positions, tangents0, tangents1);
    if (!uvs.empty()) refiner.LimitFaceVarying(refinement.uvs, uvs);

    UniformLimit limit;
    limit.positions.resize(cage.positions.size());
    limit.normals.resize(cage.positions.size());
    const Far::TopologyLevel& last = refinement.topology->GetLevel(levels);
    for (std::size_t i = 0; i < refinement.corners.size(); ++i) {
        const FaceCorner& corner = refinement.corners[i];
        const auto vertex = static_cast<std::size_t>(corner.vertex);
        limit.positions[cage.faceVertices[i]] = positions[vertex].value;
        limit.normals[cage.faceVertices[i]] = glm::cross(tangents0[vertex].value, tangents1[vertex].value);
        if (uvs.empty()) continue;
        if (cage.scheme == SubdivisionScheme::bilinear) {
            // Far's limit masks for face-varying values do not cover the bilinear scheme, whose limit values
            // are the control values.
            limit.uvs.emplace_back(cage.uvs[cage.faceUvs[i]], 0.0);
            continue;
        }
        const int slot = last.GetFaceVertices(corner.face).FindIndex(corner.vertex);
        const int uv = last.GetFaceFVarValues(corner.face)[slot];
        limit.uvs.push_back(uvs[static_cast<std::size_t>(uv)].value);
    }
    return limit;
}

}  // namespace candela
