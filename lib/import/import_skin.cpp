#include "import/abi_import.h"

namespace candela {

Skin skinFrom(const candela_skin& pushed, const AbiReader& element, const Scene& scene) {
    Skin skin;
    skin.name = element.name();
    const std::uint32_t count = pushed.joint_count;
    if (count == 0) element.refuse("joint_count is 0, but 1 or more was expected");
    if (!pushed.joints) element.refuse(joined("joints is NULL, but joint_count is ", count));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string member = joined("joint ", i);
        const auto node = element.reference(member.c_str(), pushed.joints[i], scene.nodes.size());
        if (!node) element.refuse(member + " is -1, but a node was expected");
        skin.joints.push_back(*node);
    }
    if (!pushed.inverse_bind_matrices) {
        skin.inverseBindMatrices.assign(count, glm::mat4(1.0f));
        return skin;
    }
    element.numbers("inverse_bind_matrix", pushed.inverse_bind_matrices, count, skin.inverseBindMatrices);
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::mat4& matrix = skin.inverseBindMatrices[i];
        matrix = element.affine(joined("inverse_bind_matrix ", i), matrix);
    }
    return skin;
}

}  // namespace candela
