#include "base/error_context.h"
#include "import/abi_import.h"
#include "scene/model/animated_properties.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace candela {

namespace {

/// From the file's axes and unit to metres with +Y up.
glm::mat4 metresFromFile(const SceneInfo& info) {
    const auto unit = static_cast<float>(info.metresPerUnit);
    glm::mat4 matrix(unit);
    matrix[3][3] = 1.0f;
    if (info.upAxis == UpAxis::z) {
        matrix[1] = glm::vec4(0, 0, -unit, 0);
        matrix[2] = glm::vec4(0, unit, 0, 0);
    } else if (info.upAxis == UpAxis::x) {
        matrix[0] = glm::vec4(0, unit, 0, 0);
        matrix[1] = glm::vec4(-unit, 0, 0, 0);
    }
    return matrix;
}

}  // namespace

SceneInfo sceneInfoFrom(const candela_scene_info& source, const AbiReader& call) {
    constexpr std::array axes{UpAxis::y, UpAxis::z, UpAxis::x};
    constexpr double smallest = 1.0e-9, largest = 1.0e9;
    SceneInfo info;
    info.upAxis = axes[call.enumerator("up_axis", source.up_axis, axes.size())];
    if (source.metres_per_unit != 0.0) info.metresPerUnit = source.metres_per_unit;
    if (!(info.metresPerUnit >= smallest && info.metresPerUnit <= largest))
        call.refuse(joined("metres_per_unit is ", info.metresPerUnit, ", but ", smallest, " to ", largest,
                           " was expected"));
    if (source.generator) info.generator = oneLine(source.generator);
    if (source.copyright) info.copyright = oneLine(source.copyright);
    return info;
}

void bringToMetres(const SceneInfo& info, Scene& scene) {
    if (info.upAxis == UpAxis::y && info.metresPerUnit == 1.0) return;
    for (Node& node : scene.nodes) node.parent = node.parent ? *node.parent + 1 : 0;
    for (Skin& skin : scene.skins) {
        for (std::uint32_t& joint : skin.joints) ++joint;
    }
    for (Light& light : scene.lights) light.node = light.node ? *light.node + 1 : 0;
    for (Camera& camera : scene.cameras) camera.node = camera.node ? *camera.node + 1 : 0;
    for (Animation& animation : scene.animations) {
        for (AnimationChannel& channel : animation.channels) ++channel.node;
        for (PropertyChannel& channel : animation.properties) {
            if (elementOf(channel.property) == AnimatedElement::node) ++channel.element;
        }
    }
    Node root;
    root.transform = metresFromFile(info);
    scene.nodes.insert(scene.nodes.begin(), std::move(root));
}

}  // namespace candela
