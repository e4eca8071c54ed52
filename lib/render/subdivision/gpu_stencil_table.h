#pragma once

#include "render/gpu_scene/draw_list.h"
#include "render/subdivision/line_indices.h"

#include <candela/cage.h>
#include <candela/refined_cage.h>

#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The materials that the faces of a cage wear.
struct CageMaterials {
    std::vector<std::uint32_t> materials;   ///< Each once.
    std::vector<std::uint32_t> slotOfFace;  ///< Index into `materials`, one a face.
};

/// `none` stands for faces without a material.
CageMaterials materialsOf(const Cage& cage, std::uint32_t none);

/// A cage refined to one level, and what of it stays while the surface moves: triangles, texture coordinates
/// and, for the compute form, the weights.
class GpuStencilTable {
  public:
    GpuStencilTable(const Cage& cage, const CageMaterials& materials, RefinedCage refined);

    const RefinedCage& refined() const { return refined_; }
    /// Memory of the weights, bytes.
    std::uint64_t bytes() const;

    /// Entries of the longest row of positions.
    std::uint32_t longestRow() const { return longestRow_; }

    const gl::Buffer& indices() const { return indices_; }
    /// One a slot of the materials.
    std::span<const IndexRange> ranges() const { return ranges_; }
    std::uint64_t triangles() const { return triangles_; }

    /// vec2 a vertex; none where the cage has no texture coordinates.
    const gl::Buffer* uvs() const { return uvs_ ? &*uvs_ : nullptr; }
    /// Derivatives of the texture coordinates, (du, dv) a vertex. Made when first asked for; `cage` is that
    /// of the constructor.
    std::span<const glm::vec4> uvDerivatives(const Cage& cage);

    /// The edges of the faces. Made when first asked for.
    const LineIndices& faceLines();

    /// The weights as shaders/cage_limit.comp reads them. Made when first asked for.
    struct Storage {
        static constexpr std::size_t entryBytes = 16;
        gl::Buffer rows, entries;
    };
    const Storage& storage();
    /// What `uvDerivatives` has returned, for the same shader. Made when first asked for.
    const gl::Buffer& uvDerivativeBuffer();
    /// Frees what was made for the shader.
    void dropStorage();

  private:
    void makeTriangles(const CageMaterials& materials);

    RefinedCage refined_;
    std::vector<IndexRange> ranges_;
    std::uint64_t triangles_ = 0;
    std::uint32_t longestRow_ = 0;
    gl::Buffer indices_;
    std::optional<gl::Buffer> uvs_;
    std::vector<glm::vec4> uvDerivatives_;
    std::optional<LineIndices> faceLines_;
    std::optional<Storage> storage_;
    std::optional<gl::Buffer> uvDerivativeBuffer_;
};

}  // namespace candela
