#include "agreement.h"

#include "reference.h"
#include "refining.h"
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
/// What Far and Bfr differ by themselves, although both calculate in double precision: up to 1e-9 for the
/// Loop scheme, whose limit masks they hold in other forms. Derivatives near extraordinary vertices are
/// scaled by 2^level.
constexpr double doubleNoise = 1e-8;

/// A row of the table as a number a column, and how far rounding may have moved it.
struct TableRow {
    ReferenceRow weights, slack;
};

TableRow tableRow(const StencilTable& rows, std::uint32_t row, std::size_t columns) {
    const std::vector<double> zeros(columns, 0.0);
    TableRow result{{zeros, zeros, zeros}, {zeros, zeros, zeros}};
    for (std::uint32_t entry = rows.rowStarts[row]; entry < rows.rowStarts[row + 1]; ++entry) {
        const std::uint32_t column = rows.columns[entry];
        const auto add = [&](std::vector<double> ReferenceRow::*member, float weight) {
            (result.weights.*member)[column] += weight;
            (result.slack.*member)[column] += halfUlp * std::abs(weight);
        };
        add(&ReferenceRow::value, rows.weights[entry]);
        add(&ReferenceRow::du, rows.duWeights[entry]);
        add(&ReferenceRow::dv, rows.dvWeights[entry]);
    }
    return result;
}

/// By how much a row differs from the reference beyond what rounding explains.
double excess(const TableRow& row, const ReferenceRow& reference, std::vector<double> ReferenceRow::*member) {
    double maximum = 0.0;
    for (std::size_t i = 0; i < (reference.*member).size(); ++i) {
        const double difference = std::abs((row.weights.*member)[i] - (reference.*member)[i]);
        maximum = std::max(maximum, difference - (row.slack.*member)[i]);
    }
    return maximum;
}

glm::dvec3 applied(const std::vector<double>& weights, const std::vector<glm::vec3>& points) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * glm::dvec3(points[i]);
    return sum;
}

std::vector<glm::vec3> raised(const std::vector<glm::vec2>& uvs) {
    std::vector<glm::vec3> points;
    for (const glm::vec2& uv : uvs) points.emplace_back(uv, 0.0f);
    return points;
}

/// Which corner of its face lies there.
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
/// the plugin may look for the normal a little inside.
std::optional<glm::dvec3> normalOf(const ReferenceRow& row, const std::vector<glm::vec3>& points) {
    const glm::dvec3 du = applied(row.du, points), dv = applied(row.dv, points);
    const glm::dvec3 normal = glm::cross(du, dv);
    const double longer = std::max(glm::dot(du, du), glm::dot(dv, dv));
    if (glm::length(normal) < 2e-4 * longer || longer < 1e-8) return std::nullopt;
    return glm::normalize(normal);
}

/// The worst difference of a kind, and where it was.
class Worst {
  public:
    explicit Worst(const char* kind) : kind_(kind) {}

    void take(double difference, const GridVertex& at) {
        if (difference <= worst_) return;
        worst_ = difference;
        at_ = at;
    }

    void expectAtMost(double bound, const std::string& context) const {
        EXPECT_LE(worst_, bound) << context << ", " << kind_ << " at face " << at_.face << ", patch "
                                 << at_.patch << ", (" << at_.s << ", " << at_.t << ")";
    }

  private:
    const char* kind_;
    double worst_ = 0.0;
    GridVertex at_{};
};

struct References {
    std::string name;
    ReferenceRows positions, uvs;  ///< No rows of uvs where they are not compared.
};

void expectRows(const Cage& cage, const RefinedCage& refined, const std::vector<GridVertex>& vertices,
                const References& reference) {
    Worst value("position"), derivative("derivative"), normal("normal"), uv("uv"),
        uvDerivative("uv derivative");
    std::vector<bool> seen(refined.vertexCount(), false);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const GridVertex& at = vertices[i];
        const ReferenceRow& wanted = reference.positions[i];
        // All faces agree on the positions of shared points; so they agree with those of each face.
        const TableRow point = tableRow(refined.positions, refined.pointOf(at.vertex), cage.positions.size());
        value.take(excess(point, wanted, &ReferenceRow::value), at);
        const TableRow row = tableRow(refined.positions, at.vertex, cage.positions.size());
        const std::optional<glm::dvec3> wantedNormal = normalOf(wanted, cage.positions);
        const std::optional<glm::dvec3> tableNormal = normalOf(row.weights, cage.positions);
        // The first face that has a vertex owns it: its parameters are those of the derivatives.
        const bool compareDerivatives = wantedNormal && !seen[at.vertex];
        seen[at.vertex] = true;
        if (wantedNormal && tableNormal) normal.take(glm::length(*wantedNormal - *tableNormal), at);
        if (compareDerivatives) {
            derivative.take(excess(row, wanted, &ReferenceRow::du), at);
            derivative.take(excess(row, wanted, &ReferenceRow::dv), at);
        }
        if (reference.uvs.empty()) continue;
        const TableRow uvRow = tableRow(refined.uvs, at.vertex, cage.uvs.size());
        uv.take(excess(uvRow, reference.uvs[i], &ReferenceRow::value), at);
        if (!compareDerivatives) continue;
        uvDerivative.take(excess(uvRow, reference.uvs[i], &ReferenceRow::du), at);
        uvDerivative.take(excess(uvRow, reference.uvs[i], &ReferenceRow::dv), at);
    }
    const double bound = doubleNoise * static_cast<double>(1u << refined.level);
    const std::string context = cage.name + " by " + reference.name;
    for (const Worst* worst : {&value, &derivative, &uv, &uvDerivative}) worst->expectAtMost(bound, context);
    // Weights rounded by 6e-8, where du × dv is no less than 2e-4 of what they make of it.
    normal.expectAtMost(2e-3, context);
}

bool hasSemiSharpChaikin(const Cage& cage) {
    return cage.creaseMethod == CreaseMethod::chaikin && semiSharpLevels(cage) != 0;
}

/// Whether Bfr itself gives the surface that uniform refinement has. (OpenSubdiv 3.5.0: see LimitSurface.)
bool isExactInBfr(const Cage& cage, Primvar primvar) {
    if (hasSemiSharpChaikin(cage)) return false;
    const bool sharpensByNeighbours =
        cage.faceVaryingInterpolation == FaceVaryingInterpolation::cornersPlus1 ||
        cage.faceVaryingInterpolation == FaceVaryingInterpolation::cornersPlus2;
    const bool isSharp = !cage.creases.empty() || !cage.corners.empty();
    return primvar == Primvar::position || !(sharpensByNeighbours && isSharp);
}

/// Whether adaptive refinement gives what uniform refinement does. Far 3.5.0 does not refine beyond holes,
/// which with a boundary that is not interpolated all its faces are, and loses Chaikin creases there: weights
/// are off by some 1e-4.
bool isExactInFar(const Cage& cage) {
    const bool hasHoles = !cage.holes.empty() || cage.boundaryInterpolation == BoundaryInterpolation::none;
    return !(hasHoles && hasSemiSharpChaikin(cage));
}

void expectVertices(const Cage& cage, const RefinedCage& refined, const std::vector<GridVertex>& vertices) {
    const UniformLimit limit = uniformLimit(cage);
    Worst position("position"), uv("uv");
    std::vector<std::size_t> starts{0};
    for (const std::uint32_t size : cage.faceSizes) starts.push_back(starts.back() + size);
    for (const GridVertex& at : vertices) {
        const std::optional<std::uint32_t> local = cornerAt(cage, at);
        if (!local) continue;
        const std::size_t corner = starts[at.face] + *local;
        const TableRow row = tableRow(refined.positions, refined.pointOf(at.vertex), cage.positions.size());
        position.take(glm::length(applied(row.weights.value, cage.positions) -
                                  limit.positions[cage.faceVertices[corner]]),
                      at);
        if (cage.uvs.empty()) continue;
        const TableRow uvRow = tableRow(refined.uvs, at.vertex, cage.uvs.size());
        uv.take(glm::length(applied(uvRow.weights.value, raised(cage.uvs)) - limit.uvs[corner]), at);
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
    expectRows(cage, refined, vertices, far);
    if (isExactInFar(cage)) expectVertices(cage, refined, vertices);
    if (!isExactInBfr(cage, Primvar::position)) return;
    References bfr{"Bfr", bfrReference(cage, level, vertices, Primvar::position), {}};
    if (!cage.uvs.empty() && isExactInBfr(cage, Primvar::uv)) {
        bfr.uvs = bfrReference(cage, level, vertices, Primvar::uv);
    }
    expectRows(cage, refined, vertices, bfr);
}

}  // namespace candela
