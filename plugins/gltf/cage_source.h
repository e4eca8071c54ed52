#pragma once

#include <optional>
#include <vector>

#include "../common/host.h"
#include "document.h"
#include "materials.h"
#include "primitives.h"

namespace candela_plugins::gltf {

/// The vertices of a mesh's primitives one after the other, as the file has them: split along seams.
struct CageVertices {
    std::uint32_t count = 0;
    std::vector<float> positions;  ///< 3 a vertex.
    std::vector<float> uvs;        ///< 2 a vertex; empty where the cage has none.
    std::uint32_t influenceCount = 0;
    std::vector<std::uint32_t> joints;             ///< `influenceCount` a vertex; 0 where the weight is.
    std::vector<float> jointWeights;               ///< `influenceCount` a vertex, none of them below 0.
    std::vector<std::vector<float>> morphOffsets;  ///< For each target 3 a vertex.
};

/// A run of `CageVertices`.
struct VertexRange {
    std::uint32_t first = 0, count = 0;
};

/// The indices of the vertices of a mesh in the settings of a cage: counted through its primitives in order.
class VertexNumbers {
  public:
    /// The next primitive has these vertices; several primitives may share them.
    void add(VertexRange range) { ranges_.push_back(range); }
    std::uint64_t count() const;
    /// The vertex of this number in `CageVertices`; none when it is not less than `count`.
    std::optional<std::uint32_t> find(std::uint32_t number) const;

  private:
    std::vector<VertexRange> ranges_;
};

/// The materials of a cage's faces in a variant.
struct VariantFaces {
    std::uint32_t variant = 0;
    std::vector<std::int32_t> materials;  ///< A face, as `CageSource::faceMaterials`.
};

/// The data of the primitives of a mesh that becomes a cage.
struct CageSource {
    CageVertices vertices;
    Polygons faces;
    std::vector<std::int32_t> faceMaterials;  ///< A material of the file a face; -1: the default.
    std::vector<VariantFaces> variants;       ///< Those that a primitive has a material of its own for.
    VertexNumbers numbers;
};

/// Reads the primitives of a mesh, whose materials have the texture coordinates `uvSlots`, and notes what a
/// cage leaves out of them. Throws `Failure`.
CageSource readCageSource(const Document& document, std::size_t mesh, const std::vector<UvSlots>& uvSlots,
                          const Host& host);

}  // namespace candela_plugins::gltf
