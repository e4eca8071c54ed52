#pragma once

#include <vector>

#include "../common/host.h"
#include "document.h"
#include "materials.h"

namespace candela_plugins::gltf {

/// A mesh of the host.
struct AddedMesh {
    std::int32_t index = -1;
    bool hasJoints = false;  ///< A skin can move it.
    std::uint32_t morphTargetCount = 0;
};

/// The host's meshes for each mesh of the file. A mesh becomes one, or several where its primitives differ in
/// the attributes they have; none when it is not used, is a cage, or draws nothing.
using MeshParts = std::vector<std::vector<AddedMesh>>;

/// Adds the meshes marked in `used` that are not cages, and notes what is not drawn of them: primitives that
/// are broken are left out. Materials have been added with the file's indices. Progress goes from `from` to
/// `to`.
MeshParts addMeshes(Document& document, const std::vector<bool>& used, const AddedMaterials& materials,
                    const Host& host, double from, double to);

}  // namespace candela_plugins::gltf
