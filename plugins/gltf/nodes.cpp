#include "nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace candela_plugins::gltf {
namespace {

std::string nodeName(const tinygltf::Model& model, std::size_t node) {
    return elementName("node", node, model.nodes[node].name);
}

std::vector<int> findParents(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), -1);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
        for (const int child : model.nodes[node].children) {
            int& parent = parents.at(static_cast<std::size_t>(child));
            if (parent >= 0) {
                throw Failure{
                    nodeName(model, static_cast<std::size_t>(child)),
                    "has two parents, nodes " + std::to_string(parent) + " and " + std::to_string(node)};
            }
            parent = static_cast<int>(node);
        }
    }
    return parents;
}

/// Everything under `roots`, parents before children, children in the file's order.
std::vector<DrawnNode> descend(const tinygltf::Model& model, const std::vector<int>& roots) {
    std::vector<DrawnNode> order, open;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, -1});
    while (!open.empty()) {
        const DrawnNode next = open.back();
        open.pop_back();
        order.push_back(next);
        const std::vector<int>& children = model.nodes[static_cast<std::size_t>(next.node)].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            open.push_back({*child, next.node});
        }
    }
    return order;
}

std::vector<int> rootsOf(const std::vector<int>& parents) {
    std::vector<int> roots;
    for (std::size_t node = 0; node < parents.size(); ++node) {
        if (parents[node] < 0) roots.push_back(static_cast<int>(node));
    }
    return roots;
}

/// With one parent each, the nodes that no root reaches are part of a cycle or below one.
void refuseCycles(const tinygltf::Model& model, const std::vector<DrawnNode>& reached) {
    if (reached.size() == model.nodes.size()) return;
    std::vector<bool> seen(model.nodes.size());
    for (const DrawnNode& node : reached) seen[static_cast<std::size_t>(node.node)] = true;
    const auto lost = std::find(seen.begin(), seen.end(), false) - seen.begin();
    throw Failure{nodeName(model, static_cast<std::size_t>(lost)), "its chain of parents is a cycle"};
}

void checkRoots(const tinygltf::Model& model, std::size_t scene, const std::vector<int>& parents) {
    std::vector<bool> seen(model.nodes.size());
    for (const int root : model.scenes[scene].nodes) {
        const auto node = static_cast<std::size_t>(root);
        const std::string element = elementName("scene", scene, model.scenes[scene].name);
        if (parents[node] >= 0) throw Failure{element, nodeName(model, node) + " is not a root"};
        if (seen[node]) throw Failure{element, nodeName(model, node) + " is listed twice"};
        seen[node] = true;
    }
}

void noteFurtherScenes(std::size_t drawn, std::size_t count, const Host& host) {
    if (count < 2) return;
    host.note(CANDELA_NOTE_INFORMATION, "",
              "scene " + std::to_string(drawn) + " of " + std::to_string(count) +
                  " is drawn, the others are left out");
}

}  // namespace

std::vector<DrawnNode> drawnNodes(const Document& document, const Host& host) {
    const tinygltf::Model& model = document.model;
    const std::vector<int> parents = findParents(model);
    std::vector<DrawnNode> all = descend(model, rootsOf(parents));
    refuseCycles(model, all);
    if (model.scenes.empty()) return all;
    const std::size_t scene = model.defaultScene < 0 ? 0 : static_cast<std::size_t>(model.defaultScene);
    checkRoots(model, scene, parents);
    noteFurtherScenes(scene, model.scenes.size(), host);
    return descend(model, model.scenes[scene].nodes);
}

namespace {

// The tolerances of the host for unit quaternions and affine matrices; checked here so that the message names
// the node of the file.
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

std::vector<std::int32_t> addNodes(const Document& document, const std::vector<DrawnNode>& drawn,
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

namespace {

void addPerspective(const tinygltf::Camera& source, const std::string& element, std::uint32_t number,
                    std::int32_t node, const Host& host) {
    if (source.perspective.yfov <= 0.0) throw Failure{element, "\"perspective\" is missing"};
    if (source.perspective.yfov >= std::numbers::pi) {
        throw Failure{element,
                      "yfov is " + std::to_string(source.perspective.yfov) + ", expected less than pi"};
    }
    candela_camera camera{};
    camera.struct_size = sizeof camera;
    camera.name = source.name.c_str();
    camera.vertical_fov = static_cast<float>(source.perspective.yfov);
    camera.near_plane = static_cast<float>(source.perspective.znear);
    camera.node = node;
    camera.number = 1 + number;
    host.add(camera);
}

}  // namespace

void addCameras(const Document& document, const std::vector<DrawnNode>& drawn,
                const std::vector<std::int32_t>& nodes, const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto index = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& node = document.model.nodes[index];
        if (node.camera < 0) continue;
        const auto cameraIndex = static_cast<std::size_t>(node.camera);
        const tinygltf::Camera& camera = document.model.cameras.at(cameraIndex);
        const std::string element = elementName("camera", cameraIndex, camera.name);
        if (camera.type == "orthographic") {
            host.note(CANDELA_NOTE_MISSING, element, "orthographic: left out");
            continue;
        }
        addPerspective(camera, element, static_cast<std::uint32_t>(cameraIndex), nodes[index], host);
    }
}

namespace {

std::optional<std::size_t> lightOf(const tinygltf::Node& node) {
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) return std::nullopt;
    return static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
}

candela_light_type typeOf(const std::string& type, const std::string& element) {
    if (type == "point") return CANDELA_LIGHT_POINT;
    if (type == "spot") return CANDELA_LIGHT_SPOT;
    if (type == "directional") return CANDELA_LIGHT_DIRECTIONAL;
    throw Failure{element, "type '" + readable(type) + "', expected point, spot or directional"};
}

void readCone(const tinygltf::SpotLight& spot, const std::string& element, candela_light& light) {
    light.inner_cone_angle = static_cast<float>(spot.innerConeAngle);
    light.outer_cone_angle =
        std::min(static_cast<float>(spot.outerConeAngle), std::numbers::pi_v<float> / 2.0f);
    if (light.inner_cone_angle < light.outer_cone_angle) return;
    throw Failure{element, "innerConeAngle " + std::to_string(light.inner_cone_angle) +
                               " is not less than outerConeAngle " + std::to_string(light.outer_cone_angle)};
}

}  // namespace

void addLights(const Document& document, const std::vector<DrawnNode>& drawn,
               const std::vector<std::int32_t>& nodes, const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto nodeIndex = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& node = document.model.nodes[nodeIndex];
        const std::optional<std::size_t> index = lightOf(node);
        if (!index) continue;
        const tinygltf::Light& source = document.model.lights.at(*index);
        const std::string element = elementName("light", *index, source.name);
        candela_light light{};
        light.struct_size = sizeof light;
        light.name = source.name.empty() ? node.name.c_str() : source.name.c_str();
        light.type = typeOf(source.type, element);
        std::fill_n(light.color, 3, 1.0f);
        std::transform(source.color.begin(), source.color.end(), light.color,
                       [](double v) { return static_cast<float>(v); });
        light.intensity = static_cast<float>(source.intensity);
        light.range = static_cast<float>(source.range);
        light.direction[2] = -1.0f;
        light.node = nodes[nodeIndex];
        if (light.type == CANDELA_LIGHT_SPOT) readCone(source.spot, element, light);
        host.add(light);
    }
}

}  // namespace candela_plugins::gltf
