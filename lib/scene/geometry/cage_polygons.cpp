#include "scene/geometry/axes.h"
#include "scene/geometry/triangulate.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>
#include <candela/refined_cage.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace candela {

namespace {

/// A polygon of more corners is fitted by three of them, which bounds the size of its stencils.
constexpr std::size_t maxFittedCorners = 64;

constexpr std::uint32_t none = 0xffffffffu;

/// Weights of some corners of a polygon, whose sums are the derivatives of the affine map that fits best.
struct Derivatives {
    std::vector<std::uint32_t> corners;
    std::vector<float> du, dv;  ///< Of sum 0, but for rounding.
};

/// The point for which `measure` is largest.
template <typename Measure>
std::uint32_t farthest(const std::vector<glm::dvec2>& points, const Measure& measure) {
    std::uint32_t best = 0;
    for (std::uint32_t point = 1; point < points.size(); ++point) {
        if (measure(points[point]) > measure(points[best])) best = point;
    }
    return best;
}

std::vector<std::uint32_t> fittedCorners(const std::vector<glm::dvec2>& points) {
    std::vector<std::uint32_t> corners;
    if (points.size() <= maxFittedCorners) {
        for (std::uint32_t corner = 0; corner < points.size(); ++corner) corners.push_back(corner);
        return corners;
    }
    const auto farFrom = [&](glm::dvec2 from) {
        return farthest(points, [&](glm::dvec2 p) { return glm::distance(p, from); });
    };
    const std::uint32_t a = farFrom(points[0]), b = farFrom(points[a]);
    const glm::dvec2 along = points[b] - points[a];
    const std::uint32_t c = farthest(points, [&](glm::dvec2 p) {
        return std::abs(along.x * (p.y - points[a].y) - along.y * (p.x - points[a].x));
    });
    return {a, b, c};
}

/// The edges at the first corner, for a polygon without a plane.
Derivatives edgesOf(std::size_t size) {
    return {{0, 1, static_cast<std::uint32_t>(size - 1)}, {-1.0f, 1.0f, 0.0f}, {-1.0f, 0.0f, 1.0f}};
}

/// Least squares: with p the corners projected into the plane, relative to their mean, the weights are the
/// columns of M⁻¹ p for M = Σ p pᵀ.
std::optional<Derivatives> fit(const std::vector<glm::dvec2>& points) {
    Derivatives result;
    result.corners = fittedCorners(points);
    glm::dvec2 mean(0.0);
    for (const std::uint32_t corner : result.corners) mean += points[corner];
    mean /= static_cast<double>(result.corners.size());
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const std::uint32_t corner : result.corners) {
        const glm::dvec2 p = points[corner] - mean;
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
    }
    const double determinant = xx * yy - xy * xy;
    // A polygon 10^6 times longer than wide: then the weights are rounding errors.
    if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return {};
    for (const std::uint32_t corner : result.corners) {
        const glm::dvec2 p = points[corner] - mean;
        const double du = (yy * p.x - xy * p.y) / determinant, dv = (xx * p.y - xy * p.x) / determinant;
        if (!(std::max(std::abs(du), std::abs(dv)) < std::numeric_limits<float>::max())) return {};
        result.du.push_back(static_cast<float>(du));
        result.dv.push_back(static_cast<float>(dv));
    }
    return result;
}

Derivatives derivativesOf(std::span<const glm::vec3> polygon) {
    const std::optional<PolygonPlane> plane = polygonPlane(polygon);
    std::optional<Derivatives> fitted;
    if (plane) fitted = fit(plane->project(polygon));
    return fitted ? std::move(*fitted) : edgesOf(polygon.size());
}

void append(StencilTable& table, std::uint32_t controlIndex, float weight, float du, float dv) {
    table.controlIndices.push_back(controlIndex);
    table.weights.push_back(weight);
    table.duWeights.push_back(du);
    table.dvWeights.push_back(dv);
}

void endStencil(StencilTable& table) {
    if (table.controlIndices.size() > none)
        throw Error(ErrorKind::limit, {}, "a cage has too many corners: its weights are more than 2^32 - 1");
    if (table.offsets.empty()) table.offsets.push_back(0);
    table.offsets.push_back(static_cast<std::uint32_t>(table.controlIndices.size()));
}

/// The stencil of the polygon's `corner`; `controls` has one index per corner.
void appendStencil(StencilTable& table, const Derivatives& derivatives, std::uint32_t corner,
                   std::span<const std::uint32_t> controls) {
    bool present = false;
    for (std::size_t i = 0; i < derivatives.corners.size(); ++i) {
        const bool own = derivatives.corners[i] == corner;
        present = present || own;
        append(table, controls[derivatives.corners[i]], own ? 1.0f : 0.0f, derivatives.du[i],
               derivatives.dv[i]);
    }
    if (!present) append(table, controls[corner], 1.0f, 0.0f, 0.0f);
    endStencil(table);
}

void appendStencils(StencilTable& table, const StencilTable& more) {
    for (std::size_t stencil = 0; stencil < more.stencilCount(); ++stencil) {
        for (std::size_t entry = more.offsets[stencil]; entry < more.offsets[stencil + 1]; ++entry)
            append(table, more.controlIndices[entry], more.weights[entry], more.duWeights[entry],
                   more.dvWeights[entry]);
        endStencil(table);
    }
}

std::vector<bool> holesOf(const Cage& cage) {
    std::vector<bool> isHole(cage.faceSizes.size(), false);
    for (const std::uint32_t face : cage.holes) isHole[face] = true;
    return isHole;
}

/// Builds the table face by face. Points are numbered as faces first name their vertices.
class PolygonTable {
  public:
    explicit PolygonTable(const Cage& cage);
    RefinedCage take();

  private:
    void numberPoints();
    void addFace(std::uint32_t face, std::size_t firstCorner);
    std::uint32_t addSeamVertex(std::uint32_t point);

    const Cage& cage_;
    std::vector<bool> isHole_;
    std::vector<std::uint32_t> pointOf_;  // One per vertex of the cage.
    std::uint32_t pointsSeen_ = 0;
    StencilTable seamPositions_, seamUvs_;
    RefinedCage result_;
    std::vector<glm::vec3> polygon_;
    std::vector<std::uint32_t> vertices_, triangles_;  // Of a face.
};

PolygonTable::PolygonTable(const Cage& cage)
    : cage_(cage), isHole_(holesOf(cage)), pointOf_(cage.positions.size(), none) {
    result_.faceSize = 3;
    numberPoints();
    std::size_t corner = 0;
    for (std::uint32_t face = 0; face < cage.faceSizes.size(); ++face) {
        if (!isHole_[face]) addFace(face, corner);
        corner += cage.faceSizes[face];
    }
}

void PolygonTable::numberPoints() {
    std::size_t corner = 0;
    for (std::size_t face = 0; face < cage_.faceSizes.size(); ++face) {
        const std::size_t end = corner + cage_.faceSizes[face];
        if (isHole_[face]) corner = end;
        for (; corner < end; ++corner) {
            std::uint32_t& point = pointOf_[cage_.faceVertices[corner]];
            if (point == none) point = result_.pointCount++;
        }
    }
}

void PolygonTable::addFace(std::uint32_t face, std::size_t firstCorner) {
    const std::size_t size = cage_.faceSizes[face];
    const auto cageVertices = std::span(cage_.faceVertices).subspan(firstCorner, size);
    polygon_.clear();
    for (const std::uint32_t vertex : cageVertices) polygon_.push_back(cage_.positions[vertex]);
    const Derivatives derivatives = derivativesOf(polygon_);
    vertices_.clear();
    for (std::uint32_t corner = 0; corner < size; ++corner) {
        const std::uint32_t point = pointOf_[cageVertices[corner]];
        const bool isSeamVertex = point != pointsSeen_;
        vertices_.push_back(isSeamVertex ? addSeamVertex(point) : pointsSeen_++);
        appendStencil(isSeamVertex ? seamPositions_ : result_.positions, derivatives, corner, cageVertices);
        if (cage_.uvs.empty()) continue;
        appendStencil(isSeamVertex ? seamUvs_ : result_.uvs, derivatives, corner,
                      std::span(cage_.faceUvs).subspan(firstCorner, size));
    }
    triangles_.clear();
    triangulate(polygon_, triangles_);
    for (const std::uint32_t corner : triangles_) result_.faceVertices.push_back(vertices_[corner]);
    result_.cageFaces.insert(result_.cageFaces.end(), triangles_.size() / 3, face);
}

std::uint32_t PolygonTable::addSeamVertex(std::uint32_t point) {
    result_.seamPoints.push_back(point);
    return static_cast<std::uint32_t>(result_.vertexCount() - 1);
}

RefinedCage PolygonTable::take() {
    appendStencils(result_.positions, seamPositions_);
    appendStencils(result_.uvs, seamUvs_);
    return std::move(result_);
}

}  // namespace

RefinedCage cagePolygons(const Cage& cage) {
    requireFaces(cage, ErrorContext("cage", {}, cage.name));
    return PolygonTable(cage).take();
}

}  // namespace candela
