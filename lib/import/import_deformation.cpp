#include "import/import_deformation.h"

#include "import/abi_import.h"

#include <utility>

namespace candela {

void normalizeWeights(std::span<float> weights, std::size_t vertex, const AbiReader& element) {
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

void takeMorphTargets(const MorphTargetSource& source, const AbiReader& element, std::size_t vertices,
                      std::vector<MorphTarget>& targets) {
    const std::size_t count = source.count;
    if (count == 0) return;
    if (vertices == 0)
        element.refuse(joined("morph_target_count is ", count, ", but there are no vertices to move"));
    if (!source.offsets) element.refuse(joined("morph_offsets is NULL, but morph_target_count is ", count));
    const auto take = [&](const char* what, std::size_t target, const float* from,
                          std::vector<glm::vec3>& offsets) {
        if (!from) return;
        const std::string member = joined("morph target ", target, ": ", what);
        element.numbers(member.c_str(), from + target * vertices * 3, vertices, offsets);
    };
    for (std::size_t i = 0; i < count; ++i) {
        MorphTarget& target = targets.emplace_back();
        take("offset", i, source.offsets, target.offsets);
        take("normal offset", i, source.normalOffsets, target.normalOffsets);
        take("tangent offset", i, source.tangentOffsets, target.tangentOffsets);
    }
}

void takeDeformation(const DeformationSource& source, const DeformedShape& shape, const AbiReader& element,
                     const Scene& scene, Node& node) {
    const bool deforms = source.skin != -1 || source.weightCount > 0;
    if (deforms && (node.skin || !node.morphWeights.empty()))
        element.refuse("it has a skin or morph weights already, and can not have others");
    const std::optional<std::uint32_t> skin = element.reference("skin", source.skin, scene.skins.size());
    std::vector<float> weights;
    if (source.weightCount > 0 && source.weightCount != shape.morphTargets)
        element.refuse(joined("morph_weight_count is ", source.weightCount, ", but ", shape.label, " has ",
                              shape.morphTargets, " morph targets"));
    element.numbers("morph_weight", source.weights, source.weightCount, weights);
    if (!deforms) return;
    node.skin = skin;
    node.morphWeights = std::move(weights);
}

void addDeformation(const candela_deformation& source, Scene& scene) {
    const AbiReader call("add_deformation", std::nullopt, nullptr);
    const auto index = call.reference("node", source.node, scene.nodes.size());
    if (!index) call.refuse("node is -1, but a node was expected");
    Node& node = scene.nodes[*index];
    const AbiReader element("node", *index, node.name.c_str());
    if (!node.mesh) element.refuse("it has no mesh to deform");
    const Mesh& mesh = scene.meshes[*node.mesh];
    const std::string label = AbiReader("mesh", *node.mesh, mesh.name.c_str()).label();
    takeDeformation({source.skin, source.morph_weight_count, source.morph_weights},
                    {label, mesh.morphTargets.size()}, element, scene, node);
}

Skin skinFrom(const candela_skin& source, const AbiReader& element, const Scene& scene) {
    Skin skin;
    skin.name = element.name();
    const std::uint32_t count = source.joint_count;
    if (count == 0) element.refuse("joint_count is 0, but 1 or more was expected");
    if (!source.joints) element.refuse(joined("joints is NULL, but joint_count is ", count));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string member = joined("joint ", i);
        const auto node = element.reference(member.c_str(), source.joints[i], scene.nodes.size());
        if (!node) element.refuse(member + " is -1, but a node was expected");
        skin.joints.push_back(*node);
    }
    if (!source.inverse_bind_matrices) {
        skin.inverseBindMatrices.assign(count, glm::mat4(1.0f));
        return skin;
    }
    element.numbers("inverse_bind_matrix", source.inverse_bind_matrices, count, skin.inverseBindMatrices);
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::mat4& matrix = skin.inverseBindMatrices[i];
        matrix = element.affine(joined("inverse_bind_matrix ", i), matrix);
    }
    return skin;
}

}  // namespace candela
