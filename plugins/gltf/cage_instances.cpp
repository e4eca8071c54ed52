#include "cage_instances.h"

#include "morph_targets.h"

namespace candela_gltf {
namespace {

std::string nodeName(const Document& document, std::size_t node) {
    return elementName("node", node, document.model.nodes[node].name);
}

std::string skinName(const Document& document, std::size_t skin) {
    return elementName("skin", skin, document.skins[skin].name);
}

void checkFit(const Document& document, std::size_t node, std::size_t skin, const PushedCage& cage) {
    const auto mesh = static_cast<std::size_t>(document.model.nodes[node].mesh);
    const std::string shown = elementName("mesh", mesh, document.model.meshes.at(mesh).name);
    if (cage.influenceCount == 0) {
        throw Failure{nodeName(document, node), "has " + skinName(document, skin) + ", but " + shown +
                                                    " has no JOINTS_0 and WEIGHTS_0"};
    }
    const std::size_t joints = document.skins[skin].joints.size();
    if (cage.jointCount <= joints) return;
    throw Failure{nodeName(document, node), shown + " has a vertex with joint " +
                                                std::to_string(cage.jointCount - 1) + ", but " +
                                                skinName(document, skin) + " has " + std::to_string(joints)};
}

void showCage(const Document& document, std::size_t node, std::int32_t pushedNode, const PushedCage& cage,
              const std::vector<std::int32_t>& skins, const Host& host) {
    const std::vector<float> weights = morphWeights(document, node, cage.morphTargetCount);
    candela_cage_instance shown{};
    shown.struct_size = sizeof shown;
    shown.node = pushedNode;
    shown.cage = cage.index;
    shown.skin = -1;
    if (const int skin = document.model.nodes[node].skin; skin >= 0) {
        checkFit(document, node, static_cast<std::size_t>(skin), cage);
        shown.skin = skins.at(static_cast<std::size_t>(skin));
    }
    shown.morph_weight_count = cage.morphTargetCount;
    shown.morph_weights = weights.empty() ? nullptr : weights.data();
    host.show(shown);
}

}  // namespace

void showCages(const Document& document, const std::vector<DrawnNode>& drawn,
               const std::vector<std::int32_t>& nodes, const PushedCages& cages,
               const std::vector<std::int32_t>& skins, const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto node = static_cast<std::size_t>(placed.node);
        const PushedCage* cage = cageOf(document, node, cages);
        if (cage) showCage(document, node, nodes.at(node), *cage, skins, host);
    }
}

}  // namespace candela_gltf
