#include "uv_slots.h"

#include <algorithm>

namespace candela_plugins::gltf {
namespace {

/// The sets that textures with an image read, each once.
void addSets(const Document& document, const tinygltf::Material& material, std::vector<int>& sets) {
    for (const TextureUse& use : textureUses(material).all()) {
        const bool hasImage = document.model.textures.at(static_cast<std::size_t>(use.texture)).source >= 0;
        if (hasImage && std::find(sets.begin(), sets.end(), use.set) == sets.end()) sets.push_back(use.set);
    }
}

UvSlots slotsFor(std::vector<int> sets) {
    UvSlots slots;
    sets.resize(std::min(sets.size(), slots.sets.size()));
    const auto isFree = [&](std::size_t slot) {
        return std::find(sets.begin(), sets.end(), slots.sets[slot]) == sets.end();
    };
    for (const int set : sets) {
        if (slots.find(set) < 0) slots.sets[isFree(0) ? 0 : 1] = set;
        slots.isRead[static_cast<std::size_t>(slots.find(set))] = true;
    }
    return slots;
}

}  // namespace

int UvSlots::find(int set) const {
    const auto found = std::find(sets.begin(), sets.end(), set);
    return found == sets.end() ? -1 : static_cast<int>(found - sets.begin());
}

std::string UvSlots::attribute(std::size_t slot) const {
    return "TEXCOORD_" + std::to_string(sets[slot]);
}

std::vector<UvSlots> uvSlotsOf(const Document& document) {
    std::vector<UvSlots> slots;
    for (const tinygltf::Material& material : document.model.materials) {
        std::vector<int> sets;
        addSets(document, material, sets);
        slots.push_back(slotsFor(std::move(sets)));
    }
    return slots;
}

}  // namespace candela_plugins::gltf
