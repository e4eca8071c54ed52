#include "nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "instances.h"

namespace candela_plugins::gltf {
namespace {

std::string nodeName(const tinygltf::Model& model, std::size_t node) {
    return elementName("node", node, model.nodes[node].name);
}

constexpr int unreached = -2, noParent = -1;

/// What KHR_node_visibility says of the node itself.
bool isVisible(const tinygltf::Node& node) {
    const auto extension = node.extensions.find("KHR_node_visibility");
    return extension == node.extensions.end() || !extension->second.Has("visible") ||
           extension->second.Get("visible").Get<bool>();
}

/// Finds one place for each node that the roots reach.
class Hierarchy {
  public:
    Hierarchy(const Document& document, const Host& host)
        : model_(document.model),
          host_(host),
          shownLater_(nodesOfAnimatedVisibility(document.animationPointers)),
          parents_(model_.nodes.size(), unreached),
          children_(model_.nodes.size()) {}

    /// Adds a root with everything under it. `listing` says who names it as a root, for notes.
    void addRoot(int root, const std::string& listing) {
        const auto index = static_cast<std::size_t>(root);
        if (parents_[index] != unreached) {
            note(index, parents_[index] == noParent ? "listed twice by " + listing + ": drawn once"
                                                    : "a child, but listed by " + listing + ": drawn once");
            return;
        }
        parents_[index] = noParent;
        roots_.push_back(root);
        std::vector<int> open{root};
        while (!open.empty()) {
            const int node = open.back();
            open.pop_back();
            for (const int child : model_.nodes[static_cast<std::size_t>(node)].children) {
                if (take(node, child, root, listing)) open.push_back(child);
            }
        }
    }

    bool reaches(std::size_t node) const { return parents_[node] != unreached; }

    std::vector<DrawnNode> nodes() const {
        std::vector<DrawnNode> order, open;
        for (auto root = roots_.rbegin(); root != roots_.rend(); ++root) {
            if (parents_[static_cast<std::size_t>(*root)] == noParent) open.push_back({*root, noParent});
        }
        while (!open.empty()) {
            DrawnNode next = open.back();
            open.pop_back();
            const auto index = static_cast<std::size_t>(next.node);
            const bool isHidden = !isVisible(model_.nodes[index]) && !shownLater_.contains(index);
            next.hidden = next.hidden || isHidden;
            order.push_back(next);
            const std::vector<int>& children = children_[index];
            for (auto child = children.rbegin(); child != children.rend(); ++child) {
                open.push_back({*child, next.node, next.hidden});
            }
        }
        return order;
    }

  private:
    /// Whether `child` is reached for the first time.
    bool take(int parent, int child, int root, const std::string& listing) {
        const auto index = static_cast<std::size_t>(child);
        const int known = parents_[index];
        if (known == noParent && child != root) {
            // A root of before, with all that is under it; `parent` is not, so that there is no cycle.
            note(index, "a child, but listed by " + listing + ": drawn once");
        } else if (known != unreached) {
            const bool isCycle = child == root || isUnder(parent, child);
            note(index, isCycle ? "its own ancestor: that link is left out"
                                : "has two parents: drawn under the first");
            return false;
        }
        parents_[index] = parent;
        children_[static_cast<std::size_t>(parent)].push_back(child);
        return known == unreached;
    }

    bool isUnder(int node, int ancestor) const {
        while (node != ancestor && node >= 0) node = parents_[static_cast<std::size_t>(node)];
        return node == ancestor;
    }

    void note(std::size_t node, const std::string& text) const {
        host_.note(CANDELA_NOTE_REPAIRED, nodeName(model_, node), text);
    }

    const tinygltf::Model& model_;
    const Host& host_;
    std::set<std::size_t> shownLater_;  ///< By animations.
    std::vector<int> parents_;
    std::vector<std::vector<int>> children_;
    std::vector<int> roots_;
};

/// The nodes that are no node's child, and, of each cycle that none of them reaches, its first node.
std::vector<DrawnNode> allNodes(const Document& document, const Host& host) {
    const tinygltf::Model& model = document.model;
    std::vector<bool> isChild(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) isChild[static_cast<std::size_t>(child)] = true;
    }
    Hierarchy hierarchy(document, host);
    for (std::size_t i = 0; i < isChild.size(); ++i) {
        if (!isChild[i]) hierarchy.addRoot(static_cast<int>(i), "the file");
    }
    for (std::size_t i = 0; i < isChild.size(); ++i) {
        if (!hierarchy.reaches(i)) hierarchy.addRoot(static_cast<int>(i), "the file");
    }
    return hierarchy.nodes();
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
    if (model.scenes.empty()) return allNodes(document, host);
    const std::size_t scene = model.defaultScene < 0 ? 0 : static_cast<std::size_t>(model.defaultScene);
    noteFurtherScenes(scene, model.scenes.size(), host);
    // Where the scene has lost its list, all is drawn.
    if (model.scenes[scene].nodes.empty() && document.lostGeometry) return allNodes(document, host);
    Hierarchy hierarchy(document, host);
    for (const int root : model.scenes[scene].nodes) {
        hierarchy.addRoot(root, elementName("scene", scene, model.scenes[scene].name));
    }
    return hierarchy.nodes();
}

namespace {

// The tolerances of the host for unit quaternions and affine matrices.
constexpr double unitTolerance = 0.01, affineTolerance = 1e-5;

candela_node identityNode(const char* name, std::int32_t parent) {
    candela_node node{};
    node.struct_size = sizeof node;
    node.name = name;
    node.parent = parent;
    node.rotation[3] = 1.0f;
    node.scale[0] = node.scale[1] = node.scale[2] = 1.0f;
    node.mesh = -1;
    return node;
}

void copyNumbers(const std::vector<double>& from, float* to) {
    std::transform(from.begin(), from.end(), to, [](double v) { return static_cast<float>(v); });
}

/// What a float loses of a number. Volatile: GCC 12 takes the double for what it becomes as a float where it
/// vectorises this.
double lostByAFloat(double number) {
    const volatile auto kept = static_cast<float>(number);
    return number - static_cast<double>(kept);
}

/// What the floats of a translation lose: survey coordinates have more digits.
void setRemainder(const std::vector<double>& translation, candela_node& node) {
    for (std::size_t i = 0; i < translation.size(); ++i)
        node.translation_remainder[i] = lostByAFloat(translation[i]);
}

/// Brings a quaternion to unit length; one of length 0 becomes no rotation.
void repairRotation(const std::string& element, const Host& host, float (&rotation)[4]) {
    double square = 0.0;
    for (const float number : rotation) square += double{number} * number;
    const double length = std::sqrt(square);
    if (std::abs(length - 1.0) <= unitTolerance) return;
    if (length > 0.0) {
        host.note(CANDELA_NOTE_REPAIRED, element, "rotation is not of length 1: divided by its length");
        for (float& number : rotation) number = static_cast<float>(number / length);
        return;
    }
    host.note(CANDELA_NOTE_REPAIRED, element, "rotation is of length 0: not rotated");
    rotation[3] = 1.0f;
}

void repairMatrix(const std::string& element, const Host& host, std::array<float, 16>& matrix) {
    bool isAffine = true;
    for (std::size_t column = 0; column < 4; ++column) {
        const float expected = column == 3 ? 1.0f : 0.0f;
        float& last = matrix[column * 4 + 3];
        isAffine = isAffine && std::abs(last - expected) <= affineTolerance;
        last = expected;
    }
    if (!isAffine)
        host.note(CANDELA_NOTE_REPAIRED, element, "matrix is not affine: its last row is left out");
}

candela_node nodeOf(const Document& document, std::size_t index, std::int32_t parent,
                    std::array<float, 16>& matrix, const Host& host) {
    const tinygltf::Node& source = document.model.nodes[index];
    const std::string element = elementName("node", index, source.name);
    candela_node node = identityNode(source.name.c_str(), parent);
    if (source.matrix.empty()) {
        copyNumbers(source.translation, node.translation);
        setRemainder(source.translation, node);
        copyNumbers(source.rotation, node.rotation);
        copyNumbers(source.scale, node.scale);
        repairRotation(element, host, node.rotation);
    } else {
        copyNumbers(source.matrix, matrix.data());
        repairMatrix(element, host, matrix);
        node.matrix = matrix.data();
        setRemainder({source.matrix.begin() + 12, source.matrix.begin() + 15}, node);
    }
    node.casts_no_shadow = castsNoShadow(document.shadows.nodes, index);
    node.is_hidden = isVisible(source) ? 0 : 1;
    return node;
}

/// Adds a child of `parent` that shows a mesh.
std::int32_t addPart(const candela_node& parent, std::int32_t parentIndex, std::int32_t mesh,
                     const Placement& placement, const Host& host) {
    candela_node child = identityNode(parent.name, parentIndex);
    std::copy_n(placement.translation.begin(), 3, child.translation);
    std::copy_n(placement.rotation.begin(), 4, child.rotation);
    std::copy_n(placement.scale.begin(), 3, child.scale);
    child.mesh = mesh;
    child.casts_no_shadow = parent.casts_no_shadow;
    return host.add(child);
}

}  // namespace

AddedNodes addNodes(const Document& document, const std::vector<DrawnNode>& drawn, const MeshParts& meshes,
                    const Host& host) {
    const std::size_t count = document.model.nodes.size();
    AddedNodes added{std::vector<std::int32_t>(count, -1), std::vector<std::vector<std::int32_t>>(count)};
    std::vector<std::int32_t>& indices = added.indices;
    for (const DrawnNode& placed : drawn) {
        const auto index = static_cast<std::size_t>(placed.node);
        const int mesh = document.model.nodes[index].mesh;
        const std::int32_t parent = placed.parent < 0 ? -1 : indices[static_cast<std::size_t>(placed.parent)];
        std::array<float, 16> matrix;
        candela_node node = nodeOf(document, index, parent, matrix, host);
        static const std::vector<AddedMesh> nothing;
        const auto& parts = mesh < 0 || placed.hidden ? nothing : meshes.at(static_cast<std::size_t>(mesh));
        const std::optional<std::vector<Placement>> instances = instancesOf(document, index, host);
        if (!parts.empty() && !instances) node.mesh = parts.front().index;
        indices[index] = host.add(node);
        if (!instances) added.parts[index].push_back(indices[index]);
        for (const Placement& placement : instances.value_or(std::vector<Placement>(1))) {
            for (std::size_t part = instances ? 0 : 1; part < parts.size(); ++part)
                added.parts[index].push_back(
                    addPart(node, indices[index], parts[part].index, placement, host));
        }
    }
    return added;
}

namespace {

/// A far plane at or before the near one shows nothing. One that no float holds is none.
float farPlaneOf(double zfar, double znear, const std::string& element, const Host& host) {
    const auto farPlane = static_cast<float>(zfar);
    if (zfar == 0.0 || std::isinf(farPlane)) return 0.0f;
    if (farPlane > static_cast<float>(znear)) return farPlane;
    host.note(CANDELA_NOTE_REPAIRED, element, "zfar is not over znear: left out");
    return 0.0f;
}

candela_camera perspective(const tinygltf::PerspectiveCamera& source, const std::string& element,
                           const Host& host) {
    if (source.yfov <= 0.0) throw Failure{element, "\"perspective\" is missing"};
    if (source.yfov >= std::numbers::pi)
        throw Failure{element, "yfov is " + std::to_string(source.yfov) + ", expected less than pi"};
    candela_camera camera{};
    camera.vertical_fov = static_cast<float>(source.yfov);
    camera.near_plane = static_cast<float>(source.znear);
    camera.far_plane = farPlaneOf(source.zfar, source.znear, element, host);
    return camera;
}

candela_camera orthographic(const tinygltf::OrthographicCamera& source, const std::string& element,
                            const Host& host) {
    const auto height = static_cast<float>(2.0 * std::abs(source.ymag));
    if (!(height > 0.0f) || !std::isfinite(height))
        throw Failure{element, "ymag is " + std::to_string(source.ymag) + ", expected a number over 0"};
    candela_camera camera{};
    camera.orthographic_height = height;
    camera.near_plane = static_cast<float>(std::max(source.znear, 0.0));
    camera.far_plane = farPlaneOf(source.zfar, source.znear, element, host);
    return camera;
}

}  // namespace

AddedCameras addCameras(const Document& document, const std::vector<DrawnNode>& drawn,
                        const std::vector<std::int32_t>& nodes, const Host& host) {
    AddedCameras cameras;
    for (const DrawnNode& placed : drawn) {
        const auto index = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& node = document.model.nodes[index];
        if (node.camera < 0) continue;
        const auto cameraIndex = static_cast<std::size_t>(node.camera);
        const tinygltf::Camera& camera = document.model.cameras.at(cameraIndex);
        const std::string element = elementName("camera", cameraIndex, camera.name);
        if (host.leavesOut([&] { requireUsable(document, element); })) continue;
        host.leavesOut([&] {
            candela_camera added = camera.type == "orthographic"
                                       ? orthographic(camera.orthographic, element, host)
                                       : perspective(camera.perspective, element, host);
            added.struct_size = sizeof added;
            added.name = camera.name.c_str();
            added.node = nodes[index];
            added.number = 1 + static_cast<std::uint32_t>(cameraIndex);
            cameras.emplace(cameraIndex, AddedCamera{host.add(added), added});
        });
    }
    return cameras;
}

}  // namespace candela_plugins::gltf
