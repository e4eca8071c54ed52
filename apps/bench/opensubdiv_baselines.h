#pragma once

#include <candela/cage.h>
#include <candela/refined_cage.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

/// OpenSubdiv's own evaluator, Osd::OmpEvaluator on all cores, over the stencil table of a refined cage: the
/// baseline of moving a cage. It evaluates positions and both tangents, but no normals.
class OmpMove {
  public:
    explicit OmpMove(const candela::RefinedCage& refined);

    void move(std::span<const glm::vec3> cagePoints);
    /// Of the last move, one a vertex of the table; seam vertices are not welded to their point.
    const std::vector<glm::vec3>& positions() const { return positions_; }

  private:
    const candela::StencilTable& table_;
    std::vector<int> sizes_, offsets_, controlIndices_;
    std::vector<glm::vec3> positions_, du_, dv_;
};

/// Builds the table of a closed cage of quads with Far alone: a topology refiner, refined adaptively to
/// `level`, and limit stencils with first derivatives at 4^level points a face. Returns the number of
/// stencils.
std::uint64_t refineWithFar(const candela::Cage& cage, std::uint32_t level);
