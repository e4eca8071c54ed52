#pragma once

#include <optional>

#include "failure.h"

namespace candela_gltf {

/// The two parts of a glTF file.
struct Container {
    Bytes json;
    std::optional<Bytes> binary;  ///< The BIN chunk of a .glb file, if it has one.
};

/// Tells a .glb from a .gltf by its first bytes and takes it apart. Throws `Failure` when a .glb does not
/// keep to section 4.4 of the glTF 2.0 specification.
Container openContainer(const Bytes& file);

}  // namespace candela_gltf
