#include "influences.h"

#include <algorithm>

#include "attributes.h"

namespace candela_gltf {
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

}  // namespace candela_gltf
