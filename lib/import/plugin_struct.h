#pragma once

#include "import/text.h"

#include <candela/plugin.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

namespace candela {

/// The size that a struct of plugin.h had when it came. A struct that has gained members since then
/// specialises this with its old size.
template <class T>
inline constexpr std::size_t firstSizeOf = sizeof(T);
template <>
inline constexpr std::size_t firstSizeOf<candela_mesh> = offsetof(candela_mesh, face_count);
template <>
inline constexpr std::size_t firstSizeOf<candela_plugin> = offsetof(candela_plugin, subdivider);

/// The version that a struct of plugin.h came with.
template <class T>
inline constexpr const char* firstVersionOf = "1.0";
template <>
inline constexpr const char* firstVersionOf<candela_cage> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_skin> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_cage_instance> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_refined_cage> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_subdivider> = "1.1";

/// The `struct_size` that a plugin wrote at the head of a struct. Nothing else of it is read.
template <class T>
std::uint32_t structSizeOf(const T* pushed) {
    static_assert(offsetof(T, struct_size) == 0);
    std::uint32_t size = 0;
    std::memcpy(&size, pushed, sizeof size);
    return size;
}

/// A copy of a plugin's struct of which only `struct_size` bytes are read; members beyond are zero. None when
/// its `struct_size` is that of no version: less than the first had, or between two, where a pointer may be
/// cut in half.
template <class T>
std::optional<T> copyOf(const T* pushed) {
    const std::uint32_t size = structSizeOf(pushed);
    if (size < sizeof(T) && size != firstSizeOf<T>) return std::nullopt;
    T copy{};
    std::memcpy(static_cast<void*>(&copy), pushed, std::min<std::size_t>(size, sizeof(T)));
    return copy;
}

/// What to say of the `struct_size` of a struct that `copyOf` does not take: "is 8, but version 1.0 has ...".
template <class T>
std::string sizeFault(const T* pushed) {
    return joined("is ", structSizeOf(pushed), ", but version ", firstVersionOf<T>, " has ", firstSizeOf<T>,
                  " bytes");
}

/// The number behind an enumeration that a plugin wrote, which may be none of its enumerators.
template <class Enum>
std::uint32_t numberOf(const Enum& value) {
    static_assert(sizeof(Enum) == sizeof(std::uint32_t));
    std::uint32_t number = 0;
    std::memcpy(&number, &value, sizeof number);
    return number;
}

}  // namespace candela
