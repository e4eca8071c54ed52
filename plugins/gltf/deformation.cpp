#include "deformation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

constexpr Encoding jointEncodings[] = {uint8, uint16};
constexpr AttributeForm jointsForm{jointsPerSet, jointEncodings, jointEncodings};
constexpr AttributeForm weightsForm{jointsPerSet, fractions, fractions};

std::string jointsName(std::uint32_t set) {
    return "JOINTS_" + std::to_string(set);
}

std::string weightsName(std::uint32_t set) {
    return "WEIGHTS_" + std::to_string(set);
}

bool isOfASet(const std::string& attribute) {
    return attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_");
}

/// What of the weights of a primitive was repaired.
struct WeightRepairs {
    bool negative = false, unknownJoint = false, none = false;

    void note(const std::string& element, const Host& host) const {
        const auto noteIf = [&](bool repaired, const char* text) {
            if (repaired) host.note(CANDELA_NOTE_REPAIRED, element, text);
        };
        noteIf(negative, "joint weights below 0, taken as 0");
        noteIf(unknownJoint, "joints that the skin does not have, left out");
        noteIf(none, "vertices whose joint weights are all 0, moved by the skin's first joint");
    }
};

/// A vertex without a weight over 0 follows the first joint.
void giveEachSomeWeight(std::vector<float>& weights, std::size_t perVertex, WeightRepairs& repairs) {
    for (std::size_t i = 0; i < weights.size(); i += perVertex) {
        const auto begin = weights.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = begin + static_cast<std::ptrdiff_t>(perVertex);
        if (std::any_of(begin, end, [](float weight) { return weight > 0.0f; })) continue;
        weights[i] = 1.0f;
        repairs.none = true;
    }
}

}  // namespace

std::uint32_t influenceSets(const tinygltf::Primitive& primitive, const std::string& element) {
    const auto named = static_cast<std::uint32_t>(
        std::count_if(primitive.attributes.begin(), primitive.attributes.end(),
                      [](const auto& attribute) { return isOfASet(attribute.first); }));
    const std::uint32_t sets = named / 2;
    for (std::uint32_t set = 0; set < sets + named % 2; ++set) {
        for (const std::string& name : {jointsName(set), weightsName(set)}) {
            if (accessorOf(primitive, name) >= 0) continue;
            throw Failure{element,
                          "has no " + name + ", expected a WEIGHTS_n for each JOINTS_n, numbered from 0 on"};
        }
    }
    return sets;
}

Influences readInfluences(const Document& document, const tinygltf::Primitive& primitive, std::uint32_t sets,
                          const InfluenceLimits& limits, const std::string& element, const Host& host) {
    const std::size_t perVertex = std::size_t(sets) * jointsPerSet;
    Influences influences;
    WeightRepairs repairs;
    for (std::uint32_t set = 0; set < sets; ++set) {
        const auto read = [&](const std::string& name, const AttributeForm& form) {
            return readAttribute(document, accessorOf(primitive, name), name, form, limits.vertices, element);
        };
        const std::vector<float> joints = read(jointsName(set), jointsForm);
        const std::vector<float> weights = read(weightsName(set), weightsForm);
        // Reading has checked that the file holds as many vertices.
        influences.joints.resize(limits.vertices * perVertex);
        influences.weights.resize(limits.vertices * perVertex);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            repairs.negative |= weights[i] < 0.0f;
            if (weights[i] <= 0.0f) continue;
            const auto joint = static_cast<std::uint32_t>(joints[i]);
            repairs.unknownJoint |= joint >= limits.joints;
            if (joint >= limits.joints) continue;
            const std::size_t at = i / jointsPerSet * perVertex + set * jointsPerSet + i % jointsPerSet;
            influences.joints[at] = joint;
            influences.weights[at] = weights[i];
        }
    }
    if (sets > 0) giveEachSomeWeight(influences.weights, perVertex, repairs);
    repairs.note(element, host);
    return influences;
}

namespace {

constexpr AttributeForm offsetForm{3, onlyFloat, quantizedOffsets};

std::vector<float> checked(const std::vector<double>& weights, std::uint32_t targets,
                           const std::string& element) {
    if (weights.size() != targets) {
        throw Failure{element, "has " + std::to_string(weights.size()) + " morph weights, expected " +
                                   std::to_string(targets)};
    }
    std::vector<float> numbers(weights.size());
    std::transform(weights.begin(), weights.end(), numbers.begin(),
                   [](double weight) { return static_cast<float>(weight); });
    return numbers;
}

}  // namespace

std::vector<float> readMorphOffsets(const Document& document, const tinygltf::Primitive& primitive,
                                    std::size_t target, const char* attribute, std::size_t vertices,
                                    const std::string& element) {
    const auto& attributes = primitive.targets.at(target);
    const auto accessor = attributes.find(attribute);
    if (accessor == attributes.end()) return {};
    return readAttribute(document, accessor->second, attribute, offsetForm, vertices,
                         element + ", target " + std::to_string(target));
}

std::vector<float> morphWeights(const Document& document, std::size_t node, std::uint32_t targets) {
    const tinygltf::Node& source = document.model.nodes[node];
    if (!source.weights.empty()) {
        return checked(source.weights, targets, elementName("node", node, source.name));
    }
    const auto index = static_cast<std::size_t>(source.mesh);
    const tinygltf::Mesh& mesh = document.model.meshes.at(index);
    if (!mesh.weights.empty()) return checked(mesh.weights, targets, elementName("mesh", index, mesh.name));
    return std::vector<float>(targets);
}

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

}  // namespace

Skins::Skins(const Document& document, const std::vector<std::int32_t>& nodes, const Host& host)
    : document_(document), nodes_(nodes), host_(host), indices_(document.skins.size()) {}

std::int32_t Skins::find(std::size_t skin) {
    std::optional<std::int32_t>& index = indices_.at(skin);
    if (index) return *index;
    index = -1;
    host_.leavesOut([&] { index = add(skin); });
    return *index;
}

std::int32_t Skins::add(std::size_t skin) const {
    const std::vector<std::int32_t> joints = jointsOf(document_, skin, nodes_);
    const std::vector<float> matrices = inverseBindMatricesOf(document_, skin);
    candela_skin hostSkin{};
    hostSkin.struct_size = sizeof hostSkin;
    hostSkin.name = document_.skins[skin].name.c_str();
    hostSkin.joint_count = static_cast<std::uint32_t>(joints.size());
    hostSkin.joints = joints.data();
    hostSkin.inverse_bind_matrices = matrices.empty() ? nullptr : matrices.data();
    return host_.add(hostSkin);
}

}  // namespace candela_plugins::gltf
