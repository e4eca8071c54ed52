#pragma once

#include <vector>

#include "document.h"

namespace candela_plugins::gltf {

inline constexpr std::uint32_t jointsPerSet = 4;

/// How many pairs JOINTS_0 and WEIGHTS_0, JOINTS_1 and WEIGHTS_1, ... a primitive has. Throws `Failure` for
/// `element` where one of a pair is missing.
std::uint32_t influenceSets(const tinygltf::Primitive& primitive, const std::string& element);

/// The joints of each vertex and their weights.
struct Influences {
    std::vector<std::uint32_t> joints;  ///< `jointsPerSet` × sets a vertex; 0 where the weight is.
    std::vector<float> weights;         ///< As many; none below 0, and not all 0.
};

/// Reads `sets` pairs. Throws `Failure` for `element`, also when weights are negative or all 0.
Influences readInfluences(const Document& document, const tinygltf::Primitive& primitive, std::uint32_t sets,
                          std::size_t vertices, const std::string& element);

/// The position offsets of a morph target of a primitive, 3 numbers a vertex; zeros where the target has
/// none. Throws `Failure` for `element`, the primitive.
std::vector<float> readMorphOffsets(const Document& document, const tinygltf::Primitive& primitive,
                                    std::size_t target, std::size_t vertices, const std::string& element);

/// The morph weights of the mesh of a node: those of the node, else those of the mesh, else zeros. Throws
/// `Failure` that names node or mesh when their number is not `targets`.
std::vector<float> morphWeights(const Document& document, std::size_t node, std::uint32_t targets);

}  // namespace candela_plugins::gltf
