#pragma once

#include "render/gpu_scene/gpu_meshes.h"
#include "render/subdivision/cage_edges.h"

#include <candela/gpu_scene.h>

#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The materials of the faces of a cage.
struct CageMaterials {
    std::vector<std::uint32_t> materials;   ///< Each once.
    std::vector<std::uint32_t> slotOfFace;  ///< Index into `materials`, one a face.
};

/// `none` stands for faces without a material.
CageMaterials materialsOf(const Cage& cage, std::uint32_t none);

/// A cage refined to one level, on the device: the triangles, the texture coordinates and, for the compute
/// evaluator, the weights. None of this changes while the surface moves.
class GpuStencilTable {
  public:
    GpuStencilTable(const Cage& cage, const CageMaterials& materials, RefinedCage refined);

    const RefinedCage& refined() const { return refined_; }
    /// Memory of the weights, bytes.
    std::uint64_t bytes() const;

    /// The maximum number of entries of a stencil of positions.
    std::uint32_t maxStencilSize() const { return maxStencilSize_; }

    const gl::Buffer& indices() const { return indices_; }
    /// Of the indices, one a slot of the materials.
    std::span<const IndexRange> ranges() const { return ranges_; }
    std::uint64_t triangles() const { return triangles_; }

    /// vec2 a vertex; none where the cage has no texture coordinates.
    const gl::Buffer* uvs() const { return uvs_ ? &*uvs_ : nullptr; }
    /// Derivatives of the texture coordinates, (du, dv) a vertex. Created on first use; `cage` is that
    /// of the constructor.
    std::span<const glm::vec4> uvDerivatives(const Cage& cage);

    /// The edges of the faces. Created on first use.
    const EdgeIndices& faceEdges();

    /// The weights as shaders/cage_limit.comp reads them. Created on first use.
    struct Storage {
        static constexpr std::size_t entryBytes = 16;
        gl::Buffer offsets, entries;
    };
    const Storage& storage();
    /// What `uvDerivatives` has returned, for the same shader. Created on first use.
    const gl::Buffer& uvDerivativeBuffer();

  private:
    void createTriangles(const CageMaterials& materials);

    RefinedCage refined_;
    std::vector<IndexRange> ranges_;
    std::uint64_t triangles_ = 0;
    std::uint32_t maxStencilSize_ = 0;
    gl::Buffer indices_;
    std::optional<gl::Buffer> uvs_;
    std::vector<glm::vec4> uvDerivatives_;
    std::optional<EdgeIndices> faceEdges_;
    std::optional<Storage> storage_;
    std::optional<gl::Buffer> uvDerivativeBuffer_;
};

/// A cage and its stencil tables, which are created on first use and kept.
class CageTables {
  public:
    /// `noMaterial` stands for faces without a material. `subdivider` has to outlive the object. Without one
    /// there is one level, 0: the cage's polygons.
    CageTables(const Cage& cage, const std::optional<Subdivider>& subdivider, std::uint32_t noMaterial);
    CageTables(const CageTables&) = delete;
    CageTables& operator=(const CageTables&) = delete;

    const Cage& cage() const { return cage_; }
    const CageMaterials& materials() const { return materials_; }
    std::span<const CageEdge> edges() const { return edges_; }

    /// The level where the size on the screen does not decide.
    std::optional<std::uint32_t> fixedLevel(const SubdivisionSettings& settings) const;
    /// The maximum level where it does.
    std::uint32_t maxLevel(const SubdivisionSettings& settings) const;

    /// Throws what `Subdivider::refine` does.
    GpuStencilTable& table(std::uint32_t level);
    /// Memory of the weights of all tables, bytes.
    std::uint64_t tableBytes() const;

    /// The edges of the cage. Created on first use.
    const EdgeIndices& cageEdges();

  private:
    Cage cage_;
    const std::optional<Subdivider>& subdivider_;
    CageMaterials materials_;
    std::vector<CageEdge> edges_;
    std::map<std::uint32_t, GpuStencilTable> tables_;
    std::optional<EdgeIndices> cageEdges_;
};

}  // namespace candela
