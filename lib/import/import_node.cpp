#include "import/abi_import.h"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>

namespace candela {

namespace {

Transform transformFrom(const candela_node& source, const AbiReader& element) {
    Transform transform;
    transform.translation = element.finiteVector("translation", source.translation);
    transform.rotation = element.unitQuaternion("rotation", source.rotation);
    transform.scale = element.finiteVector("scale", source.scale);
    return transform;
}

glm::mat4 matrixFrom(const candela_node& source, const AbiReader& element) {
    std::vector<glm::mat4> copies;
    element.numbers("matrix", source.matrix, 1, copies);
    return element.affine("matrix", copies.front());
}

}  // namespace

Node nodeFrom(const candela_node& source, const AbiReader& element, const Scene& scene) {
    Node node;
    node.name = element.name();
    node.parent = element.reference("parent", source.parent, scene.nodes.size());
    node.mesh = element.reference("mesh", source.mesh, scene.meshes.size());
    for (int axis = 0; axis < 3; ++axis) {
        const double remainder = source.translation_remainder[axis];
        if (!std::isfinite(remainder))
            element.refuse(
                joined("translation_remainder is ", remainder, ", but a finite number was expected"));
        node.translationRemainder[axis] = remainder;
    }
    node.castsShadow = !element.flag("casts_no_shadow", source.casts_no_shadow);
    node.visible = !element.flag("is_hidden", source.is_hidden);
    if (source.matrix)
        node.transform = matrixFrom(source, element);
    else
        node.transform = transformFrom(source, element);
    return node;
}

namespace {

void takeLens(const candela_camera& source, const AbiReader& element, Camera& camera) {
    const float height = element.zeroOrMore("orthographic_height", source.orthographic_height);
    if (height > 0.0f) {
        camera.orthographicHeight = height;
        return;
    }
    camera.verticalFov = element.finite("vertical_fov", source.vertical_fov);
    if (camera.verticalFov <= 0.0f || camera.verticalFov >= glm::pi<float>())
        element.refuse(joined("vertical_fov is ", camera.verticalFov,
                              ", but more than 0 and less than pi was expected"));
}

}  // namespace

Camera cameraFrom(const candela_camera& source, const AbiReader& element, const Scene& scene) {
    Camera camera;
    camera.name = element.name();
    takeLens(source, element, camera);
    const float nearPlane = element.zeroOrMore("near_plane", source.near_plane);
    if (nearPlane > 0.0f) camera.nearPlane = nearPlane;
    const float farPlane = element.zeroOrMore("far_plane", source.far_plane);
    if (farPlane > 0.0f && farPlane <= nearPlane)
        element.refuse(
            joined("far_plane is ", farPlane, ", but more than near_plane, ", nearPlane, ", was expected"));
    if (farPlane > 0.0f) camera.farPlane = farPlane;
    camera.node = element.reference("node", source.node, scene.nodes.size());
    if (source.number > 0) camera.number = source.number - 1;
    return camera;
}

namespace {

void takeCone(const candela_light& source, const AbiReader& element, Light& light) {
    light.outerConeAngle =
        element.within("outer_cone_angle", source.outer_cone_angle, 0.0f, glm::half_pi<float>());
    light.innerConeAngle = element.zeroOrMore("inner_cone_angle", source.inner_cone_angle);
    if (light.innerConeAngle >= light.outerConeAngle)
        element.refuse(joined("inner_cone_angle is ", light.innerConeAngle,
                              ", but less than outer_cone_angle (", light.outerConeAngle, ") was expected"));
}

glm::vec3 unitDirection(const candela_light& source, const AbiReader& element) {
    const glm::dvec3 direction(element.finiteVector("direction", source.direction));
    const double length = std::hypot(direction.x, direction.y, direction.z);
    if (!(length > 0.0)) element.refuse("direction has the length 0");
    return glm::vec3(direction / length);
}

}  // namespace

Light lightFrom(const candela_light& source, const AbiReader& element, const Scene& scene) {
    constexpr std::array types{LightType::point, LightType::spot, LightType::directional};
    Light light;
    light.name = element.name();
    light.type = types[element.enumerator("type", source.type, types.size())];
    for (int i = 0; i < 3; ++i) light.color[i] = element.zeroOrMore("color", source.color[i]);
    light.intensity = element.zeroOrMore("intensity", source.intensity);
    if (const float range = element.zeroOrMore("range", source.range); range > 0.0f) light.range = range;
    if (light.type == LightType::spot) takeCone(source, element, light);
    if (light.type != LightType::directional)
        light.position = element.finiteVector("position", source.position);
    if (light.type != LightType::point) light.direction = unitDirection(source, element);
    light.node = element.reference("node", source.node, scene.nodes.size());
    light.castsShadow = !element.flag("casts_no_shadow", source.casts_no_shadow);
    light.radius = element.zeroOrMore("radius", source.radius);
    return light;
}

}  // namespace candela
