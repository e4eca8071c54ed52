#include "parts.h"

#include <algorithm>

#include "numbering.h"

namespace candela_obj {
namespace {

std::string nameOf(const Document& document, const FaceState& state, SplitAt splitAt) {
    const std::string& object = document.objects[state.object];
    const std::string& group = document.groups[state.group];
    // A cage of no object takes the name of its first group.
    if (object.empty()) return group;
    if (splitAt == SplitAt::objects || group.empty()) return object;
    return object + "/" + group;
}

}  // namespace

std::vector<Part> splitFaces(const Document& document, SplitAt splitAt) {
    std::vector<Part> parts;
    Numbering numbering;
    std::vector<std::uint32_t> partOfState(document.states.size());
    std::transform(document.states.begin(), document.states.end(), partOfState.begin(),
                   [&](const FaceState& state) {
                       const std::uint32_t group = splitAt == SplitAt::objects ? 0 : state.group;
                       const std::uint32_t part = numbering.numberOf({state.object, group, 0});
                       if (part == parts.size()) parts.push_back({nameOf(document, state, splitAt), {}});
                       return part;
                   });
    for (std::size_t face = 0; face < document.faces.size(); ++face)
        parts[partOfState[document.faces[face].state]].faces.push_back(static_cast<std::uint32_t>(face));
    return parts;
}

}  // namespace candela_obj
