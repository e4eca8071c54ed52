#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../common/host.h"
#include "document.h"
#include "numbers.h"

namespace candela_plugins::gltf {

/// What a primitive draws: triangles, lines or points.
struct Elements {
    candela_topology topology;
    std::size_t corners;  ///< Of one of them.
    const char* name;     ///< Of one of them.
};

/// Of a glTF mode.
const Elements& elementsOf(int mode);

/// The indices of the triangles, lines or points of a primitive with these vertices. They may name vertices
/// that do not exist. Corners beyond the last whole element of a list are left out with a note. Throws
/// `Failure` for `element` when there are too few.
Numbers<std::uint32_t> readElements(const Document& document, const tinygltf::Primitive& primitive,
                                    std::uint32_t vertices, const Host& host, const std::string& element);

/// Keeps the elements of which all vertices are usable.
template <typename IsUsable>
void keepElements(std::vector<std::uint32_t>& indices, const Elements& elements, const IsUsable& isUsable) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < indices.size(); i += elements.corners) {
        if (!std::all_of(&indices[i], &indices[i] + elements.corners, isUsable)) continue;
        std::copy_n(&indices[i], elements.corners, &indices[kept]);
        kept += elements.corners;
    }
    indices.resize(kept);
}

}  // namespace candela_plugins::gltf
