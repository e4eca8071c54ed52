#include <array>
#include <cmath>

#include "cages.h"
#include "deformation.h"
#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

constexpr std::size_t matrixSize = 16;
// The tolerance for matrices that were multiplied in single precision.
constexpr float affineTolerance = 1e-5f;

std::string skinName(const Document& document, std::size_t skin) {
    return elementName("skin", skin, document.skins[skin].name);
}

std::string nodeName(const Document& document, std::size_t node) {
    return elementName("node", node, document.model.nodes.at(node).name);
}

std::vector<std::int32_t> jointsOf(const Document& document, std::size_t skin,
                                   const std::vector<std::int32_t>& nodes) {
    requireUsable(document, skinName(document, skin));
    std::vector<std::int32_t> joints;
    for (const std::size_t joint : document.skins[skin].joints) {
        if (nodes.at(joint) < 0) {
            throw Failure{skinName(document, skin), "its joint " + std::to_string(joints.size()) + ", " +
                                                        nodeName(document, joint) +
                                                        ", is not in the scene that is drawn"};
        }
        joints.push_back(nodes[joint]);
    }
    if (joints.empty()) throw Failure{skinName(document, skin), "has no joints, expected 1 or more"};
    return joints;
}

void checkAffine(const std::vector<float>& matrices, const std::string& element) {
    constexpr std::array<float, 4> expected{0, 0, 0, 1};
    for (std::size_t i = 3; i < matrices.size(); i += 4) {
        if (std::abs(matrices[i] - expected[i % matrixSize / 4]) <= affineTolerance) continue;
        throw Failure{element, "matrix " + std::to_string(i / matrixSize) +
                                   " is not affine: its last row is not 0 0 0 1"};
    }
}

/// Empty: identities.
std::vector<float> inverseBindMatricesOf(const Document& document, std::size_t skin) {
    const SkinSource& source = document.skins[skin];
    if (!source.inverseBindMatrices) return {};
    const std::string element = skinName(document, skin) + ", inverseBindMatrices";
    std::vector<float> matrices =
        readFloats(document, static_cast<int>(*source.inverseBindMatrices), matrixSize, onlyFloat, element);
    const std::size_t count = matrices.size() / matrixSize;
    if (count < source.joints.size()) {
        throw Failure{element, "accessor " + std::to_string(*source.inverseBindMatrices) + " has " +
                                   std::to_string(count) + " elements, expected one for each of " +
                                   std::to_string(source.joints.size()) + " joints"};
    }
    checkAffine(matrices, element);
    return matrices;
}

std::int32_t addSkin(const Document& document, std::size_t skin, const std::vector<std::int32_t>& nodes,
                     const Host& host) {
    const std::vector<std::int32_t> joints = jointsOf(document, skin, nodes);
    const std::vector<float> matrices = inverseBindMatricesOf(document, skin);
    candela_skin hostSkin{};
    hostSkin.struct_size = sizeof hostSkin;
    hostSkin.name = document.skins[skin].name.c_str();
    hostSkin.joint_count = static_cast<std::uint32_t>(joints.size());
    hostSkin.joints = joints.data();
    hostSkin.inverse_bind_matrices = matrices.empty() ? nullptr : matrices.data();
    return host.add(hostSkin);
}

}  // namespace

std::vector<std::int32_t> addSkins(const Document& document, const std::vector<DrawnNode>& drawn,
                                   const std::vector<std::int32_t>& nodes, const AddedCages& cages,
                                   const Host& host) {
    std::vector<std::int32_t> indices(document.skins.size(), -1);
    for (const DrawnNode& placed : drawn) {
        const auto node = static_cast<std::size_t>(placed.node);
        const int skin = document.model.nodes[node].skin;
        if (skin < 0 || !cageOf(document, node, cages)) continue;
        std::int32_t& index = indices.at(static_cast<std::size_t>(skin));
        if (index >= 0) continue;
        host.leavesOut([&] { index = addSkin(document, static_cast<std::size_t>(skin), nodes, host); });
    }
    return indices;
}

namespace {

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
                     const std::vector<std::int32_t>& skins, const Host& host) {
    std::vector<float> weights(cage.morphTargetCount);
    host.leavesOut([&] { weights = morphWeights(document, node, cage.morphTargetCount); });
    candela_cage_instance instance{};
    instance.struct_size = sizeof instance;
    instance.node = hostNode;
    instance.cage = cage.index;
    instance.skin = -1;
    const int skin = document.model.nodes[node].skin;
    const std::int32_t hostSkin = skin < 0 ? -1 : skins.at(static_cast<std::size_t>(skin));
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
                      const std::vector<std::int32_t>& nodes, const AddedCages& cages,
                      const std::vector<std::int32_t>& skins, const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto node = static_cast<std::size_t>(placed.node);
        const AddedCage* cage = cageOf(document, node, cages);
        if (cage) addCageInstance(document, node, nodes.at(node), *cage, skins, host);
    }
}

}  // namespace candela_plugins::gltf
