#include "import/pushed_elements.h"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>

namespace candela {
namespace {

// What 8-bit quantised quaternions need: sqrt(4) × 0.5 / 127, and a little.
constexpr double unitTolerance = 0.01;
// Matrices that went through text or single-precision products end a little beside (0, 0, 0, 1).
constexpr float affineTolerance = 1e-5f;

glm::vec3 finiteVector(const PushedElement& element, const char* member, const float (&from)[3]) {
    glm::vec3 vector;
    for (int i = 0; i < 3; ++i) vector[i] = element.finite(member, from[i]);
    return vector;
}

glm::quat unitQuaternion(const PushedElement& element, const float (&xyzw)[4]) {
    double square = 0.0;
    for (const float number : xyzw) square += double{element.finite("rotation", number)} * number;
    const double length = std::sqrt(square);
    if (std::abs(length - 1.0) > unitTolerance)
        element.refuse(joined("rotation has the length ", length, ", but a unit quaternion was expected"));
    const auto part = [&](int i) { return static_cast<float>(xyzw[i] / length); };
    return {part(3), part(0), part(1), part(2)};
}

Trs trsFrom(const candela_node& pushed, const PushedElement& element) {
    Trs trs;
    trs.translation = finiteVector(element, "translation", pushed.translation);
    trs.rotation = unitQuaternion(element, pushed.rotation);
    trs.scale = finiteVector(element, "scale", pushed.scale);
    return trs;
}

glm::mat4 matrixFrom(const candela_node& pushed, const PushedElement& element) {
    std::vector<glm::mat4> copies;
    element.numbers("matrix", pushed.matrix, 1, copies);
    glm::mat4 matrix = copies.front();
    for (int column = 0; column < 4; ++column) {
        const float expected = column == 3 ? 1.0f : 0.0f;
        float& last = matrix[column][3];
        if (std::abs(last - expected) > affineTolerance)
            element.refuse(joined("matrix is not affine: the last number of column ", column, " is ", last,
                                  ", but ", expected, " was expected"));
        last = expected;
    }
    return matrix;
}

}  // namespace

Node nodeFrom(const candela_node& pushed, const PushedElement& element, const Scene& scene) {
    Node node;
    node.name = element.name();
    node.parent = element.reference("parent", pushed.parent, scene.nodes.size());
    node.mesh = element.reference("mesh", pushed.mesh, scene.meshes.size());
    if (pushed.matrix)
        node.transform = matrixFrom(pushed, element);
    else
        node.transform = trsFrom(pushed, element);
    return node;
}

Camera cameraFrom(const candela_camera& pushed, const PushedElement& element, const Scene& scene) {
    Camera camera;
    camera.name = element.name();
    camera.verticalFov = element.finite("vertical_fov", pushed.vertical_fov);
    if (camera.verticalFov <= 0.0f || camera.verticalFov >= glm::pi<float>())
        element.refuse(joined("vertical_fov is ", camera.verticalFov,
                              ", but more than 0 and less than pi was expected"));
    if (const float nearPlane = element.zeroOrMore("near_plane", pushed.near_plane); nearPlane > 0.0f)
        camera.nearPlane = nearPlane;
    camera.node = element.reference("node", pushed.node, scene.nodes.size());
    return camera;
}

namespace {

void takeCone(const candela_light& pushed, const PushedElement& element, Light& light) {
    light.outerConeAngle =
        element.within("outer_cone_angle", pushed.outer_cone_angle, 0.0f, glm::half_pi<float>());
    light.innerConeAngle = element.zeroOrMore("inner_cone_angle", pushed.inner_cone_angle);
    if (light.innerConeAngle >= light.outerConeAngle)
        element.refuse(joined("inner_cone_angle is ", light.innerConeAngle,
                              ", but less than outer_cone_angle (", light.outerConeAngle, ") was expected"));
}

glm::vec3 unitDirection(const candela_light& pushed, const PushedElement& element) {
    const glm::dvec3 direction(finiteVector(element, "direction", pushed.direction));
    const double length = std::hypot(direction.x, direction.y, direction.z);
    if (!(length > 0.0)) element.refuse("direction has the length 0");
    return glm::vec3(direction / length);
}

}  // namespace

Light lightFrom(const candela_light& pushed, const PushedElement& element, const Scene& scene) {
    constexpr std::array types{LightType::point, LightType::spot, LightType::directional};
    Light light;
    light.name = element.name();
    light.type = types[element.enumerator("type", pushed.type, types.size())];
    for (int i = 0; i < 3; ++i) light.color[i] = element.zeroOrMore("color", pushed.color[i]);
    light.intensity = element.zeroOrMore("intensity", pushed.intensity);
    if (const float range = element.zeroOrMore("range", pushed.range); range > 0.0f) light.range = range;
    if (light.type == LightType::spot) takeCone(pushed, element, light);
    if (light.type != LightType::directional)
        light.position = finiteVector(element, "position", pushed.position);
    if (light.type != LightType::point) light.direction = unitDirection(pushed, element);
    light.node = element.reference("node", pushed.node, scene.nodes.size());
    return light;
}

}  // namespace candela
