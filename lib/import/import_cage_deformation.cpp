#include "import/import_cage_deformation.h"

#include <span>

namespace candela {
namespace {

void bringToSumOne(std::span<float> weights, std::size_t vertex, const AbiReader& element) {
    double sum = 0.0;
    for (const float weight : weights) {
        if (weight < 0.0f)
            element.refuse(
                joined("vertex ", vertex, " has the joint weight ", weight, ", but 0 or more was expected"));
        sum += double{weight};
    }
    if (!(sum > 0.0)) element.refuse(joined("vertex ", vertex, " has joint weights that are all 0"));
    for (float& weight : weights) weight = static_cast<float>(double{weight} / sum);
}

}  // namespace

void takeInfluences(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    const std::size_t each = pushed.influence_count, vertices = cage.positions.size();
    element.counts("joints", pushed.joints, each * vertices, cage.joints);
    element.numbers("joint_weight", pushed.joint_weights, each * vertices, cage.jointWeights);
    cage.influenceCount = pushed.influence_count;
    if (each == 0) return;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        bringToSumOne(std::span(cage.jointWeights).subspan(vertex * each, each), vertex, element);
}

void takeMorphTargets(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    const std::size_t count = pushed.morph_target_count, vertices = cage.positions.size();
    if (count == 0) return;
    if (vertices == 0)
        element.refuse(joined("morph_target_count is ", count, ", but there are no vertices to move"));
    if (!pushed.morph_offsets)
        element.refuse(joined("morph_offsets is NULL, but morph_target_count is ", count));
    for (std::size_t target = 0; target < count; ++target) {
        const std::string member = joined("morph target ", target, ": offset");
        cage.morphTargets.emplace_back();
        element.numbers(member.c_str(), pushed.morph_offsets + target * vertices * 3, vertices,
                        cage.morphTargets.back().offsets);
    }
}

}  // namespace candela
