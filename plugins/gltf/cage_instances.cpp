#include "cages.h"
#include "deformation.h"

namespace candela_plugins::gltf {
namespace {

std::string nodeName(const Document& document, std::size_t node) {
    return elementName("node", node, document.model.nodes.at(node).name);
}

std::string skinName(const Document& document, std::size_t skin) {
    return elementName("skin", skin, document.skins[skin].name);
}

void checkFit(const Document& document, std::size_t node, std::size_t skin, const AddedCage& cage) {
    const auto mesh = static_cast<std::size_t>(document.model.nodes[node].mesh);
    const std::string meshName = elementName("mesh", mesh, document.model.meshes.at(mesh).name);
    if (cage.influenceCount == 0) {
        throw Failure{nodeName(document, node), "has " + skinName(document, skin) + ", but " + meshName +
                                                    " has no JOINTS_0 and WEIGHTS_0"};
    }
    const std::size_t joints = document.skins[skin].joints.size();
    if (cage.jointCount <= joints) return;
    throw Failure{nodeName(document, node), meshName + " has a vertex with joint " +
                                                std::to_string(cage.jointCount - 1) + ", but " +
                                                skinName(document, skin) + " has " + std::to_string(joints)};
}

void addCageInstance(const Document& document, std::size_t node, std::int32_t hostNode, const AddedCage& cage,
                     Skins& skins, const Host& host) {
    std::vector<float> weights(cage.morphTargetCount);
    host.leavesOut([&] { weights = morphWeights(document, node, cage.morphTargetCount); });
    candela_cage_instance instance{};
    instance.struct_size = sizeof instance;
    instance.node = hostNode;
    instance.cage = cage.index;
    instance.skin = -1;
    const int skin = document.model.nodes[node].skin;
    const std::int32_t hostSkin = skin < 0 ? -1 : skins.find(static_cast<std::size_t>(skin));
    if (hostSkin >= 0) {
        host.leavesOut([&] {
            checkFit(document, node, static_cast<std::size_t>(skin), cage);
            instance.skin = hostSkin;
        });
    }
    instance.morph_weight_count = cage.morphTargetCount;
    instance.morph_weights = weights.empty() ? nullptr : weights.data();
    host.add(instance);
}

}  // namespace

void addCageInstances(const Document& document, const std::vector<DrawnNode>& drawn,
                      const std::vector<std::int32_t>& nodes, const AddedCages& cages, Skins& skins,
                      const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto node = static_cast<std::size_t>(placed.node);
        const AddedCage* cage = cageOf(document, node, cages);
        if (!cage || placed.hidden) continue;
        addCageInstance(document, node, nodes.at(node), *cage, skins, host);
        if (document.model.nodes[node].extensions.contains("EXT_mesh_gpu_instancing")) {
            host.note(CANDELA_NOTE_MISSING, nodeName(document, node),
                      "the instances of a subdivision cage (EXT_mesh_gpu_instancing): drawn once");
        }
    }
}

}  // namespace candela_plugins::gltf
