#include "materials.h"

#include <algorithm>
#include <iterator>

#include "../common/image.h"

namespace candela_plugins::gltf {
namespace {

void markTexture(const Document& document, int texture, std::vector<bool>& used) {
    if (texture < 0) return;
    const int image = document.model.textures.at(static_cast<std::size_t>(texture)).source;
    if (image >= 0) used.at(static_cast<std::size_t>(image)) = true;
}

std::vector<bool> imagesInUse(const Document& document) {
    std::vector<bool> used(document.imageSources.size());
    for (const tinygltf::Material& material : document.model.materials) {
        markTexture(document, material.pbrMetallicRoughness.baseColorTexture.index, used);
        markTexture(document, material.pbrMetallicRoughness.metallicRoughnessTexture.index, used);
        markTexture(document, material.normalTexture.index, used);
        markTexture(document, material.occlusionTexture.index, used);
        markTexture(document, material.emissiveTexture.index, used);
    }
    return used;
}

/// An image without a name has that of its file.
std::string imageName(const Source& source) {
    const bool hasFile = source.uri && !isDataUri(*source.uri);
    return source.name.empty() && hasFile ? *source.uri : source.name;
}

}  // namespace

Bytes imageFile(const Document& document, std::size_t index, const std::string& element, Storage& storage,
                const Host& host) {
    const Source& source = document.imageSources.at(index);
    requireUsable(document, elementName("image", index, source.name));
    if (source.uri) return loadUri(*source.uri, element, storage, host);
    if (source.bufferView) return viewBytes(document, *source.bufferView, element);
    throw Failure{element, "neither a URI nor a bufferView"};
}

std::vector<std::int32_t> addImages(const Document& document, Storage& storage, const Host& host, double from,
                                    double to) {
    const std::vector<bool> used = imagesInUse(document);
    std::vector<ImageJob> jobs;
    std::vector<std::size_t> images;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const Source& source = document.imageSources[i];
        const std::string element = elementName("image", i, source.name);
        host.leavesOut([&] {
            const Bytes file = imageFile(document, i, element, storage, host);
            jobs.push_back(
                {imageName(source), decodedSize(file), [=] { return decodeImage(file, element); }});
            images.push_back(i);
        });
    }
    const std::vector<std::int32_t> added = addImages(jobs, host, from, to);
    std::vector<std::int32_t> indices(used.size(), -1);
    for (std::size_t job = 0; job < jobs.size(); ++job) indices[images[job]] = added[job];
    return indices;
}

namespace {

const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

float numberOr(const tinygltf::Value& object, const char* name, float fallback) {
    return object.Has(name) ? static_cast<float>(object.Get(name).GetNumberAsDouble()) : fallback;
}

void readPair(const tinygltf::Value& object, const char* name, float (&pair)[2]) {
    if (!object.Has(name)) return;
    for (int i = 0; i < 2; ++i) pair[i] = static_cast<float>(object.Get(name).Get(i).GetNumberAsDouble());
}

void noteSampler(const Host& host, const std::string& element, const char* member, int value) {
    host.note(CANDELA_NOTE_REPAIRED, element,
              std::string(member) + " " + std::to_string(value) + " does not exist: the default is used");
}

candela_wrap wrapOf(int value, const char* member, const std::string& element, const Host& host) {
    switch (value) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return CANDELA_WRAP_CLAMP_TO_EDGE;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return CANDELA_WRAP_MIRRORED_REPEAT;
        default:
            if (value != TINYGLTF_TEXTURE_WRAP_REPEAT) noteSampler(host, element, member, value);
            return CANDELA_WRAP_REPEAT;
    }
}

candela_filter minFilterOf(int value, const std::string& element, const Host& host) {
    constexpr int none = -1;
    switch (value) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
            return CANDELA_FILTER_NEAREST;
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            return CANDELA_FILTER_LINEAR;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
            return CANDELA_FILTER_NEAREST_MIPMAP_NEAREST;
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
            return CANDELA_FILTER_LINEAR_MIPMAP_NEAREST;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            return CANDELA_FILTER_NEAREST_MIPMAP_LINEAR;
        default:
            if (value != none && value != TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR)
                noteSampler(host, element, "minFilter", value);
            return CANDELA_FILTER_LINEAR_MIPMAP_LINEAR;
    }
}

candela_filter magFilterOf(int value, const std::string& element, const Host& host) {
    constexpr int none = -1;
    if (value == TINYGLTF_TEXTURE_FILTER_NEAREST) return CANDELA_FILTER_NEAREST;
    if (value != none && value != TINYGLTF_TEXTURE_FILTER_LINEAR)
        noteSampler(host, element, "magFilter", value);
    return CANDELA_FILTER_LINEAR;
}

candela_texture noTexture() {
    candela_texture texture{};
    texture.image = -1;
    texture.scale[0] = texture.scale[1] = 1.0f;
    return texture;
}

void applySampler(const Document& document, int index, const Host& host, candela_texture& texture) {
    if (index < 0) {
        texture.mag_filter = CANDELA_FILTER_LINEAR;
        return;
    }
    const tinygltf::Sampler& sampler = document.model.samplers.at(static_cast<std::size_t>(index));
    const std::string element = elementName("sampler", static_cast<std::size_t>(index), sampler.name);
    texture.wrap_s = wrapOf(sampler.wrapS, "wrapS", element, host);
    texture.wrap_t = wrapOf(sampler.wrapT, "wrapT", element, host);
    texture.min_filter = minFilterOf(sampler.minFilter, element, host);
    texture.mag_filter = magFilterOf(sampler.magFilter, element, host);
}

/// Returns the texture's set of coordinates.
int applyTransform(const tinygltf::ExtensionMap& extensions, int texCoord, candela_texture& texture) {
    const tinygltf::Value* transform = findExtension(extensions, "KHR_texture_transform");
    if (!transform) return texCoord;
    readPair(*transform, "offset", texture.offset);
    readPair(*transform, "scale", texture.scale);
    texture.rotation = numberOr(*transform, "rotation", 0.0f);
    return transform->Has("texCoord") ? transform->Get("texCoord").GetNumberAsInt() : texCoord;
}

class MaterialReader {
  public:
    MaterialReader(const Document& document, const std::vector<std::int32_t>& images, const Host& host,
                   std::string element)
        : document_(document), images_(images), host_(host), element_(std::move(element)) {}

    template <typename TextureInfo>
    candela_texture texture(const TextureInfo& info, const char* use) const {
        candela_texture texture = noTexture();
        if (info.index < 0) return texture;
        const auto index = static_cast<std::size_t>(info.index);
        const tinygltf::Texture& source = document_.model.textures.at(index);
        if (host_.leavesOut([&] { requireImage(source, index); })) return texture;
        const std::int32_t image = images_.at(static_cast<std::size_t>(source.source));
        if (image < 0) return texture;  // It has a note of its own.
        applySampler(document_, source.sampler, host_, texture);
        const int uvSet = applyTransform(info.extensions, info.texCoord, texture);
        if (uvSet > 1) {
            host_.note(
                CANDELA_NOTE_MISSING, element_ + ", " + use,
                "the texture coordinates TEXCOORD_" + std::to_string(uvSet) + " are not supported: left out");
            return noTexture();
        }
        texture.uv_set = static_cast<std::uint32_t>(uvSet);
        texture.image = image;
        return texture;
    }

    void readAlpha(const tinygltf::Material& source, candela_material& material) const {
        material.alpha_cutoff = 0.5f;
        if (source.alphaMode == "OPAQUE") return;
        if (source.alphaMode == "MASK") {
            material.alpha_mode = CANDELA_ALPHA_MASK;
            material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
            return;
        }
        material.alpha_mode = CANDELA_ALPHA_BLEND;
    }

  private:
    void requireImage(const tinygltf::Texture& texture, std::size_t index) const {
        const std::string element = elementName("texture", index, texture.name);
        requireUsable(document_, element);
        if (texture.source >= 0) return;
        const std::string& extension = document_.imageExtensions.at(index);
        throw Failure{element, extension.empty()
                                   ? "no image"
                                   : "no PNG, JPEG, WebP or KTX2 image, but one of " + extension};
    }

    const Document& document_;
    const std::vector<std::int32_t>& images_;
    const Host& host_;
    std::string element_;
};

void readFactors(const tinygltf::Material& source, candela_material& material) {
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    std::transform(pbr.baseColorFactor.begin(), pbr.baseColorFactor.end(), material.base_color,
                   [](double v) { return static_cast<float>(v); });
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
    const tinygltf::Value* strength = findExtension(source.extensions, "KHR_materials_emissive_strength");
    const float factor = strength ? numberOr(*strength, "emissiveStrength", 1.0f) : 1.0f;
    constexpr float maxEmission = 1e20f;  // the host's
    std::transform(source.emissiveFactor.begin(), source.emissiveFactor.end(), material.emission,
                   [&](double v) { return std::min(static_cast<float>(v) * factor, maxEmission); });
    material.double_sided = source.doubleSided ? 1 : 0;
    material.unlit = findExtension(source.extensions, "KHR_materials_unlit") ? 1 : 0;
}

UvSets uvSetsOf(const candela_material& material) {
    UvSets sets{};
    for (const candela_texture* texture :
         {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
          &material.occlusion_texture, &material.emission_texture}) {
        if (texture->image >= 0) sets[texture->uv_set] = true;
    }
    return sets;
}

}  // namespace

namespace {

bool needsDefaultMaterial(const tinygltf::Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const tinygltf::Primitive& primitive) { return primitive.material < 0; });
}

bool needsDefaultMaterial(const Document& document, const std::vector<bool>& usedMeshes) {
    for (std::size_t i = 0; i < usedMeshes.size(); ++i) {
        if (usedMeshes[i] && needsDefaultMaterial(document.model.meshes[i])) return true;
    }
    return false;
}

/// The material of a primitive without one: metallic and rough (glTF 2.0, 3.9.1).
std::int32_t addDefaultMaterial(const Host& host) {
    candela_material material{};
    material.struct_size = sizeof material;
    std::fill_n(material.base_color, 4, 1.0f);
    material.metallic = material.roughness = 1.0f;
    material.normal_scale = material.occlusion_strength = 1.0f;
    material.alpha_cutoff = 0.5f;
    material.base_color_texture = material.metallic_roughness_texture = material.normal_texture =
        material.occlusion_texture = material.emission_texture = noTexture();
    return host.add(material);
}

}  // namespace

AddedMaterials addMaterials(const Document& document, const std::vector<std::int32_t>& images,
                            const std::vector<bool>& usedMeshes, const Host& host) {
    AddedMaterials materials;
    for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
        const tinygltf::Material& source = document.model.materials[i];
        const MaterialReader reader(document, images, host, elementName("material", i, source.name));
        candela_material material{};
        material.struct_size = sizeof material;
        material.name = source.name.c_str();
        readFactors(source, material);
        reader.readAlpha(source, material);
        const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
        material.base_color_texture = reader.texture(pbr.baseColorTexture, "baseColorTexture");
        material.metallic_roughness_texture =
            reader.texture(pbr.metallicRoughnessTexture, "metallicRoughnessTexture");
        material.normal_texture = reader.texture(source.normalTexture, "normalTexture");
        material.occlusion_texture = reader.texture(source.occlusionTexture, "occlusionTexture");
        material.emission_texture = reader.texture(source.emissiveTexture, "emissiveTexture");
        host.add(material);
        materials.uvSets.push_back(uvSetsOf(material));
        materials.added.push_back(material);
    }
    if (needsDefaultMaterial(document, usedMeshes)) materials.defaultMaterial = addDefaultMaterial(host);
    return materials;
}

}  // namespace candela_plugins::gltf
