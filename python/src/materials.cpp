#include "module.h"
#include "scene_data.h"
#include "words.h"

namespace candela::python {

template <>
struct Convert<Texture> : ConvertClass<Texture> {};

template <>
const Record<Texture>& recordOf<Texture>() {
    static const Record<Texture> record =
        Record<Texture>("Texture")
            .field("image", &Texture::image, "Index into `Scene.images`.")
            .field("uv_set", &Texture::uvSet, "The set of texture coordinates of the mesh: 0 is `Mesh.uv0`.")
            .field("wrap_s", &Texture::wrapS, "Beyond 0 to 1 along the first coordinate.")
            .field("wrap_t", &Texture::wrapT, "Beyond 0 to 1 along the second coordinate.")
            .field("min_filter", &Texture::minFilter, "Where texels are smaller than pixels.")
            .field("mag_filter", &Texture::magFilter,
                   "Where texels are larger than pixels: 'nearest' or 'linear'.")
            .field("offset", &Texture::offset, "Added to the coordinate, (2,).")
            .field("rotation", &Texture::rotation, "Radians, counter-clockwise.")
            .field("scale", &Texture::scale, "Multiplies the coordinate, (2,).");
    return record;
}

namespace {

Record<Material>& describeSurface(Record<Material>& record) {
    return record.field("name", &Material::name, "The material's name.")
        .custom(
            "base_color", floatArray, "Linear Rec.709 and alpha, 0 to 1, (4,); (3,) has an alpha of 1.",
            [](Material& material, nb::handle value, const std::string& where) {
                const bool isOpaque = PySequence_Check(value.ptr()) && PySequence_Size(value.ptr()) == 3;
                material.baseColor = isOpaque ? glm::vec4(Convert<glm::vec3>::from(value, where), 1.0f)
                                              : Convert<glm::vec4>::from(value, where);
            },
            [](const Material& material) { return Convert<glm::vec4>::to(material.baseColor); })
        .field("metallic", &Material::metallic, "0 to 1.")
        .field("roughness", &Material::roughness, "Perceptual roughness, 0 to 1.")
        .field("emission", &Material::emission, "Radiance, linear Rec.709, 0 or more, (3,).")
        .field("emission_strength", &Material::emissionStrength, "Multiplies `emission`; 0 or more.")
        .field("base_color_texture", &Material::baseColorTexture,
               "Multiplies `base_color`: RGB sRGB-encoded (linear of 'rgba32f'), A linear.")
        .field("metallic_roughness_texture", &Material::metallicRoughnessTexture,
               "G roughness, B metallic, linear.")
        .field("normal_texture", &Material::normalTexture, "Tangent space, linear.")
        .field("occlusion_texture", &Material::occlusionTexture, "R, linear: dims the environment's light.")
        .field("emission_texture", &Material::emissionTexture, "RGB sRGB-encoded (linear of 'rgba32f').")
        .field("normal_scale", &Material::normalScale, "Multiplies x and y of the normal texture.")
        .field("occlusion_strength", &Material::occlusionStrength, "0 to 1.")
        .field("alpha_mode", &Material::alphaMode,
               "'mask' draws what has an alpha of `alpha_cutoff` or more; 'blend' covers the share alpha.")
        .field("alpha_cutoff", &Material::alphaCutoff, "Of 'mask'; 0 or more.")
        .field("double_sided", &Material::doubleSided, "Whether triangles are seen from behind.")
        .field("unlit", &Material::unlit, "Radiance is the base colour, and no light falls on it.")
        .field("ior", &Material::ior, "Index of refraction, 1 or more.");
}

// The lobes of the glTF extensions; attributes have the names of the extensions' members.
Record<Material>& describeLobes(Record<Material>& record) {
    using M = Material;
    return record
        .field(
            "specular", [](M& m) -> float& { return m.specular.factor; },
            "Strength of the reflection, 0 to 1.")
        .field(
            "specular_color", [](M & m) -> auto& { return m.specular.color; },
            "Factor on the reflectance at normal incidence, 0 or more, (3,).")
        .field(
            "specular_texture", [](M & m) -> auto& { return m.specular.texture; }, "A: the strength.")
        .field(
            "specular_color_texture", [](M & m) -> auto& { return m.specular.colorTexture; }, "RGB.")
        .field(
            "clearcoat", [](M& m) -> float& { return m.clearcoat.factor; }, "A smooth layer on top, 0 to 1.")
        .field(
            "clearcoat_roughness", [](M& m) -> float& { return m.clearcoat.roughness; }, "0 to 1.")
        .field(
            "clearcoat_normal_scale", [](M& m) -> float& { return m.clearcoat.normalScale; },
            "Multiplies x and y of its normal texture.")
        .field(
            "clearcoat_texture", [](M & m) -> auto& { return m.clearcoat.texture; }, "R: the factor.")
        .field(
            "clearcoat_roughness_texture", [](M & m) -> auto& { return m.clearcoat.roughnessTexture; }, "G.")
        .field(
            "clearcoat_normal_texture", [](M & m) -> auto& { return m.clearcoat.normalTexture; },
            "Tangent space; None: the normal of the mesh.")
        .field(
            "sheen_color", [](M & m) -> auto& { return m.sheen.color; },
            "The fibres of cloth; 0: none, (3,).")
        .field(
            "sheen_roughness", [](M& m) -> float& { return m.sheen.roughness; }, "0 to 1.")
        .field(
            "sheen_color_texture", [](M & m) -> auto& { return m.sheen.colorTexture; }, "RGB.")
        .field(
            "sheen_roughness_texture", [](M & m) -> auto& { return m.sheen.roughnessTexture; }, "A.")
        .field(
            "anisotropy", [](M& m) -> float& { return m.anisotropy.strength; }, "0 to 1.")
        .field(
            "anisotropy_rotation", [](M& m) -> float& { return m.anisotropy.rotation; },
            "Of the wide direction, radians, counter-clockwise from the tangent.")
        .field(
            "anisotropy_texture", [](M & m) -> auto& { return m.anisotropy.texture; },
            "RG: direction, -1 to 1; B: the strength.")
        .field(
            "iridescence", [](M& m) -> float& { return m.iridescence.factor; }, "A thin film, 0 to 1.")
        .field(
            "iridescence_ior", [](M& m) -> float& { return m.iridescence.ior; }, "Of the film, 1 or more.")
        .field(
            "iridescence_min_thickness", [](M& m) -> float& { return m.iridescence.minThickness; },
            "Nanometres, where the texture is 0.")
        .field(
            "iridescence_max_thickness", [](M& m) -> float& { return m.iridescence.maxThickness; },
            "Nanometres, where it is 1 or there is none.")
        .field(
            "iridescence_texture", [](M & m) -> auto& { return m.iridescence.texture; }, "R: the factor.")
        .field(
            "iridescence_thickness_texture", [](M & m) -> auto& { return m.iridescence.thicknessTexture; },
            "G.");
}

Record<Material>& describeTransmission(Record<Material>& record) {
    using M = Material;
    return record
        .field(
            "transmission", [](M& m) -> float& { return m.transmission.factor; },
            "Of the light that is not reflected, the share that passes, 0 to 1.")
        .field(
            "transmission_texture", [](M & m) -> auto& { return m.transmission.texture; }, "R.")
        .field(
            "thickness", [](M& m) -> float& { return m.volume.thickness; },
            "Metres, 0 or more; 0: a thin wall.")
        .field(
            "attenuation_distance", [](M& m) -> float& { return m.volume.attenuationDistance; },
            "Metres, over 0.")
        .field(
            "attenuation_color", [](M & m) -> auto& { return m.volume.attenuationColor; },
            "What is left of white light after that distance, (3,).")
        .field(
            "dispersion", [](M& m) -> float& { return m.volume.dispersion; }, "20 / Abbe number, 0 or more.")
        .field(
            "thickness_texture", [](M & m) -> auto& { return m.volume.thicknessTexture; }, "G.")
        .field(
            "diffuse_transmission", [](M& m) -> float& { return m.diffuseTransmission.factor; },
            "The share of the diffuse reflection that passes instead, 0 to 1.")
        .field(
            "diffuse_transmission_color", [](M & m) -> auto& { return m.diffuseTransmission.color; }, "(3,).")
        .field(
            "diffuse_transmission_texture", [](M & m) -> auto& { return m.diffuseTransmission.texture; },
            "A: the factor.")
        .field(
            "diffuse_transmission_color_texture",
            [](M & m) -> auto& { return m.diffuseTransmission.colorTexture; }, "RGB.");
}

}  // namespace

template <>
const Record<Material>& recordOf<Material>() {
    static const Record<Material> record = [] {
        Record<Material> all("Material");
        describeTransmission(describeLobes(describeSurface(all)));
        return all;
    }();
    return record;
}

void bindMaterials(nb::module_& module) {
    bindValue<Texture>(
        module,
        "A use of an image by a material. It does not change: `replace` gives a changed copy. The "
        "coordinate is offset + rotate(rotation) (scale * uv).");
    bindElement<Material>(
        module,
        "A metallic-roughness material as in glTF 2.0, with the lobes of its extensions. Each "
        "texture multiplies its factor. Colours are linear Rec.709.");
}

}  // namespace candela::python
