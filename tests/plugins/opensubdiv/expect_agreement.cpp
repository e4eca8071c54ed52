#include "expect_agreement.h"

#include "plugin_refinement.h"
#include "reference.h"
#include "uniform_limit.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace candela {
namespace {

/// Half a unit in the last place of single precision, relative: the table's weights are rounded once.
constexpr double halfUlp = 0x1p-24;
/// How much Far and Bfr differ from each other, although both calculate in double precision: up to 1e-9 for
/// the Loop scheme, whose limit masks they store in different forms. Derivatives near extraordinary vertices
/// are scaled by 2^level.
constexpr double doubleNoise = 1e-8;

/// A stencil of the table as one weight per control point, and the rounding error of each.
struct DenseStencil {
    ReferenceStencil weights, error;
};

DenseStencil denseStencil(const StencilTable& table, std::uint32_t stencil, std::size_t controls) {
    const std::vector<double> zeros(controls, 0.0);
    DenseStencil result{{zeros, zeros, zeros}, {zeros, zeros, zeros}};
    for (std::uint32_t entry = table.offsets[stencil]; entry < table.offsets[stencil + 1]; ++entry) {
        const std::uint32_t control = table.controlIndices[entry];
        const auto add = [&](std::vector<double> ReferenceStencil::*member, float weight) {
            (result.weights.*member)[control] += weight;
            (result.error.*member)[control] += halfUlp * std::abs(weight);
        };
        add(&ReferenceStencil::value, table.weights[entry]);
        add(&ReferenceStencil::du, table.duWeights[entry]);
        add(&ReferenceStencil::dv, table.dvWeights[entry]);
    }
    return result;
}

/// The maximum difference of a stencil from the reference beyond the rounding error.
double excess(const DenseStencil& stencil, const ReferenceStencil& reference,
              std::vector<double> ReferenceStencil::*member) {
    double maximum = 0.0;
    for (std::size_t i = 0; i < (reference.*member).size(); ++i) {
        const double difference = std::abs((stencil.weights.*member)[i] - (reference.*member)[i]);
        maximum = std::max(maximum, difference - (stencil.error.*member)[i]);
    }
    return maximum;
}

glm::dvec3 applyStencil(const std::vector<double>& weights, const std::vector<glm::vec3>& points) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * glm::dvec3(points[i]);
    return sum;
}

std::vector<glm::vec3> toPoints(const std::vector<glm::vec2>& uvs) {
    std::vector<glm::vec3> points;
    for (const glm::vec2& uv : uvs) points.emplace_back(uv, 0.0f);
    return points;
}

/// The corner of its face at this vertex; none elsewhere.
std::optional<std::uint32_t> cornerAt(const Cage& cage, const GridVertex& at) {
    const bool hasSubfaces = cage.scheme != SubdivisionScheme::loop && cage.faceSizes[at.face] != 4;
    if (at.s == 0.0 && at.t == 0.0) return at.patch;
    if (hasSubfaces) return std::nullopt;
    if (at.s == 1.0 && at.t == 0.0) return 1;
    if (cage.scheme == SubdivisionScheme::loop) return at.t == 1.0 ? std::optional(2u) : std::nullopt;
    if (at.s == 1.0 && at.t == 1.0) return 2;
    return at.s == 0.0 && at.t == 1.0 ? std::optional(3u) : std::nullopt;
}

/// du × dv at unit length; none where the derivatives are so nearly parallel, or one of them so short, that
/// the plugin may evaluate the normal at a point inside the face.
std::optional<glm::dvec3> normalOf(const ReferenceStencil& stencil, const std::vector<glm::vec3>& points) {
    const glm::dvec3 du = applyStencil(stencil.du, points), dv = applyStencil(stencil.dv, points);
    const glm::dvec3 normal = glm::cross(du, dv);
    const double longer = std::max(glm::dot(du, du), glm::dot(dv, dv));
    if (glm::length(normal) < 2e-4 * longer || longer < 1e-8) return std::nullopt;
    return glm::normalize(normal);
}

/// The maximum difference of one quantity, and its location.
class MaxDifference {
  public:
    explicit MaxDifference(const char* quantity) : quantity_(quantity) {}

    void add(double difference, const GridVertex& at) {
        if (difference <= max_) return;
        max_ = difference;
        at_ = at;
    }

    void expectAtMost(double bound, const std::string& context) const {
        EXPECT_LE(max_, bound) << context << ", " << quantity_ << " at face " << at_.face << ", patch "
                               << at_.patch << ", (" << at_.s << ", " << at_.t << ")";
    }

  private:
    const char* quantity_;
    double max_ = 0.0;
    GridVertex at_{};
};

struct References {
    std::string name;
    ReferenceStencils positions, uvs;  ///< `uvs` is empty where they are not compared.
};

void expectStencils(const Cage& cage, const RefinedCage& refined, const std::vector<GridVertex>& vertices,
                    const References& reference) {
    MaxDifference value("position"), derivative("derivative"), normal("normal"), uv("uv"),
        uvDerivative("uv derivative");
    std::vector<bool> seen(refined.vertexCount(), false);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const GridVertex& at = vertices[i];
        const ReferenceStencil& expected = reference.positions[i];
        // All faces give the same position for a shared point.
        const DenseStencil point =
            denseStencil(refined.positions, refined.pointOf(at.vertex), cage.positions.size());
        value.add(excess(point, expected, &ReferenceStencil::value), at);
        const DenseStencil stencil = denseStencil(refined.positions, at.vertex, cage.positions.size());
        const std::optional<glm::dvec3> expectedNormal = normalOf(expected, cage.positions);
        const std::optional<glm::dvec3> tableNormal = normalOf(stencil.weights, cage.positions);
        // The derivatives of a vertex are along the parameters of the first face that uses it.
        const bool compareDerivatives = expectedNormal && !seen[at.vertex];
        seen[at.vertex] = true;
        if (expectedNormal && tableNormal) normal.add(glm::length(*expectedNormal - *tableNormal), at);
        if (compareDerivatives) {
            derivative.add(excess(stencil, expected, &ReferenceStencil::du), at);
            derivative.add(excess(stencil, expected, &ReferenceStencil::dv), at);
        }
        if (reference.uvs.empty()) continue;
        const DenseStencil uvStencil = denseStencil(refined.uvs, at.vertex, cage.uvs.size());
        uv.add(excess(uvStencil, reference.uvs[i], &ReferenceStencil::value), at);
        if (!compareDerivatives) continue;
        uvDerivative.add(excess(uvStencil, reference.uvs[i], &ReferenceStencil::du), at);
        uvDerivative.add(excess(uvStencil, reference.uvs[i], &ReferenceStencil::dv), at);
    }
    const double bound = doubleNoise * static_cast<double>(1u << refined.level);
    const std::string context = cage.name + " by " + reference.name;
    for (const MaxDifference* difference : {&value, &derivative, &uv, &uvDerivative})
        difference->expectAtMost(bound, context);
    // The weights have a relative rounding error of 6e-8, and du × dv is at least 2e-4 of the longer
    // derivative squared.
    normal.expectAtMost(2e-3, context);
}

bool hasSemiSharpChaikin(const Cage& cage) {
    return cage.creaseMethod == CreaseMethod::chaikin && semiSharpLevels(cage) != 0;
}

/// Whether Bfr gives the same surface as uniform refinement. (OpenSubdiv 3.5.0: see LimitSurface.)
bool isExactInBfr(const Cage& cage, Primvar primvar) {
    if (hasSemiSharpChaikin(cage)) return false;
    const bool sharpensByNeighbors =
        cage.faceVaryingInterpolation == FaceVaryingInterpolation::cornersPlus1 ||
        cage.faceVaryingInterpolation == FaceVaryingInterpolation::cornersPlus2;
    const bool isSharp = !cage.creases.empty() || !cage.corners.empty();
    return primvar == Primvar::position || !(sharpensByNeighbors && isSharp);
}

/// Whether adaptive refinement gives the same surface as uniform refinement. Far 3.5.0 does not refine the
/// neighborhood of holes and loses Chaikin creases there: weights differ by some 1e-4. All boundary faces are
/// holes when the boundary is not interpolated.
bool isExactInFar(const Cage& cage) {
    const bool hasHoles = !cage.holes.empty() || cage.boundaryInterpolation == BoundaryInterpolation::none;
    return !(hasHoles && hasSemiSharpChaikin(cage));
}

void expectVertices(const Cage& cage, const RefinedCage& refined, const std::vector<GridVertex>& vertices) {
    const UniformLimit limit = uniformLimit(cage);
    MaxDifference position("position"), uv("uv");
    std::vector<std::size_t> starts{0};
    for (const std::uint32_t size : cage.faceSizes) starts.push_back(starts.back() + size);
    for (const GridVertex& at : vertices) {
        const std::optional<std::uint32_t> local = cornerAt(cage, at);
        if (!local) continue;
        const std::size_t corner = starts[at.face] + *local;
        const DenseStencil stencil =
            denseStencil(refined.positions, refined.pointOf(at.vertex), cage.positions.size());
        position.add(glm::length(applyStencil(stencil.weights.value, cage.positions) -
                                 limit.positions[cage.faceVertices[corner]]),
                     at);
        if (cage.uvs.empty()) continue;
        const DenseStencil uvStencil = denseStencil(refined.uvs, at.vertex, cage.uvs.size());
        uv.add(glm::length(applyStencil(uvStencil.weights.value, toPoints(cage.uvs)) - limit.uvs[corner]),
               at);
    }
    // Some 30 weights rounded by 6e-8 each at most, times coordinates up to 12.
    position.expectAtMost(1e-5, cage.name + " by uniform refinement");
    uv.expectAtMost(1e-5, cage.name + " by uniform refinement");
}

}  // namespace

void expectAgreement(const Cage& cage, std::uint32_t level) {
    const RefinedCage refined = refineWithPlugin(cage, level);
    const std::vector<GridVertex> vertices = gridVertices(cage, refined);
    if (vertices.empty()) return;
    References far{"Far", farReference(cage, level, vertices, Primvar::position), {}};
    if (!cage.uvs.empty()) far.uvs = farReference(cage, level, vertices, Primvar::uv);
    expectStencils(cage, refined, vertices, far);
    if (isExactInFar(cage)) expectVertices(cage, refined, vertices);
    if (!isExactInBfr(cage, Primvar::position)) return;
    References bfr{"Bfr", bfrReference(cage, level, vertices, Primvar::position), {}};
    if (!cage.uvs.empty() && isExactInBfr(cage, Primvar::uv)) {
        bfr.uvs = bfrReference(cage, level, vertices, Primvar::uv);
    }
    expectStencils(cage, refined, vertices, bfr);
}

}  // namespace candela
