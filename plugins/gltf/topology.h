#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace candela_gltf {

/// Whether primitives of this glTF mode are triangles: TRIANGLES, TRIANGLE_STRIP or TRIANGLE_FAN.
bool hasTriangles(int mode);

/// The triangles, three indices each, of a primitive with these corners, in the orders of glTF 2.0, 3.7.2.1.
/// Throws `Failure` for `element` when the number of corners does not fit the mode.
std::vector<std::uint32_t> triangulate(int mode, std::vector<std::uint32_t> corners,
                                       const std::string& element);

}  // namespace candela_gltf
