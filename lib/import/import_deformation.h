#pragma once

#include "import/abi_reader.h"

#include <candela/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candela {

// What deforms meshes and cages, checked and copied: the parts that their structs of plugin.h have in common.
// Each function throws `Error` (badInput) whose text begins with `element`.

/// Divides the weights of a vertex by their sum, which has to be over 0.
void normalizeWeights(std::span<float> weights, std::size_t vertex, const AbiReader& element);

/// The joints of `count` influences a vertex, and their weights.
struct InfluenceSource {
    std::uint32_t count;
    const std::uint32_t* joints;
    const float* weights;
};

/// Copies the influences of a mesh or a cage. The weights of each vertex are divided by their sum.
template <typename Shape>
void takeInfluences(const InfluenceSource& source, const AbiReader& element, std::size_t vertices,
                    Shape& shape) {
    const std::size_t each = source.count;
    element.counts("joints", source.joints, each * vertices, shape.joints);
    element.numbers("joint_weight", source.weights, each * vertices, shape.jointWeights);
    shape.influenceCount = source.count;
    if (each == 0) return;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        normalizeWeights(std::span(shape.jointWeights).subspan(vertex * each, each), vertex, element);
}

/// The offsets of `count` morph targets: target after target, 3 numbers a vertex. Those of normals and
/// tangents may be NULL.
struct MorphTargetSource {
    std::uint32_t count;
    const float* offsets;
    const float* normalOffsets = nullptr;
    const float* tangentOffsets = nullptr;
};

void takeMorphTargets(const MorphTargetSource& source, const AbiReader& element, std::size_t vertices,
                      std::vector<MorphTarget>& targets);

/// Skin and morph weights of a node, as the host is given them.
struct DeformationSource {
    std::int32_t skin;
    std::uint32_t weightCount;
    const float* weights;
};

/// The mesh or the cage that a deformation is for.
struct DeformedShape {
    std::string label;  ///< "cage 0 'body'".
    std::size_t morphTargets;
};

/// Gives `node`, which is `element`, its skin and its morph weights. It must have none.
void takeDeformation(const DeformationSource& source, const DeformedShape& shape, const AbiReader& element,
                     const Scene& scene, Node& node);

}  // namespace candela
