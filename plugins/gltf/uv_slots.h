#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "texture_uses.h"

namespace candela_plugins::gltf {

/// How many sets of texture coordinates a mesh of the host may have.
inline constexpr std::size_t maxUvSlots = 18;

/// The sets of texture coordinates of the file, n of TEXCOORD_n, that the host's sets hold for a material.
struct UvSlots {
    std::vector<int> sets{0, 1};            ///< Two or more, `maxUvSlots` at most.
    std::array<bool, maxUvSlots> isRead{};  ///< Whether a texture of the material reads it.
    std::map<int, int> equals;              ///< Sets that hold the same numbers as another one, by set.

    /// The host's set for a set of the file; -1 where the material reads more sets than there are.
    int find(int set) const;
    /// The attribute that the host's set `slot` holds: "TEXCOORD_0". Empty where there is no such set.
    std::string attribute(std::size_t slot) const;
};

/// The slots of each material; those that a primitive has in different variants have the same. TEXCOORD_0 and
/// TEXCOORD_1 are in their own ones where they are read. Where a material reads more than two sets, those
/// with the same accessors become one; of what is left, those of its first textures are taken, `most` sets.
std::vector<UvSlots> uvSlotsOf(const Document& document, std::size_t most);

/// The slots of a primitive's materials, and which of them any of them reads.
UvSlots uvSlotsOf(const tinygltf::Primitive& primitive, const std::vector<UvSlots>& ofMaterials);

}  // namespace candela_plugins::gltf
