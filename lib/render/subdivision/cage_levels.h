#pragma once

#include "render/subdivision/cage_edges.h"
#include "render/subdivision/gpu_stencil_table.h"

#include <candela/gpu_scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace candela {

/// A cage and its tables. They are made when they are first asked for, and kept.
class CageLevels {
  public:
    /// `noMaterial` stands for faces without a material. Both references have to outlive the object. Without
    /// a subdivider there is one level, 0: the cage's polygons.
    CageLevels(const Cage& cage, const std::optional<Subdivider>& subdivider, std::uint32_t noMaterial);

    const Cage& cage() const { return cage_; }
    const CageMaterials& materials() const { return materials_; }
    std::span<const CageEdge> edges() const { return edges_; }

    /// The level where the size on the screen does not decide.
    std::optional<std::uint32_t> fixedLevel(const SubdivisionSettings& settings) const;
    /// The greatest level where it does.
    std::uint32_t greatest(const SubdivisionSettings& settings) const;

    /// Throws what `Subdivider::refine` does.
    GpuStencilTable& table(std::uint32_t level);
    /// Memory of the weights of all tables, bytes.
    std::uint64_t tableBytes() const;

    /// The edges of the cage.
    const LineIndices& edgeLines();

  private:
    const Cage& cage_;
    const std::optional<Subdivider>& subdivider_;
    CageMaterials materials_;
    std::vector<CageEdge> edges_;
    std::map<std::uint32_t, GpuStencilTable> tables_;
    std::optional<LineIndices> edgeLines_;
};

}  // namespace candela
