#pragma once

#include <cstdint>
#include <span>

#include "face_grid.h"
#include "given_cage.h"
#include "limit_surface.h"
#include "stencil_table.h"

namespace candela_opensubdiv {

/// Rows of positions, and of texture coordinates where the cage has some; as many of both.
struct VertexRows {
    StencilTable positions, uvs;
};

/// Evaluates the surface into rows. Each thread has its own.
class StencilBuilder {
  public:
    /// `uvs` is NULL for a cage without texture coordinates.
    StencilBuilder(const GivenCage& cage, const LimitSurface& positions, const LimitSurface* uvs,
                   std::uint32_t level);

    /// Adds a row for each of some slots of a face.
    void add(std::uint32_t face, const FaceGrid& grid, std::span<const std::uint32_t> slots,
             VertexRows& rows);

  private:
    bool isDegenerate(const RowSum& row) const;

    const GivenCage& cage_;
    const LimitSurface& positions_;
    const LimitSurface* uvs_;
    double step_;  ///< Of a face's parameters from one vertex to the next.
    RowSum position_, positionInside_, uv_, uvInside_;
};

}  // namespace candela_opensubdiv
