#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "document.h"
#include "primitives.h"
#include "uv_slots.h"

namespace candela_plugins::gltf {

/// The vertex arrays of a mesh of the host.
enum Stream : std::size_t { position, normal, tangent, color, uv0, streamCount = uv0 + maxUvSlots };

/// Numbers, vertex after vertex.
using Streams = std::array<Numbers<float>, streamCount>;

/// The accessor of each stream, or one of these where a primitive has none.
using Accessors = std::array<int, streamCount>;
constexpr int absent = -1, zeros = -2;

inline bool isUv(std::size_t stream) {
    return stream >= uv0;
}

/// Numbers a vertex, as the host has them.
std::size_t componentsOf(std::size_t stream);

/// The name of the attribute that a stream holds of a primitive whose material has these slots. Empty for a
/// set of texture coordinates that it does not have.
std::string attributeOf(std::size_t stream, const UvSlots& slots);

/// Those of a primitive whose material has these slots.
Accessors accessorsOf(const tinygltf::Primitive& primitive, const UvSlots& slots);

/// The form of a stream that an accessor holds.
const AttributeForm& formOf(const Document& document, std::size_t stream, int accessor);

/// The numbers of a stream. Those that are not finite are kept. Throws `Failure` as `readAttribute`.
Numbers<float> readStream(const Document& document, std::size_t stream, int accessor,
                          const std::string& attribute, std::size_t vertices, const std::string& element);

/// Returns whether a number was not finite.
bool replaceNotFinite(Numbers<float>& numbers, float replacement);

}  // namespace candela_plugins::gltf
