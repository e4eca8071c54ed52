#pragma once

#include <candela/plugin.h>

#include <cstdint>
#include <span>
#include <vector>

#include "cage.h"
#include "face_grid.h"
#include "limit_surface.h"
#include "stencil_list.h"

namespace candela_plugins::opensubdiv {

/// Replaces the derivatives of a stencil by those of another, which may have other indices.
void replaceDerivatives(LimitStencil& stencil, const LimitStencil& other);

/// A weighted point of a stencil, in single precision.
struct StencilEntry {
    std::uint32_t index;
    float value, du, dv;
};

/// Stencils in single precision, appended one after the other.
struct StencilBuffer {
    std::vector<std::uint32_t> sizes;  ///< The number of entries of each stencil.
    std::vector<StencilEntry> entries;

    /// Rounds to single precision, and drops the entries whose weights are all 0.
    void add(const LimitStencil& stencil);
};

/// The concatenation of stencil buffers in the layout of the host.
class StencilTable {
  public:
    /// Empties the buffers. Throws `Failure` when 32 bits cannot count the entries.
    explicit StencilTable(std::span<StencilBuffer* const> buffers);

    /// Valid as long as the table.
    candela_stencil_table view() const;

  private:
    std::vector<std::uint32_t> offsets_{0};
    std::vector<std::uint32_t> indices_;
    std::vector<float> weights_, duWeights_, dvWeights_;
};

/// A stencil of each vertex for the position, and one for the texture coordinates where the cage has some.
struct VertexStencils {
    StencilBuffer positions, uvs;
};

/// Builds the stencils of vertices. Each worker has its own builder.
class StencilBuilder {
  public:
    /// `uvs` is NULL for a cage without texture coordinates.
    StencilBuilder(const CheckedCage& cage, const LimitSurface& positions, const LimitSurface* uvs,
                   std::uint32_t level);

    /// Adds a stencil for each of the given slots of a face.
    void add(std::uint32_t face, const FaceGrid& grid, std::span<const std::uint32_t> slots,
             VertexStencils& stencils);

  private:
    bool isDegenerate(const LimitStencil& stencil) const;

    const CheckedCage& cage_;
    const LimitSurface& positions_;
    const LimitSurface* uvs_;
    double step_;  ///< The distance of neighbouring vertices in the parameters of a face.
    LimitStencil position_, positionInside_, uv_, uvInside_;
};

}  // namespace candela_plugins::opensubdiv
