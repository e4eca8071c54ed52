#include "animated_properties.h"

#include <algorithm>

#include "specular_glossiness.h"

namespace candela_plugins::gltf {
namespace {

[[noreturn]] void refuse(const AnimationPointer& pointer, const std::string& element,
                         const std::string& reason) {
    throw Failure{element, "pointer '" + readable(pointer.text) + "' " + reason};
}

bool isOfTexture(const PointerTarget& target) {
    return target.row->to == PointerTo::texture;
}

const candela_texture& textureOf(const HostMaterial& material, std::size_t slot) {
    const candela_texture* const basic[] = {
        &material.base.base_color_texture, &material.base.metallic_roughness_texture,
        &material.base.normal_texture, &material.base.emission_texture, &material.base.occlusion_texture};
    return slot < std::size(basic) ? *basic[slot] : material.textures.at(slot - std::size(basic));
}

/// Whether a material that is drawn by its specular-glossiness values takes a property from elsewhere.
bool isReplaced(const PointerTarget& target) {
    if (isOfTexture(target)) {
        return target.slot == CANDELA_SLOT_BASE_COLOR || target.slot == CANDELA_SLOT_METALLIC_ROUGHNESS ||
               target.slot == CANDELA_SLOT_SPECULAR || target.slot == CANDELA_SLOT_SPECULAR_COLOR;
    }
    switch (target.row->value) {
        case CANDELA_PROPERTY_BASE_COLOR:
        case CANDELA_PROPERTY_METALLIC:
        case CANDELA_PROPERTY_ROUGHNESS:
        case CANDELA_PROPERTY_IOR:
        case CANDELA_PROPERTY_SPECULAR_FACTOR:
        case CANDELA_PROPERTY_SPECULAR_COLOR:
            return true;
        default:
            return false;
    }
}

std::vector<std::int32_t> materialsOf(const Document& document, const AddedMaterials& materials,
                                      const PointerTarget& target, const AnimationPointer& pointer,
                                      const std::string& element) {
    if (isReplaced(target) && hasSpecularGlossiness(document.model.materials.at(target.element)))
        refuse(pointer, element, "is of a material that KHR_materials_pbrSpecularGlossiness describes");
    if (isOfTexture(target) && textureOf(materials.added.at(target.element), target.slot).image < 0)
        refuse(pointer, element, "is of a texture that is not drawn");
    std::vector<std::int32_t> indices{static_cast<std::int32_t>(target.element)};
    const auto copy = materials.cageCopies.find(indices.front());
    if (copy != materials.cageCopies.end()) indices.push_back(copy->second);
    return indices;
}

bool hasProperty(const candela_light& light, int property) {
    if (property == CANDELA_PROPERTY_LIGHT_RANGE) return light.range > 0.0f;
    const bool isCone =
        property == CANDELA_PROPERTY_INNER_CONE_ANGLE || property == CANDELA_PROPERTY_OUTER_CONE_ANGLE;
    return !isCone || light.type == CANDELA_LIGHT_SPOT;
}

bool hasProperty(const candela_camera& camera, int property) {
    switch (property) {
        case CANDELA_PROPERTY_VERTICAL_FOV:
            return camera.orthographic_height == 0.0f;
        case CANDELA_PROPERTY_ORTHOGRAPHIC_HEIGHT:
            return camera.orthographic_height > 0.0f;
        case CANDELA_PROPERTY_NEAR_PLANE:
            return camera.near_plane > 0.0f;
        default:
            return camera.far_plane > 0.0f;
    }
}

/// `added` are the elements by the file's index.
template <typename Added>
std::vector<std::int32_t> indicesOf(const Added& added, const PointerTarget& target,
                                    const AnimationPointer& pointer, const std::string& element) {
    std::vector<std::int32_t> indices;
    const auto [first, last] = added.equal_range(target.element);
    for (auto entry = first; entry != last; ++entry) {
        if (!hasProperty(entry->second.source, target.row->value))
            refuse(pointer, element, "leads to a value that is not used");
        indices.push_back(entry->second.index);
    }
    return indices;
}

}  // namespace

std::vector<std::int32_t> animatedElements(const Document& document, const AnimatedElements& elements,
                                           const PointerTarget& target, const AnimationPointer& pointer,
                                           const std::string& element) {
    switch (target.row->to) {
        case PointerTo::node:
            if (elements.nodes.at(target.element) < 0) return {};
            return {elements.nodes[target.element]};
        case PointerTo::light:
            return indicesOf(elements.lights, target, pointer, element);
        case PointerTo::camera:
            return indicesOf(elements.cameras, target, pointer, element);
        default:
            return materialsOf(document, elements.materials, target, pointer, element);
    }
}

std::vector<MorphedNode> animatedWeights(const Document& document, const AnimatedElements& elements,
                                         const PointerTarget& target, const AnimationPointer& pointer,
                                         const std::string& element) {
    std::vector<MorphedNode> found;
    for (const auto& [node, shown] : elements.morphed) {
        const tinygltf::Node& source = document.model.nodes[node];
        const bool isMeant = target.row->to == PointerTo::nodeWeights
                                 ? node == target.element
                                 : source.weights.empty() && source.mesh >= 0 &&
                                       static_cast<std::size_t>(source.mesh) == target.element;
        if (isMeant) found.insert(found.end(), shown.begin(), shown.end());
    }
    if (found.empty()) refuse(pointer, element, "leads to weights of no morph targets that are drawn");
    const auto lacksTarget = [&](const MorphedNode& node) {
        return target.weight && *target.weight >= node.targets;
    };
    if (std::any_of(found.begin(), found.end(), lacksTarget))
        refuse(pointer, element, "leads to a morph target that does not exist");
    return found;
}

}  // namespace candela_plugins::gltf
