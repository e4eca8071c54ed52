#include "parts.h"

#include <algorithm>

#include "indexing.h"

namespace candela_plugins::obj {

namespace {

std::string nameOf(const Document& document, const FaceState& state, SplitAt splitAt) {
    const std::string& object = document.objects[state.object];
    const std::string& group = document.groups[state.group];
    // A cage without an object has the name of its first group.
    if (object.empty()) return group;
    if (splitAt == SplitAt::objects || group.empty()) return object;
    return object + "/" + group;
}

}  // namespace

std::vector<Part> splitFaces(const Document& document, SplitAt splitAt) {
    std::vector<Part> parts;
    KeyIndex keys;
    std::vector<std::uint32_t> partOfState(document.states.size());
    std::transform(document.states.begin(), document.states.end(), partOfState.begin(),
                   [&](const FaceState& state) {
                       const std::uint32_t group = splitAt == SplitAt::objects ? 0 : state.group;
                       const std::uint32_t part = keys.indexOf({state.object, group, 0});
                       if (part == parts.size()) parts.push_back({nameOf(document, state, splitAt), {}, {}});
                       return part;
                   });
    for (std::size_t face = 0; face < document.faces.size(); ++face)
        parts[partOfState[document.faces[face].state]].faces.push_back(static_cast<std::uint32_t>(face));
    for (std::uint32_t element = 0; element < document.looseElements.size(); ++element)
        parts[partOfState[document.looseElements[element].state]].looseElements.push_back(element);
    // All of its faces were left out.
    std::erase_if(parts, [](const Part& part) { return part.faces.empty() && part.looseElements.empty(); });
    return parts;
}

std::int32_t addNode(const std::string& name, const Vec3& origin, std::int32_t mesh, const Host& host) {
    candela_node node{};
    node.struct_size = sizeof node;
    node.name = name.c_str();
    node.parent = -1;
    std::copy_n(&origin.x, 3, node.translation);
    node.rotation[3] = 1.0f;
    std::fill_n(node.scale, 3, 1.0f);
    node.mesh = mesh;
    return host.add(node);
}

}  // namespace candela_plugins::obj
