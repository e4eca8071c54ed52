#include "morph_targets.h"

#include <algorithm>

#include "attributes.h"

namespace candela_gltf {
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

}  // namespace candela_gltf
