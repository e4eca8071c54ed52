#pragma once

#include <vector>

#include "../common/host.h"
#include "document.h"
#include "materials.h"

namespace candela_plugins::gltf {

/// The host's meshes for each mesh of the file. A mesh becomes one, or several where its primitives differ in
/// the attributes they have; none when it is not used, is a cage, or draws no triangles.
using MeshParts = std::vector<std::vector<std::int32_t>>;

/// Adds the meshes marked in `used` that are not cages, and notes what is not drawn. Materials have
/// been added with the file's indices and read the texture coordinates `uvSets`. Progress goes from `from`
/// to `to`.
MeshParts addMeshes(const Document& document, const std::vector<bool>& used,
                    const std::vector<UvSets>& uvSets, const Host& host, double from, double to);

}  // namespace candela_plugins::gltf
