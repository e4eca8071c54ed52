#include "uv_slots.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "variants.h"

namespace candela_plugins::gltf {
namespace {

/// The sets that textures with an image read, each once.
void addSets(const Document& document, const tinygltf::Material& material, std::vector<int>& sets) {
    for (const TextureUse& use : textureUses(material).all()) {
        const bool hasImage = document.model.textures.at(static_cast<std::size_t>(use.texture)).source >= 0;
        if (hasImage && std::find(sets.begin(), sets.end(), use.set) == sets.end()) sets.push_back(use.set);
    }
}

/// The sets in the slots of the host.
std::array<int, 2> slotsFor(std::vector<int> sets) {
    UvSlots slots;
    sets.resize(std::min(sets.size(), slots.sets.size()));
    const auto isFree = [&](std::size_t slot) {
        return std::find(sets.begin(), sets.end(), slots.sets[slot]) == sets.end();
    };
    for (const int set : sets) {
        if (slots.find(set) < 0) slots.sets[isFree(0) ? 0 : 1] = set;
    }
    return slots.sets;
}

/// Materials of which a primitive may have one or the other share their slots.
class MaterialGroups {
  public:
    explicit MaterialGroups(std::size_t materials) : parents_(materials) {
        std::iota(parents_.begin(), parents_.end(), std::size_t(0));
    }

    /// The material that stands for the group of `material`.
    std::size_t find(std::size_t material) const {
        while (parents_[material] != material) material = parents_[material];
        return material;
    }

    void join(const std::vector<std::size_t>& materials) {
        for (const std::size_t material : materials) {
            const std::size_t a = find(materials.front()), b = find(material);
            parents_[std::max(a, b)] = std::min(a, b);
        }
    }

  private:
    std::vector<std::size_t> parents_;
};

}  // namespace

int UvSlots::find(int set) const {
    const auto found = std::find(sets.begin(), sets.end(), set);
    return found == sets.end() ? -1 : static_cast<int>(found - sets.begin());
}

std::string UvSlots::attribute(std::size_t slot) const {
    return "TEXCOORD_" + std::to_string(sets[slot]);
}

std::vector<UvSlots> uvSlotsOf(const Document& document) {
    const std::vector<tinygltf::Material>& materials = document.model.materials;
    MaterialGroups groups(materials.size());
    for (const tinygltf::Mesh& mesh : document.model.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) groups.join(materialsOf(primitive));
    }
    std::map<std::size_t, std::vector<int>> setsOfGroups;
    for (std::size_t i = 0; i < materials.size(); ++i)
        addSets(document, materials[i], setsOfGroups[groups.find(i)]);
    std::vector<UvSlots> slots;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        slots.push_back({slotsFor(setsOfGroups[groups.find(i)]), {}});
        std::vector<int> own;
        addSets(document, materials[i], own);
        for (const int set : own) {
            const int slot = slots.back().find(set);
            if (slot >= 0) slots.back().isRead[static_cast<std::size_t>(slot)] = true;
        }
    }
    return slots;
}

UvSlots uvSlotsOf(const tinygltf::Primitive& primitive, const std::vector<UvSlots>& ofMaterials) {
    UvSlots slots;
    for (const std::size_t material : materialsOf(primitive)) {
        const UvSlots& own = ofMaterials.at(material);
        slots.sets = own.sets;
        for (std::size_t slot = 0; slot < slots.isRead.size(); ++slot)
            slots.isRead[slot] = slots.isRead[slot] || own.isRead[slot];
    }
    return slots;
}

}  // namespace candela_plugins::gltf
