#include "nodes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela_gltf {
namespace {

// What the host takes for a unit quaternion and for an affine matrix; checked here so that the message names
// the file's node.
constexpr double unitTolerance = 0.01, affineTolerance = 1e-5;

candela_node identityNode(const std::string& name, std::int32_t parent) {
    candela_node node{};
    node.struct_size = sizeof node;
    node.name = name.c_str();
    node.parent = parent;
    node.rotation[3] = 1.0f;
    node.scale[0] = node.scale[1] = node.scale[2] = 1.0f;
    node.mesh = -1;
    return node;
}

void copyNumbers(const std::vector<double>& from, float* to) {
    std::transform(from.begin(), from.end(), to, [](double v) { return static_cast<float>(v); });
}

void checkRotation(const std::vector<double>& rotation, const std::string& element) {
    if (rotation.empty()) return;
    double square = 0.0;
    for (const double number : rotation) square += number * number;
    const double length = std::sqrt(square);
    if (std::abs(length - 1.0) <= unitTolerance) return;
    throw Failure{element, "rotation is a quaternion of length " + std::to_string(length) + ", expected 1"};
}

void checkMatrix(const std::vector<double>& matrix, const std::string& element) {
    constexpr std::array<double, 4> expected{0, 0, 0, 1};
    for (std::size_t column = 0; column < 4; ++column) {
        if (std::abs(matrix[column * 4 + 3] - expected[column]) <= affineTolerance) continue;
        throw Failure{element, "matrix is not affine: its last row is not 0 0 0 1"};
    }
}

}  // namespace

std::vector<std::int32_t> pushNodes(const Document& document, const std::vector<DrawnNode>& drawn,
                                    const MeshParts& meshes, const Host& host) {
    std::vector<std::int32_t> indices(document.model.nodes.size(), -1);
    for (const DrawnNode& placed : drawn) {
        const auto index = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& source = document.model.nodes[index];
        const std::string element = elementName("node", index, source.name);
        const std::int32_t parent = placed.parent < 0 ? -1 : indices[static_cast<std::size_t>(placed.parent)];
        candela_node node = identityNode(source.name, parent);
        std::array<float, 16> matrix;
        if (source.matrix.empty()) {
            checkRotation(source.rotation, element);
            copyNumbers(source.translation, node.translation);
            copyNumbers(source.rotation, node.rotation);
            copyNumbers(source.scale, node.scale);
        } else {
            checkMatrix(source.matrix, element);
            copyNumbers(source.matrix, matrix.data());
            node.matrix = matrix.data();
        }
        static const std::vector<std::int32_t> nothing;
        const auto& parts = source.mesh < 0 ? nothing : meshes.at(static_cast<std::size_t>(source.mesh));
        if (!parts.empty()) node.mesh = parts.front();
        indices[index] = host.add(node);
        for (std::size_t part = 1; part < parts.size(); ++part) {
            candela_node child = identityNode(source.name, indices[index]);
            child.mesh = parts[part];
            host.add(child);
        }
    }
    return indices;
}

}  // namespace candela_gltf
