#pragma once

#include <candela/mesh.h>

#include <cstdint>
#include <vector>

namespace candela {

/// How many of a mesh's sets of texture coordinates are uv0 and uv1.
inline constexpr std::uint32_t basicUvSets = 2;

/// Set `set` of the texture coordinates of a mesh; empty where it has no such set.
inline const std::vector<glm::vec2>& uvsOf(const Mesh& mesh, std::uint32_t set) {
    static const std::vector<glm::vec2> none;
    if (set < basicUvSets) return set == 0 ? mesh.uv0 : mesh.uv1;
    return set - basicUvSets < mesh.furtherUvs.size() ? mesh.furtherUvs[set - basicUvSets] : none;
}

/// A bit for each set of texture coordinates that a surface has.
using UvSets = std::uint32_t;
static_assert(maxUvSets <= 32);

inline UvSets uvSetsOf(const Mesh& mesh) {
    UvSets sets = 0;
    for (std::uint32_t set = 0; set < basicUvSets + mesh.furtherUvs.size(); ++set)
        sets |= uvsOf(mesh, set).empty() ? 0u : 1u << set;
    return sets;
}

}  // namespace candela
