#pragma once

#include <candela/scene.h>

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace candela {

/// The value of a channel at `time` (seconds): x, y, z, and for rotations a unit quaternion x, y, z, w.
/// Follows glTF 2.0, appendix C. The channel keeps the rules of `AnimationChannel`.
glm::dvec4 sampleChannel(const AnimationChannel& channel, double time);

/// A node as animations pose it.
struct PosedNode {
    std::uint32_t node = 0;
    Trs trs;
};

/// The animated nodes at `time`, in growing order of node; where two animations move the same property, the
/// later one in the scene holds.
std::vector<PosedNode> poseAnimatedNodes(const Scene& scene, double time);

}  // namespace candela
