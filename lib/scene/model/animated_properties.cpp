#include "scene/model/animated_properties.h"

#include "base/error_context.h"
#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace candela {

namespace {

float* numbersOf(float& number) {
    return &number;
}

float* numbersOf(std::optional<float>& number) {
    return number ? &*number : nullptr;
}

template <typename Vector>
float* numbersOf(Vector& vector) {
    return &vector[0];
}

template <auto member, typename Element>
float* of(Element& element) {
    return numbersOf(element.*member);
}

/// Of a lobe or medium of a material.
template <auto lobe, auto member>
float* ofLobe(Material& material) {
    return numbersOf(material.*lobe.*member);
}

template <auto member>
float* ofCone(Light& light) {
    return light.type == LightType::spot ? &(light.*member) : nullptr;
}

float* fovOf(Camera& camera) {
    return camera.orthographicHeight ? nullptr : &camera.verticalFov;
}

bool* visibilityOf(Node& node) {
    return &node.visible;
}

constexpr float most = maxAnimated, halfPi = std::numbers::pi_v<float> / 2.0f;
/// Of what has to be over 0.
constexpr float least = 1e-6f;

using P = AnimatedProperty;
using M = MaterialNumbers;
using T = TextureNumbers;
using L = LightNumbers;
using C = CameraNumbers;

/// In the order of `AnimatedProperty`.
constexpr std::array rows{
    AnimatedPropertyRow{P::visibility, "visibility", 1, -most, most, NodeFlag(visibilityOf)},
    AnimatedPropertyRow{P::baseColor, "base colour", 4, 0, 1, M(of<&Material::baseColor>)},
    AnimatedPropertyRow{P::metallic, "metallic factor", 1, 0, 1, M(of<&Material::metallic>)},
    AnimatedPropertyRow{P::roughness, "roughness", 1, 0, 1, M(of<&Material::roughness>)},
    AnimatedPropertyRow{P::emission, "emission", 3, 0, maxIntensity, M(of<&Material::emission>)},
    AnimatedPropertyRow{P::emissionStrength, "emission strength", 1, 0, maxIntensity,
                        M(of<&Material::emissionStrength>)},
    AnimatedPropertyRow{P::normalScale, "normal scale", 1, -most, most, M(of<&Material::normalScale>)},
    AnimatedPropertyRow{P::occlusionStrength, "occlusion strength", 1, 0, 1,
                        M(of<&Material::occlusionStrength>)},
    AnimatedPropertyRow{P::alphaCutoff, "alpha cutoff", 1, 0, most, M(of<&Material::alphaCutoff>)},
    AnimatedPropertyRow{P::ior, "index of refraction", 1, 1, most, M(of<&Material::ior>)},
    AnimatedPropertyRow{P::specularFactor, "specular factor", 1, 0, 1,
                        M(ofLobe<&Material::specular, &Specular::factor>)},
    AnimatedPropertyRow{P::specularColor, "specular colour", 3, 0, most,
                        M(ofLobe<&Material::specular, &Specular::color>)},
    AnimatedPropertyRow{P::clearcoatFactor, "clearcoat factor", 1, 0, 1,
                        M(ofLobe<&Material::clearcoat, &Clearcoat::factor>)},
    AnimatedPropertyRow{P::clearcoatRoughness, "clearcoat roughness", 1, 0, 1,
                        M(ofLobe<&Material::clearcoat, &Clearcoat::roughness>)},
    AnimatedPropertyRow{P::clearcoatNormalScale, "clearcoat normal scale", 1, -most, most,
                        M(ofLobe<&Material::clearcoat, &Clearcoat::normalScale>)},
    AnimatedPropertyRow{P::sheenColor, "sheen colour", 3, 0, 1, M(ofLobe<&Material::sheen, &Sheen::color>)},
    AnimatedPropertyRow{P::sheenRoughness, "sheen roughness", 1, 0, 1,
                        M(ofLobe<&Material::sheen, &Sheen::roughness>)},
    AnimatedPropertyRow{P::anisotropyStrength, "anisotropy strength", 1, 0, 1,
                        M(ofLobe<&Material::anisotropy, &Anisotropy::strength>)},
    AnimatedPropertyRow{P::anisotropyRotation, "anisotropy rotation", 1, -most, most,
                        M(ofLobe<&Material::anisotropy, &Anisotropy::rotation>)},
    AnimatedPropertyRow{P::iridescenceFactor, "iridescence factor", 1, 0, 1,
                        M(ofLobe<&Material::iridescence, &Iridescence::factor>)},
    AnimatedPropertyRow{P::iridescenceIor, "iridescence index of refraction", 1, 1, most,
                        M(ofLobe<&Material::iridescence, &Iridescence::ior>)},
    AnimatedPropertyRow{P::iridescenceMinThickness, "least iridescence thickness", 1, 0, most,
                        M(ofLobe<&Material::iridescence, &Iridescence::minThickness>)},
    AnimatedPropertyRow{P::iridescenceMaxThickness, "largest iridescence thickness", 1, 0, most,
                        M(ofLobe<&Material::iridescence, &Iridescence::maxThickness>)},
    AnimatedPropertyRow{P::transmissionFactor, "transmission factor", 1, 0, 1,
                        M(ofLobe<&Material::transmission, &Transmission::factor>)},
    AnimatedPropertyRow{P::thickness, "thickness", 1, 0, most,
                        M(ofLobe<&Material::volume, &Volume::thickness>)},
    AnimatedPropertyRow{P::attenuationDistance, "attenuation distance", 1, least, most,
                        M(ofLobe<&Material::volume, &Volume::attenuationDistance>)},
    AnimatedPropertyRow{P::attenuationColor, "attenuation colour", 3, 0, 1,
                        M(ofLobe<&Material::volume, &Volume::attenuationColor>)},
    AnimatedPropertyRow{P::dispersion, "dispersion", 1, 0, most,
                        M(ofLobe<&Material::volume, &Volume::dispersion>)},
    AnimatedPropertyRow{P::diffuseTransmissionFactor, "diffuse transmission factor", 1, 0, 1,
                        M(ofLobe<&Material::diffuseTransmission, &DiffuseTransmission::factor>)},
    AnimatedPropertyRow{P::diffuseTransmissionColor, "diffuse transmission colour", 3, 0, 1,
                        M(ofLobe<&Material::diffuseTransmission, &DiffuseTransmission::color>)},
    AnimatedPropertyRow{P::textureOffset, "texture offset", 2, -most, most, T(of<&Texture::offset>)},
    AnimatedPropertyRow{P::textureRotation, "texture rotation", 1, -most, most, T(of<&Texture::rotation>)},
    AnimatedPropertyRow{P::textureScale, "texture scale", 2, -most, most, T(of<&Texture::scale>)},
    AnimatedPropertyRow{P::lightColor, "colour", 3, 0, most, L(of<&Light::color>)},
    AnimatedPropertyRow{P::lightIntensity, "intensity", 1, 0, maxIntensity, L(of<&Light::intensity>)},
    AnimatedPropertyRow{P::lightRange, "range", 1, least, most, L(of<&Light::range>)},
    AnimatedPropertyRow{P::innerConeAngle, "inner cone angle", 1, 0, halfPi,
                        L(ofCone<&Light::innerConeAngle>)},
    AnimatedPropertyRow{P::outerConeAngle, "outer cone angle", 1, least, halfPi,
                        L(ofCone<&Light::outerConeAngle>)},
    AnimatedPropertyRow{P::lightPosition, "position", 3, -most, most, L(of<&Light::position>)},
    AnimatedPropertyRow{P::verticalFov, "vertical field of view", 1, least, std::numbers::pi_v<float> - least,
                        C(fovOf)},
    AnimatedPropertyRow{P::orthographicHeight, "orthographic height", 1, least, most,
                        C(of<&Camera::orthographicHeight>)},
    AnimatedPropertyRow{P::nearPlane, "near plane", 1, 0, most, C(of<&Camera::nearPlane>)},
    AnimatedPropertyRow{P::farPlane, "far plane", 1, least, most, C(of<&Camera::farPlane>)},
};

constexpr bool areInOrder() {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<std::size_t>(rows[i].property) != i) return false;
    return rows.back().property == P::farPlane;
}
static_assert(areInOrder());

}  // namespace

const AnimatedPropertyRow* findRow(AnimatedProperty property) {
    const auto index = static_cast<std::size_t>(property);
    return index < rows.size() ? &rows[index] : nullptr;
}

const AnimatedPropertyRow& rowOf(AnimatedProperty property) {
    return rows[static_cast<std::size_t>(property)];
}

AnimatedElement elementOf(AnimatedProperty property) {
    const AnimatedPropertyRow* row = findRow(property);
    if (!row)
        throw Error(ErrorKind::badInput, "",
                    "there is no animated property " + std::to_string(static_cast<int>(property)));
    if (std::holds_alternative<NodeFlag>(row->place)) return AnimatedElement::node;
    if (std::holds_alternative<LightNumbers>(row->place)) return AnimatedElement::light;
    return std::holds_alternative<CameraNumbers>(row->place) ? AnimatedElement::camera
                                                             : AnimatedElement::material;
}

}  // namespace candela
