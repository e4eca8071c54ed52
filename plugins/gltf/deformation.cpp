#include "deformation.h"

#include <algorithm>

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

void requireSomeWeight(const std::vector<float>& weights, std::size_t perVertex, const std::string& element) {
    for (std::size_t i = 0; i < weights.size(); i += perVertex) {
        const auto begin = weights.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = begin + static_cast<std::ptrdiff_t>(perVertex);
        if (std::any_of(begin, end, [](float weight) { return weight > 0.0f; })) continue;
        throw Failure{element, "the joint weights of vertex " + std::to_string(i / perVertex) +
                                   " are all 0, expected a sum of 1"};
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
                          std::size_t vertices, const std::string& element) {
    const std::size_t perVertex = std::size_t(sets) * jointsPerSet;
    Influences influences;
    influences.joints.resize(vertices * perVertex);
    influences.weights.resize(vertices * perVertex);
    for (std::uint32_t set = 0; set < sets; ++set) {
        const auto read = [&](const std::string& name, const AttributeForm& form) {
            return readAttribute(document, accessorOf(primitive, name), name, form, vertices, element);
        };
        const std::vector<float> joints = read(jointsName(set), jointsForm);
        const std::vector<float> weights = read(weightsName(set), weightsForm);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const std::size_t vertex = i / jointsPerSet;
            if (weights[i] < 0.0f) {
                throw Failure{element + ", attribute " + weightsName(set),
                              "vertex " + std::to_string(vertex) + " has a weight below 0"};
            }
            if (weights[i] == 0.0f) continue;
            const std::size_t at = vertex * perVertex + set * jointsPerSet + i % jointsPerSet;
            influences.joints[at] = static_cast<std::uint32_t>(joints[i]);
            influences.weights[at] = weights[i];
        }
    }
    if (sets > 0) requireSomeWeight(influences.weights, perVertex, element);
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
                                    std::size_t target, std::size_t vertices, const std::string& element) {
    const auto& attributes = primitive.targets.at(target);
    const auto accessor = attributes.find("POSITION");
    if (accessor == attributes.end()) return std::vector<float>(vertices * offsetForm.components);
    return readAttribute(document, accessor->second, "POSITION", offsetForm, vertices,
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

}  // namespace candela_plugins::gltf
