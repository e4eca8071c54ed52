#pragma once

#include "base/thread_pool.h"
#include "import/text.h"

#include <candela/plugin.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

namespace candela {

/// The sizes that a struct of plugin.h had in the versions before the present one, the first one first. A
/// struct that has gained members specialises this.
template <class T>
inline constexpr std::array<std::size_t, 0> pastSizesOf{};
template <>
inline constexpr std::array pastSizesOf<candela_material>{offsetof(candela_material, ior)};
template <>
inline constexpr std::array pastSizesOf<candela_mesh>{offsetof(candela_mesh, face_count),
                                                      offsetof(candela_mesh, influence_count),
                                                      offsetof(candela_mesh, variant_material_count)};
template <>
inline constexpr std::array pastSizesOf<candela_cage>{offsetof(candela_cage, variant_count)};
template <>
inline constexpr std::array pastSizesOf<candela_camera>{offsetof(candela_camera, number)};
template <>
inline constexpr std::array pastSizesOf<candela_light>{offsetof(candela_light, casts_no_shadow)};
template <>
inline constexpr std::array pastSizesOf<candela_node>{offsetof(candela_node, translation_remainder),
                                                      offsetof(candela_node, casts_no_shadow),
                                                      offsetof(candela_node, is_hidden)};
template <>
inline constexpr std::array pastSizesOf<candela_animation>{offsetof(candela_animation, property_count)};
template <>
inline constexpr std::array pastSizesOf<candela_plugin>{offsetof(candela_plugin, subdivider),
                                                        offsetof(candela_plugin, image_decoder)};
template <>
inline constexpr std::array pastSizesOf<candela_importer>{offsetof(candela_importer, option_count)};

/// The size of a struct of plugin.h in the first version that had it.
template <class T>
constexpr std::size_t firstSizeOf() {
    if constexpr (pastSizesOf<T>.empty()) {
        return sizeof(T);
    } else {
        return pastSizesOf<T>.front();
    }
}

/// The first version that had a struct of plugin.h.
template <class T>
inline constexpr const char* firstVersionOf = "1.0";
template <>
inline constexpr const char* firstVersionOf<candela_cage> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_skin> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_cage_instance> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_deformation> = "1.3";
template <>
inline constexpr const char* firstVersionOf<candela_environment> = "1.5";
template <>
inline constexpr const char* firstVersionOf<candela_refined_cage> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_subdivider> = "1.1";
template <>
inline constexpr const char* firstVersionOf<candela_scene_info> = "1.6";
template <>
inline constexpr const char* firstVersionOf<candela_image_decoder> = "1.6";
template <>
inline constexpr const char* firstVersionOf<candela_frame_callback> = "1.6";

/// The `struct_size` of a struct of a plugin. Reads no other member.
template <class T>
std::uint32_t structSizeOf(const T* source) {
    static_assert(offsetof(T, struct_size) == 0);
    std::uint32_t size = 0;
    std::memcpy(&size, source, sizeof size);
    return size;
}

/// A copy of a plugin's struct of which only `struct_size` bytes are read; members beyond are zero. None when
/// no version has this `struct_size`: it is less than that of the first, or between two, where a pointer may
/// be cut.
template <class T>
std::optional<T> copyOf(const T* source) {
    const std::uint32_t size = structSizeOf(source);
    if (size < sizeof(T) && std::ranges::find(pastSizesOf<T>, size) == pastSizesOf<T>.end())
        return std::nullopt;
    T copy{};
    std::memcpy(static_cast<void*>(&copy), source, std::min<std::size_t>(size, sizeof(T)));
    return copy;
}

/// Why `copyOf` refuses a `struct_size`: "is 8, but version 1.0 has ...".
template <class T>
std::string sizeFault(const T* source) {
    return joined("is ", structSizeOf(source), ", but version ", firstVersionOf<T>, " has ", firstSizeOf<T>(),
                  " bytes");
}

/// The number of an enumerator that a plugin wrote, which may be one that the enumeration does not have.
template <class Enum>
std::uint32_t numberOf(const Enum& value) {
    static_assert(sizeof(Enum) == sizeof(std::uint32_t));
    std::uint32_t number = 0;
    std::memcpy(&number, &value, sizeof number);
    return number;
}

/// `parallel_for` of plugin.h.
inline void runParallelLoop(ThreadPool& pool, std::uint32_t count, candela_parallel_body body,
                            void* context) {
    pool.run(count, [body, context](std::size_t index, unsigned worker) {
        body(context, static_cast<std::uint32_t>(index), worker);
    });
}

}  // namespace candela
