#pragma once

#include <string>
#include <vector>

#include "../common/host.h"

namespace candela_plugins::gltf {

/// The keys of a channel: the numbers of each key one after the other.
struct AnimationKeys {
    std::vector<float> times, values;
};

/// Brings keys to the form that the host takes, with a note for `element`: their times increase strictly from
/// 0 on, and rotations are no quaternions of length 0. Keys are sorted by time. Of keys at the same time,
/// which are a jump, each but the first is moved to the next greater float. Those before 0 give way to one at
/// 0. `channel` has its path and interpolation. Throws `Failure` for `element` when a value is too large.
void repairKeys(const candela_animation_channel& channel, AnimationKeys& keys, const std::string& element,
                const Host& host);

}  // namespace candela_plugins::gltf
