#pragma once

#include <candela/plugin.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>

namespace candela {

/// The size that a struct of plugin.h had in version 1.0: a smaller one no plugin can have. A struct that
/// gains members specialises this with its old size.
template <class T>
inline constexpr std::size_t firstSizeOf = sizeof(T);

/// The `struct_size` that a plugin wrote at the head of a struct. Nothing else of it is read.
template <class T>
std::uint32_t structSizeOf(const T* pushed) {
    static_assert(offsetof(T, struct_size) == 0);
    std::uint32_t size = 0;
    std::memcpy(&size, pushed, sizeof size);
    return size;
}

/// A copy of a plugin's struct of which only `struct_size` bytes are read; members beyond are zero. None when
/// its `struct_size` is less than version 1.0 has.
template <class T>
std::optional<T> copyOf(const T* pushed) {
    const std::uint32_t size = structSizeOf(pushed);
    if (size < firstSizeOf<T>) return std::nullopt;
    T copy{};
    std::memcpy(static_cast<void*>(&copy), pushed, std::min<std::size_t>(size, sizeof(T)));
    return copy;
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
