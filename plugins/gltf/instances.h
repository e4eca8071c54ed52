#pragma once

#include <array>
#include <optional>
#include <vector>

#include "../common/host.h"
#include "document.h"

namespace candela_plugins::gltf {

/// A transform relative to a node.
struct Placement {
    std::array<float, 3> translation{0.0f, 0.0f, 0.0f};
    std::array<float, 4> rotation{0.0f, 0.0f, 0.0f, 1.0f};  ///< x, y, z, w, of unit length.
    std::array<float, 3> scale{1.0f, 1.0f, 1.0f};
};

/// Where EXT_mesh_gpu_instancing places the mesh of a node; none for a node without the extension. An
/// attribute that cannot be read is left out with a note, and where all of them are, the mesh is placed once.
std::optional<std::vector<Placement>> instancesOf(const Document& document, std::size_t node,
                                                  const Host& host);

}  // namespace candela_plugins::gltf
