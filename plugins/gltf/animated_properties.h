#pragma once

#include <string>
#include <vector>

#include "animation_pointer.h"
#include "animations.h"

namespace candela_plugins::gltf {

/// The host's indices of the elements whose property a pointer leads to: a light or a camera of the file is
/// as many as nodes show it. Empty where none is drawn. Throws `Failure` for `element`, the channel, that
/// names the pointer, where they do not have the property.
std::vector<std::int32_t> animatedElements(const Document& document, const AnimatedElements& elements,
                                           const PointerTarget& target, const AnimationPointer& pointer,
                                           const std::string& element);

/// The host's nodes whose morph weights a pointer leads to: for those of a mesh, of the nodes that show it
/// and have no weights of their own. Throws `Failure` as `animatedElements`.
std::vector<MorphedNode> animatedWeights(const Document& document, const AnimatedElements& elements,
                                         const PointerTarget& target, const AnimationPointer& pointer,
                                         const std::string& element);

}  // namespace candela_plugins::gltf
