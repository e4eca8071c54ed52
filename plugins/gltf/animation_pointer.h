#pragma once

#include <candela/plugin.h>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace candela_plugins::gltf {

/// The JSON pointer of a channel (KHR_animation_pointer).
struct AnimationPointer {
    std::string text;
    /// Whether the file has the object that holds the property, and the property itself.
    bool hasObject = false, hasValue = false;
};

/// By animation and channel.
using AnimationPointers = std::map<std::pair<std::size_t, std::size_t>, AnimationPointer>;

/// Takes the pointers out of a document that conforms to `documentSchema`.
AnimationPointers takeAnimationPointers(nlohmann::json& document);

/// What a pointer leads to.
enum class PointerTo { nodePath, nodeWeights, meshWeights, node, material, texture, light, camera };

/// A pointer that the importer knows.
struct PointerRow {
    const char* pattern;  ///< "{}" stands for an index.
    PointerTo to;
    int value;       ///< Of `nodePath` a candela_animation_path, else a candela_animated_property.
    int components;  ///< Of an element of the output accessor.
    float min = -1e9f, max = 1e9f;
    bool hasDefault = true;  ///< The file need not have the property itself.
    float factor = 1.0f;     ///< From the file's value to the host's.
};

/// A pointer, resolved.
struct PointerTarget {
    const PointerRow* row = nullptr;
    std::size_t element = 0;            ///< Of the file: a node, mesh, material, light or camera.
    std::optional<std::size_t> weight;  ///< Of a pointer to one morph weight.
    std::size_t slot = 0;               ///< Of `texture`: a candela_texture_slot.
};

/// Throws `Failure` for `element`, the channel, that names the pointer: when it is none, leads to nothing
/// that the importer animates, or to what the file does not have.
PointerTarget resolvePointer(const AnimationPointer& pointer, const std::string& element);

/// The nodes whose visibility a pointer leads to.
std::set<std::size_t> nodesOfAnimatedVisibility(const AnimationPointers& pointers);

}  // namespace candela_plugins::gltf
