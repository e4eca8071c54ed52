#pragma once

#include <candela/plugin.h>

#include <cstdint>
#include <string>

namespace candela {

/// The result of a direct call of the plugin, without the library.
struct CallResult {
    candela_status status = CANDELA_FAILED;
    bool hasResult = false;
    int failures = 0;  ///< The number of calls of `fail`.
    std::string element, reason;
};
CallResult callPlugin(const candela_cage& cage, std::uint32_t level);

/// A candela_cage of two quads side by side, with arrays that a test can change.
struct CageArrays {
    float positions[18] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, -1, 1, 0, -1, 2, 0, -1};
    std::uint32_t faceSizes[2] = {4, 4};
    std::uint32_t faceVertices[8] = {0, 1, 4, 3, 1, 2, 5, 4};
    float uvs[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    std::uint32_t faceUvs[8] = {0, 1, 2, 3, 0, 1, 2, 3};
    std::uint32_t creaseEdges[4] = {1, 4, 0, 3};
    float creaseSharpness[2] = {2, 10};
    std::uint32_t cornerVertices[1] = {5};
    float cornerSharpness[1] = {3};
    std::uint32_t holes[1] = {1};
    candela_cage cage{};

    CageArrays();
    CageArrays(const CageArrays&) = delete;  // The cage points into the arrays.
    CageArrays& operator=(const CageArrays&) = delete;
};

}  // namespace candela
