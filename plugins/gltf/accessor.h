#pragma once

#include <span>
#include <vector>

#include "document.h"
#include "numbers.h"

namespace candela_plugins::gltf {

/// How one number of an accessor is stored.
struct Encoding {
    int componentType = 0;  ///< A componentType of glTF, 5120 to 5126.
    bool normalized = false;

    bool operator==(const Encoding&) const = default;
};

inline constexpr Encoding float32{TINYGLTF_COMPONENT_TYPE_FLOAT, false};
inline constexpr Encoding int8{TINYGLTF_COMPONENT_TYPE_BYTE, false};
inline constexpr Encoding int8Normalized{TINYGLTF_COMPONENT_TYPE_BYTE, true};
inline constexpr Encoding uint8{TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, false};
inline constexpr Encoding uint8Normalized{TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, true};
inline constexpr Encoding int16{TINYGLTF_COMPONENT_TYPE_SHORT, false};
inline constexpr Encoding int16Normalized{TINYGLTF_COMPONENT_TYPE_SHORT, true};
inline constexpr Encoding uint16{TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, false};
inline constexpr Encoding uint16Normalized{TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, true};
inline constexpr Encoding uint32{TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, false};

using Encodings = std::span<const Encoding>;

/// An accessor without a bufferView has a size that the size of the file does not limit: one with more
/// elements cannot be read.
inline constexpr std::uint64_t maxElementsWithoutView = std::uint64_t(1) << 24;

/// Numbers an element of an accessor has: 1 for SCALAR, 2 to 4 for vectors, 4, 9, 16 for matrices.
int componentCount(const tinygltf::Accessor& accessor);

/// Whether numbers that are not finite are refused.
enum class Finiteness { required, any };

/// Throws the fault of an accessor, if it has one, as a `Failure` for `element`.
void requireAccessor(const Document& document, int accessor, const std::string& element);

/// Throws `Failure` for `element` unless the accessor has `components` numbers an element (16 for MAT4) in
/// one of `allowed`, one element at least, and lies within its buffer.
void checkAccessor(const Document& document, int accessor, int components, Encodings allowed,
                   const std::string& element);

/// The numbers of an accessor, element after element, where they are in the document if they lie there as
/// such. Integers become the floating-point numbers they stand
/// for: normalised ones f = c / max, and max(c / max, -1) where signed (glTF 2.0, 3.11). Throws `Failure` for
/// `element` as `checkAccessor`, and when a number is not finite.
Numbers<float> findFloats(const Document& document, int accessor, int components, Encodings allowed,
                          const std::string& element, Finiteness finiteness = Finiteness::required);

/// The same in memory of their own.
std::vector<float> readFloats(const Document& document, int accessor, int components, Encodings allowed,
                              const std::string& element, Finiteness finiteness = Finiteness::required);

/// The numbers of a SCALAR accessor of unsigned integers. Throws `Failure` for `element` as `findFloats`.
Numbers<std::uint32_t> findIndices(const Document& document, int accessor, const std::string& element);

}  // namespace candela_plugins::gltf
