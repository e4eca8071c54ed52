#include "hierarchy.h"

#include <algorithm>

namespace candela_gltf {
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

/// With one parent each, the nodes that no root reaches run in a circle or hang under one.
void refuseCycles(const tinygltf::Model& model, const std::vector<DrawnNode>& reached) {
    if (reached.size() == model.nodes.size()) return;
    std::vector<bool> seen(model.nodes.size());
    for (const DrawnNode& node : reached) seen[static_cast<std::size_t>(node.node)] = true;
    const auto lost = std::find(seen.begin(), seen.end(), false) - seen.begin();
    throw Failure{nodeName(model, static_cast<std::size_t>(lost)), "its chain of parents is a circle"};
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
    host.note("scene " + std::to_string(drawn) + " of " + std::to_string(count) +
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

}  // namespace candela_gltf
