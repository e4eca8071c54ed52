#include "generated_cages.h"
#include "plugin_refinement.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <array>

namespace candela {
namespace {

/// The uniform cubic B-spline basis at t, from 0 to 1, and its derivative.
std::array<double, 4> basis(double t) {
    const double u = 1.0 - t;
    return {u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
            (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0, t * t * t / 6.0};
}

std::array<double, 4> basisDerivative(double t) {
    const double u = 1.0 - t;
    return {-u * u / 2.0, (9.0 * t * t - 12.0 * t) / 6.0, (-9.0 * t * t + 6.0 * t + 3.0) / 6.0, t * t / 2.0};
}

/// The sum over the 4 × 4 vertices of a sheet around the face in column i and row j.
glm::dvec3 tensorProduct(const Cage& cage, std::uint32_t columns, std::uint32_t i, std::uint32_t j,
                         const std::array<double, 4>& across, const std::array<double, 4>& along) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t row = 0; row < 4; ++row) {
        for (std::uint32_t column = 0; column < 4; ++column) {
            const std::uint32_t vertex = (j + row - 1) * (columns + 1) + (i + column - 1);
            sum += across[column] * along[row] * glm::dvec3(cage.positions[vertex]);
        }
    }
    return sum;
}

TEST(RegularGrid, isABicubicBSpline) {
    constexpr std::uint32_t columns = 6, rows = 5;
    Random random(11);
    Cage cage = sheet(columns, rows);
    jitter(cage, 0.4f, random);
    for (const std::uint32_t level : {1u, 2u, 5u}) {
        const RefinedCage refined = refineWithPlugin(cage, level);
        const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
        for (const GridVertex& at : gridVertices(cage, refined)) {
            const std::uint32_t i = at.face % columns, j = at.face / columns;
            if (i == 0 || j == 0 || i + 1 == columns || j + 1 == rows) continue;
            // 16 products of weights up to 4/9 with coordinates up to 7, each rounded by 6e-8.
            constexpr double bound = 5e-6;
            const glm::dvec3 position = tensorProduct(cage, columns, i, j, basis(at.s), basis(at.t));
            EXPECT_LT(glm::length(position - glm::dvec3(limit.positions[at.vertex])), bound);
            const glm::dvec3 du = tensorProduct(cage, columns, i, j, basisDerivative(at.s), basis(at.t));
            const glm::dvec3 dv = tensorProduct(cage, columns, i, j, basis(at.s), basisDerivative(at.t));
            // All faces of a sheet have the same parameter directions, so that shared vertices have the same
            // derivatives.
            EXPECT_LT(glm::length(du - glm::dvec3(limit.du[at.vertex])), bound);
            EXPECT_LT(glm::length(dv - glm::dvec3(limit.dv[at.vertex])), bound);
            EXPECT_LT(glm::length(glm::normalize(glm::cross(du, dv)) - glm::dvec3(limit.normals[at.vertex])),
                      2e-5);
        }
    }
}

}  // namespace
}  // namespace candela
