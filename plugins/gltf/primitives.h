#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "accessor.h"
#include "document.h"

namespace candela_plugins::gltf {

/// The encodings that a vertex attribute may have.
struct AttributeForm {
    std::size_t components;
    Encodings plain;
    Encodings quantized;  ///< In a file that uses KHR_mesh_quantization.
};

inline constexpr Encoding onlyFloat[] = {float32};
inline constexpr Encoding fractions[] = {float32, uint8Normalized, uint16Normalized};
// KHR_mesh_quantization, "Extending Mesh Attributes" and "Extending Morph Target Attributes".
inline constexpr Encoding quantizedVectors[] = {float32, int8Normalized, int16Normalized};
inline constexpr Encoding quantizedNumbers[] = {
    float32, int8, int8Normalized, uint8, uint8Normalized, int16, int16Normalized, uint16, uint16Normalized};
inline constexpr Encoding quantizedOffsets[] = {float32, int8, int8Normalized, int16, int16Normalized};

inline constexpr AttributeForm positionForm{3, onlyFloat, quantizedNumbers};
inline constexpr AttributeForm normalForm{3, onlyFloat, quantizedVectors};
inline constexpr AttributeForm tangentForm{4, onlyFloat, quantizedVectors};
inline constexpr AttributeForm uvForm{2, fractions, quantizedNumbers};

/// The accessor of an attribute of a primitive, -1 when it has none of that name.
int accessorOf(const tinygltf::Primitive& primitive, const std::string& attribute);

/// The number of elements of an accessor.
std::size_t elementCount(const Document& document, int accessor);

/// Throws `Failure` for the attribute of `element` unless the accessor is of the form and has `vertices`
/// elements.
void checkAttribute(const Document& document, int accessor, const std::string& attribute,
                    const AttributeForm& form, std::size_t vertices, const std::string& element);

/// The numbers of an attribute, vertex after vertex. Throws `Failure` as `checkAttribute`, and unless they
/// are finite where that is required.
Numbers<float> findAttribute(const Document& document, int accessor, const std::string& attribute,
                             const AttributeForm& form, std::size_t vertices, const std::string& element,
                             Finiteness finiteness = Finiteness::required);

/// The same in memory of their own.
std::vector<float> readAttribute(const Document& document, int accessor, const std::string& attribute,
                                 const AttributeForm& form, std::size_t vertices, const std::string& element,
                                 Finiteness finiteness = Finiteness::required);

/// The accessors of the vertices of a primitive: of its attributes, and of each of its morph targets.
/// Primitives of a mesh with the same ones share their vertices.
struct VertexAccessors {
    std::map<std::string, int> attributes;
    std::vector<std::map<std::string, int>> targets;

    auto operator<=>(const VertexAccessors&) const = default;
};

VertexAccessors vertexAccessors(const tinygltf::Primitive& primitive);

/// Primitives may read elements that the file does not hold, of accessors without a bufferView and of absent
/// morph offsets; together at most 2^28 for all primitives. Those beyond that become faults of `document`.
void limitAbsentElements(Document& document);

/// The vertices that a primitive names, in its order: its indices, or all its vertices.
Numbers<std::uint32_t> findCorners(const Document& document, const tinygltf::Primitive& primitive,
                                   std::uint32_t vertices, const std::string& element);

/// Throws `Failure` for `element` when a corner is not below `vertices`.
void requireCornersBelow(std::uint32_t vertices, std::span<const std::uint32_t> corners,
                         const std::string& element);

/// Whether primitives of this glTF mode are triangles: TRIANGLES, TRIANGLE_STRIP or TRIANGLE_FAN.
bool hasTriangles(int mode);

/// The triangles, three indices each, of a primitive with these corners, in the orders of glTF 2.0, 3.7.2.1.
/// Throws `Failure` for `element` when the number of corners does not fit the mode.
std::vector<std::uint32_t> triangulate(int mode, std::vector<std::uint32_t> corners,
                                       const std::string& element);

/// Faces of any size, one after the other.
struct Polygons {
    std::vector<std::uint32_t> sizes;    ///< Corners of each face.
    std::vector<std::uint32_t> corners;  ///< A vertex a corner.
};

/// Triangles, three vertices each, as polygons.
Polygons polygonsOfTriangles(std::vector<std::uint32_t> triangles);

/// The polygons that FB_ngon_encoding cut into triangles: consecutive triangles with the same first vertex
/// are the fan of one polygon. Throws `Failure` for `element` where a triangle does not continue its fan.
Polygons recoverPolygons(const std::vector<std::uint32_t>& triangles, const std::string& element);

}  // namespace candela_plugins::gltf
