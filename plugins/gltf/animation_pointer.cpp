#include "animation_pointer.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <numbers>
#include <string_view>

#include "../common/failure.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;
using Tokens = std::vector<std::string>;
using To = PointerTo;

constexpr float least = 1e-6f;  // the host's, of what is over 0
constexpr float pi = std::numbers::pi_v<float>, most = 1e9f, brightest = 1e20f;

constexpr PointerRow rows[] = {
    {"/nodes/{}/translation", To::nodePath, CANDELA_ANIMATE_TRANSLATION, 3},
    {"/nodes/{}/rotation", To::nodePath, CANDELA_ANIMATE_ROTATION, 4},
    {"/nodes/{}/scale", To::nodePath, CANDELA_ANIMATE_SCALE, 3},
    {"/nodes/{}/weights", To::nodeWeights, CANDELA_ANIMATE_MORPH_WEIGHTS, 1},
    {"/nodes/{}/weights/{}", To::nodeWeights, CANDELA_PROPERTY_MORPH_WEIGHT, 1},
    {"/meshes/{}/weights", To::meshWeights, CANDELA_ANIMATE_MORPH_WEIGHTS, 1},
    {"/meshes/{}/weights/{}", To::meshWeights, CANDELA_PROPERTY_MORPH_WEIGHT, 1},
    {"/nodes/{}/extensions/KHR_node_visibility/visible", To::node, CANDELA_PROPERTY_VISIBILITY, 1},
    {"/materials/{}/pbrMetallicRoughness/baseColorFactor", To::material, CANDELA_PROPERTY_BASE_COLOR, 4, 0,
     1},
    {"/materials/{}/pbrMetallicRoughness/metallicFactor", To::material, CANDELA_PROPERTY_METALLIC, 1, 0, 1},
    {"/materials/{}/pbrMetallicRoughness/roughnessFactor", To::material, CANDELA_PROPERTY_ROUGHNESS, 1, 0, 1},
    {"/materials/{}/emissiveFactor", To::material, CANDELA_PROPERTY_EMISSION, 3, 0, 1},
    {"/materials/{}/alphaCutoff", To::material, CANDELA_PROPERTY_ALPHA_CUTOFF, 1, 0},
    {"/materials/{}/normalTexture/scale", To::material, CANDELA_PROPERTY_NORMAL_SCALE, 1},
    {"/materials/{}/occlusionTexture/strength", To::material, CANDELA_PROPERTY_OCCLUSION_STRENGTH, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_emissive_strength/emissiveStrength", To::material,
     CANDELA_PROPERTY_EMISSION_STRENGTH, 1, 0, brightest},
    {"/materials/{}/extensions/KHR_materials_ior/ior", To::material, CANDELA_PROPERTY_IOR, 1, 1},
    {"/materials/{}/extensions/KHR_materials_specular/specularFactor", To::material,
     CANDELA_PROPERTY_SPECULAR_FACTOR, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_specular/specularColorFactor", To::material,
     CANDELA_PROPERTY_SPECULAR_COLOR, 3, 0},
    {"/materials/{}/extensions/KHR_materials_clearcoat/clearcoatFactor", To::material,
     CANDELA_PROPERTY_CLEARCOAT_FACTOR, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor", To::material,
     CANDELA_PROPERTY_CLEARCOAT_ROUGHNESS, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale", To::material,
     CANDELA_PROPERTY_CLEARCOAT_NORMAL_SCALE, 1},
    {"/materials/{}/extensions/KHR_materials_sheen/sheenColorFactor", To::material,
     CANDELA_PROPERTY_SHEEN_COLOR, 3, 0, 1},
    {"/materials/{}/extensions/KHR_materials_sheen/sheenRoughnessFactor", To::material,
     CANDELA_PROPERTY_SHEEN_ROUGHNESS, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_anisotropy/anisotropyStrength", To::material,
     CANDELA_PROPERTY_ANISOTROPY_STRENGTH, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_anisotropy/anisotropyRotation", To::material,
     CANDELA_PROPERTY_ANISOTROPY_ROTATION, 1},
    {"/materials/{}/extensions/KHR_materials_iridescence/iridescenceFactor", To::material,
     CANDELA_PROPERTY_IRIDESCENCE_FACTOR, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_iridescence/iridescenceIor", To::material,
     CANDELA_PROPERTY_IRIDESCENCE_IOR, 1, 1},
    {"/materials/{}/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum", To::material,
     CANDELA_PROPERTY_IRIDESCENCE_MIN_THICKNESS, 1, 0},
    {"/materials/{}/extensions/KHR_materials_iridescence/iridescenceThicknessMaximum", To::material,
     CANDELA_PROPERTY_IRIDESCENCE_MAX_THICKNESS, 1, 0},
    {"/materials/{}/extensions/KHR_materials_transmission/transmissionFactor", To::material,
     CANDELA_PROPERTY_TRANSMISSION_FACTOR, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_volume/thicknessFactor", To::material,
     CANDELA_PROPERTY_THICKNESS, 1, 0},
    {"/materials/{}/extensions/KHR_materials_volume/attenuationDistance", To::material,
     CANDELA_PROPERTY_ATTENUATION_DISTANCE, 1, least},
    {"/materials/{}/extensions/KHR_materials_volume/attenuationColor", To::material,
     CANDELA_PROPERTY_ATTENUATION_COLOR, 3, 0, 1},
    {"/materials/{}/extensions/KHR_materials_dispersion/dispersion", To::material,
     CANDELA_PROPERTY_DISPERSION, 1, 0},
    {"/materials/{}/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionFactor", To::material,
     CANDELA_PROPERTY_DIFFUSE_TRANSMISSION_FACTOR, 1, 0, 1},
    {"/materials/{}/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorFactor",
     To::material, CANDELA_PROPERTY_DIFFUSE_TRANSMISSION_COLOR, 3, 0, 1},
    {"/extensions/KHR_lights_punctual/lights/{}/color", To::light, CANDELA_PROPERTY_LIGHT_COLOR, 3, 0},
    {"/extensions/KHR_lights_punctual/lights/{}/intensity", To::light, CANDELA_PROPERTY_LIGHT_INTENSITY, 1, 0,
     brightest},
    {"/extensions/KHR_lights_punctual/lights/{}/range", To::light, CANDELA_PROPERTY_LIGHT_RANGE, 1, least,
     most, false},
    {"/extensions/KHR_lights_punctual/lights/{}/spot/innerConeAngle", To::light,
     CANDELA_PROPERTY_INNER_CONE_ANGLE, 1, 0, pi / 2},
    {"/extensions/KHR_lights_punctual/lights/{}/spot/outerConeAngle", To::light,
     CANDELA_PROPERTY_OUTER_CONE_ANGLE, 1, least, pi / 2},
    {"/cameras/{}/perspective/yfov", To::camera, CANDELA_PROPERTY_VERTICAL_FOV, 1, least, pi - least},
    {"/cameras/{}/perspective/znear", To::camera, CANDELA_PROPERTY_NEAR_PLANE, 1, least},
    {"/cameras/{}/perspective/zfar", To::camera, CANDELA_PROPERTY_FAR_PLANE, 1, least, most, false},
    // ymag is half the height.
    {"/cameras/{}/orthographic/ymag", To::camera, CANDELA_PROPERTY_ORTHOGRAPHIC_HEIGHT, 1, least, most, true,
     2.0f},
    {"/cameras/{}/orthographic/znear", To::camera, CANDELA_PROPERTY_NEAR_PLANE, 1, 0},
    {"/cameras/{}/orthographic/zfar", To::camera, CANDELA_PROPERTY_FAR_PLANE, 1, least, most, false},
};

/// Of KHR_texture_transform, behind the texture.
constexpr PointerRow transformRows[] = {
    {"/extensions/KHR_texture_transform/offset", To::texture, CANDELA_PROPERTY_TEXTURE_OFFSET, 2},
    {"/extensions/KHR_texture_transform/rotation", To::texture, CANDELA_PROPERTY_TEXTURE_ROTATION, 1},
    {"/extensions/KHR_texture_transform/scale", To::texture, CANDELA_PROPERTY_TEXTURE_SCALE, 2},
};

/// In the order of candela_texture_slot.
constexpr const char* texturePatterns[] = {
    "/materials/{}/pbrMetallicRoughness/baseColorTexture",
    "/materials/{}/pbrMetallicRoughness/metallicRoughnessTexture",
    "/materials/{}/normalTexture",
    "/materials/{}/emissiveTexture",
    "/materials/{}/occlusionTexture",
    "/materials/{}/extensions/KHR_materials_specular/specularTexture",
    "/materials/{}/extensions/KHR_materials_specular/specularColorTexture",
    "/materials/{}/extensions/KHR_materials_clearcoat/clearcoatTexture",
    "/materials/{}/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture",
    "/materials/{}/extensions/KHR_materials_clearcoat/clearcoatNormalTexture",
    "/materials/{}/extensions/KHR_materials_sheen/sheenColorTexture",
    "/materials/{}/extensions/KHR_materials_sheen/sheenRoughnessTexture",
    "/materials/{}/extensions/KHR_materials_anisotropy/anisotropyTexture",
    "/materials/{}/extensions/KHR_materials_iridescence/iridescenceTexture",
    "/materials/{}/extensions/KHR_materials_iridescence/iridescenceThicknessTexture",
    "/materials/{}/extensions/KHR_materials_transmission/transmissionTexture",
    "/materials/{}/extensions/KHR_materials_volume/thicknessTexture",
    "/materials/{}/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionTexture",
    "/materials/{}/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorTexture",
};

/// RFC 6901: the parts between slashes, where "~1" stands for a slash and "~0" for "~"; none where the text
/// is no JSON pointer to a member.
std::optional<Tokens> tokensOf(std::string_view text) {
    if (!text.starts_with('/')) return std::nullopt;
    Tokens tokens;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '/') {
            tokens.emplace_back();
        } else if (text[at] != '~') {
            tokens.back() += text[at];
        } else {
            const char code = ++at < text.size() ? text[at] : '\0';
            if (code != '0' && code != '1') return std::nullopt;
            tokens.back() += code == '0' ? '~' : '/';
        }
    }
    return tokens;
}

/// A decimal number without leading zeros.
std::optional<std::size_t> indexOf(std::string_view token) {
    std::size_t index = 0;
    const auto [stop, error] = std::from_chars(token.data(), token.data() + token.size(), index);
    const bool isIndex = error == std::errc{} && stop == token.data() + token.size() &&
                         (token.size() == 1 || token.front() != '0');
    return isIndex ? std::optional(index) : std::nullopt;
}

/// The value that tokens lead to; null where there is none.
const Json* find(const Json& document, const Tokens& tokens, std::size_t count) {
    const Json* value = &document;
    for (std::size_t i = 0; i < count; ++i) {
        if (value->is_object()) {
            const auto member = value->find(tokens[i]);
            if (member == value->end()) return nullptr;
            value = &*member;
            continue;
        }
        const std::optional<std::size_t> index = indexOf(tokens[i]);
        if (!value->is_array() || !index || *index >= value->size()) return nullptr;
        value = &(*value)[*index];
    }
    return value;
}

/// The indices that stand for "{}" where the tokens from `first` to `end` match a pattern.
std::optional<std::vector<std::size_t>> match(const Tokens& tokens, std::size_t first, std::size_t end,
                                              std::string_view pattern) {
    std::vector<std::size_t> indices;
    for (std::size_t i = first; i < end; ++i) {
        if (pattern.empty()) return std::nullopt;
        pattern.remove_prefix(1);  // the slash
        const std::string_view part = pattern.substr(0, pattern.find('/'));
        pattern.remove_prefix(part.size());
        const std::optional<std::size_t> index = part == "{}" ? indexOf(tokens[i]) : std::nullopt;
        if (!index && (part == "{}" || part != tokens[i])) return std::nullopt;
        if (index) indices.push_back(*index);
    }
    return pattern.empty() ? std::optional(indices) : std::nullopt;
}

std::optional<PointerTarget> findTexture(const Tokens& tokens) {
    constexpr std::size_t behind = 3;  // tokens of a row
    if (tokens.size() <= behind) return std::nullopt;
    const std::size_t split = tokens.size() - behind;
    for (const PointerRow& row : transformRows) {
        if (!match(tokens, split, tokens.size(), row.pattern)) continue;
        for (std::size_t slot = 0; slot < std::size(texturePatterns); ++slot) {
            if (const auto indices = match(tokens, 0, split, texturePatterns[slot]))
                return PointerTarget{&row, indices->front(), {}, slot};
        }
    }
    return std::nullopt;
}

std::optional<PointerTarget> findTarget(const Tokens& tokens) {
    for (const PointerRow& row : rows) {
        const auto indices = match(tokens, 0, tokens.size(), row.pattern);
        if (!indices) continue;
        PointerTarget target{&row, indices->front(), {}, 0};
        if (indices->size() > 1) target.weight = (*indices)[1];
        return target;
    }
    return findTexture(tokens);
}

}  // namespace

AnimationPointers takeAnimationPointers(Json& document) {
    AnimationPointers pointers;
    if (!document.contains("animations")) return pointers;
    const Json::json_pointer place("/target/extensions/KHR_animation_pointer/pointer");
    std::size_t animation = 0;
    for (Json& source : document["animations"]) {
        std::size_t index = 0;
        for (Json& channel : source["channels"]) {
            const std::pair key(animation, index++);
            if (channel.contains(place)) {
                AnimationPointer pointer{channel[place].get<std::string>()};
                if (const auto tokens = tokensOf(pointer.text)) {
                    const Json* object = find(document, *tokens, tokens->size() - 1);
                    pointer.hasObject = object != nullptr;
                    pointer.hasValue = object && find(document, *tokens, tokens->size());
                }
                pointers.emplace(key, std::move(pointer));
            }
            channel["target"].erase("extensions");
        }
        ++animation;
    }
    return pointers;
}

PointerTarget resolvePointer(const AnimationPointer& pointer, const std::string& element) {
    const std::string quoted = "pointer '" + readable(pointer.text) + "' ";
    const std::optional<Tokens> tokens = tokensOf(pointer.text);
    if (!tokens) throw Failure{element, quoted + "is no JSON pointer"};
    const std::optional<PointerTarget> target = findTarget(*tokens);
    if (!target) throw Failure{element, quoted + "leads to nothing that is animated"};
    // An array of weights has a default: who animates one of them checks that there is such a target.
    const bool hasObject = pointer.hasObject || target->weight;
    if (!hasObject || (!target->row->hasDefault && !pointer.hasValue))
        throw Failure{element, quoted + "leads to what the file does not have"};
    return *target;
}

std::set<std::size_t> nodesOfAnimatedVisibility(const AnimationPointers& pointers) {
    std::set<std::size_t> nodes;
    for (const auto& [channel, pointer] : pointers) {
        const std::optional<Tokens> tokens = tokensOf(pointer.text);
        const std::optional<PointerTarget> target = tokens ? findTarget(*tokens) : std::nullopt;
        if (target && target->row->value == CANDELA_PROPERTY_VISIBILITY && target->row->to == To::node)
            nodes.insert(target->element);
    }
    return nodes;
}

}  // namespace candela_plugins::gltf
