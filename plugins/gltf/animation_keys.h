#pragma once

#include <string>
#include <vector>

#include "../common/host.h"
#include "accessor.h"

namespace candela_plugins::gltf {

/// The keys of a channel: the numbers of each key one after the other.
struct AnimationKeys {
    std::vector<float> times, values;
};

/// What the output accessor of a channel holds.
struct KeyForm {
    int components = 1;        ///< Of an element.
    Encodings encodings;       ///< One of which it has.
    std::size_t elements = 1;  ///< A value has.
    bool isRotation = false;
    /// Values out of this range are refused, and clamped where `clamps` is set. Tangents have none.
    float min = -1e9f, max = 1e9f;
    bool clamps = false;
    float factor = 1.0f;  ///< From the file's numbers to the host's.
};

/// The host's name of an interpolation.
candela_interpolation interpolationOf(const tinygltf::AnimationSampler& sampler);

/// Reads the keys of a sampler in the form that the host takes, with a note for `element` on what is
/// repaired: their times increase strictly from 0 on, and rotations are no quaternions of length 0. Keys are
/// sorted by time. Of keys at the same time, which are a jump, each but the first is moved to the next
/// greater float. Those before 0 give way to one at 0. Throws `Failure` when an accessor does not fit or a
/// value is too large.
AnimationKeys readKeys(const Document& document, const tinygltf::AnimationSampler& sampler,
                       const KeyForm& form, const std::string& element, const Host& host);

}  // namespace candela_plugins::gltf
