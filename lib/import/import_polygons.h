#pragma once

#include "import/abi_reader.h"

#include <candela/mesh.h>
#include <candela/plugin.h>

#include <cstdint>
#include <vector>

namespace candela {

/// The faces of a mesh that was pushed with `face_sizes`. Corners are counted face after face.
class PushedPolygons {
  public:
    /// Refuses faces of less than three corners, and sizes that do not add up to index_count.
    PushedPolygons(const candela_mesh& pushed, const AbiReader& element);

    /// Cuts the faces into triangles. The mesh's indices are a vertex a corner, and in range.
    void cut(Mesh& mesh) const;

    /// The corners of `run`, which has to begin and end at borders between faces, as indices of the cut mesh.
    /// `label` is what messages call it: "submesh 0".
    Submesh translated(const Submesh& run, const std::string& label) const;

  private:
    std::uint32_t faceBeginningAt(std::uint64_t corner, const std::string& what) const;
    std::uint32_t indexOf(std::uint32_t face) const;

    const AbiReader& element_;
    std::vector<std::uint32_t> starts_;  // The first corner of each face, and the number of all corners.
};

}  // namespace candela
