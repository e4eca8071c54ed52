#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "../common/host.h"
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

/// How many vertices a primitive and how many joints its skin has.
struct InfluenceLimits {
    std::size_t vertices = 0;
    std::size_t joints = std::numeric_limits<std::size_t>::max();
};

/// Reads `sets` pairs. Weights below 0 are taken as 0, joints beyond the limit are left out, and a vertex
/// without a weight follows the first joint; notes say so. Throws `Failure` for `element`.
Influences readInfluences(const Document& document, const tinygltf::Primitive& primitive, std::uint32_t sets,
                          const InfluenceLimits& limits, const std::string& element, const Host& host);

/// The offsets of `attribute` ("POSITION") of a morph target of a primitive, 3 numbers a vertex; empty where
/// the target has none. Throws `Failure` for `element`, the primitive.
std::vector<float> readMorphOffsets(const Document& document, const tinygltf::Primitive& primitive,
                                    std::size_t target, const char* attribute, std::size_t vertices,
                                    const std::string& element);

/// The morph weights of the mesh of a node: those of the node, else those of the mesh, else zeros. Throws
/// `Failure` that names node or mesh when their number is not `targets`.
std::vector<float> morphWeights(const Document& document, std::size_t node, std::uint32_t targets);

/// The skins of the host, which are added when a node first needs them.
class Skins {
  public:
    /// `nodes` are the host's indices of the file's nodes.
    Skins(const Document& document, const std::vector<std::int32_t>& nodes, const Host& host);

    /// The host's index of a skin of the file; -1, with a note, where a joint is not part of the scene that
    /// is drawn, or the skin cannot be read.
    std::int32_t find(std::size_t skin);

  private:
    std::int32_t add(std::size_t skin) const;

    const Document& document_;
    const std::vector<std::int32_t>& nodes_;
    const Host& host_;
    std::vector<std::optional<std::int32_t>> indices_;
};

}  // namespace candela_plugins::gltf
