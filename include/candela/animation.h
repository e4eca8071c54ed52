#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace candela {

enum class AnimationPath { translation, rotation, scale, morphWeights };
enum class Interpolation { linear, step, cubicSpline };

/// The values of one property of one node over time.
struct AnimationChannel {
    /// Index into `Scene::nodes`. Its transform is a `Transform`, not a matrix. For morph weights the node
    /// shows a mesh or a cage with morph targets.
    std::uint32_t node = 0;
    AnimationPath path = AnimationPath::translation;
    Interpolation interpolation = Interpolation::linear;  ///< Linear is spherical for rotations.
    std::vector<float> times;                             ///< Seconds, strictly increasing, one or more.
    std::vector<float> values;  ///< 3 numbers per key, 4 (x, y, z, w) for rotations, one per morph target for
                                ///< morph weights; cubic splines hold in-tangent, value and out-tangent.
};

/// Channels that play together. Before its first key a channel holds its first value, after its last key its
/// last.
struct Animation {
    std::string name;
    std::vector<AnimationChannel> channels;
    bool plays = true;  ///< False: `worldTransforms` and the like pose nodes as if it were not there.
};

}  // namespace candela
