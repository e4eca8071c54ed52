#include "uv_slots.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "primitives.h"
#include "variants.h"

namespace candela_plugins::gltf {
namespace {

/// The sets that textures with an image read.
std::vector<int> setsOf(const Document& document, const tinygltf::Material& material) {
    std::vector<int> sets;
    for (const TextureUse& use : textureUses(material).all()) {
        const bool hasImage = document.model.textures.at(static_cast<std::size_t>(use.texture)).source >= 0;
        if (hasImage) sets.push_back(use.set);
    }
    return sets;
}

/// Materials that share their slots, and the primitives that have them.
struct MaterialGroup {
    std::vector<int> sets;  ///< Those that the materials read, each once; those that matter most first.
    std::vector<const tinygltf::Primitive*> primitives;

    void addSets(const std::vector<int>& added) {
        for (const int set : added) {
            if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
        }
    }

    bool areEqual(int a, int b) const {
        return !primitives.empty() &&
               std::all_of(primitives.begin(), primitives.end(), [&](const tinygltf::Primitive* primitive) {
                   const int accessor = accessorOf(*primitive, "TEXCOORD_" + std::to_string(a));
                   return accessor >= 0 &&
                          accessor == accessorOf(*primitive, "TEXCOORD_" + std::to_string(b));
               });
    }

    /// Leaves out the sets that are equal to an earlier one, and returns that one for each of them.
    std::map<int, int> mergeSets() {
        std::map<int, int> merged;
        for (std::size_t i = 1; i < sets.size(); ++i) {
            for (std::size_t earlier = 0; earlier < i; ++earlier) {
                if (areEqual(sets[earlier], sets[i])) merged.emplace(sets[i], sets[earlier]);
            }
        }
        std::erase_if(sets, [&](int set) { return merged.contains(set); });
        return merged;
    }
};

/// The sets in the slots of the host, of which there are `most`.
std::vector<int> slotsFor(std::vector<int> sets, std::size_t most) {
    UvSlots slots;
    sets.resize(std::min(sets.size(), most));
    const auto isRead = [&](int set) { return std::find(sets.begin(), sets.end(), set) != sets.end(); };
    for (const int set : sets) {
        if (slots.find(set) >= 0) continue;
        const auto free = std::find_if_not(slots.sets.begin(), slots.sets.end(), isRead);
        if (free == slots.sets.end())
            slots.sets.push_back(set);
        else
            *free = set;
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
    const auto equal = equals.find(set);
    const auto found = std::find(sets.begin(), sets.end(), equal == equals.end() ? set : equal->second);
    return found == sets.end() ? -1 : static_cast<int>(found - sets.begin());
}

std::string UvSlots::attribute(std::size_t slot) const {
    return slot < sets.size() ? "TEXCOORD_" + std::to_string(sets[slot]) : std::string();
}

std::vector<UvSlots> uvSlotsOf(const Document& document, std::size_t most) {
    const std::vector<tinygltf::Material>& materials = document.model.materials;
    MaterialGroups heads(materials.size());
    for (const tinygltf::Mesh& mesh : document.model.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) heads.join(materialsOf(primitive));
    }
    std::map<std::size_t, MaterialGroup> groups;
    for (std::size_t i = 0; i < materials.size(); ++i)
        groups[heads.find(i)].addSets(setsOf(document, materials[i]));
    for (const tinygltf::Mesh& mesh : document.model.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const std::vector<std::size_t> all = materialsOf(primitive);
            if (!all.empty()) groups[heads.find(all.front())].primitives.push_back(&primitive);
        }
    }
    std::map<std::size_t, UvSlots> slotsOfGroups;
    for (auto& [head, group] : groups) {
        UvSlots& slots = slotsOfGroups[head];
        if (group.sets.size() > slots.sets.size()) slots.equals = group.mergeSets();
        slots.sets = slotsFor(group.sets, most);
    }
    std::vector<UvSlots> slots;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        slots.push_back(slotsOfGroups[heads.find(i)]);
        for (const int set : setsOf(document, materials[i])) {
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
