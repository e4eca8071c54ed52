#pragma once

#include <vector>

#include "document.h"

namespace candela_gltf {

/// The offsets by which a morph target of a primitive moves its vertices, 3 numbers each; zeros where the
/// target does not move positions. Throws `Failure` for `element`, the primitive.
std::vector<float> readMorphOffsets(const Document& document, const tinygltf::Primitive& primitive,
                                    std::size_t target, std::size_t vertices, const std::string& element);

/// The weights of the morph targets of a mesh as a node shows it: those of the node, else those of the mesh,
/// else zeros. Throws `Failure` that names node or mesh when their number is not `targets`.
std::vector<float> morphWeights(const Document& document, std::size_t node, std::uint32_t targets);

}  // namespace candela_gltf
