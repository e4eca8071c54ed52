#include "import/abi_import.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace candela {
namespace {

// What 8-bit quantised quaternions need: sqrt(4) × 0.5 / 127, and a little.
constexpr double unitTolerance = 0.01;

glm::quat unitQuaternion(const AbiReader& element, const float (&xyzw)[4]) {
    double square = 0.0;
    for (const float number : xyzw) square += double{element.finite("rotation", number)} * number;
    const double length = std::sqrt(square);
    if (std::abs(length - 1.0) > unitTolerance)
        element.refuse(joined("rotation has the length ", length, ", but a unit quaternion was expected"));
    const auto part = [&](int i) { return static_cast<float>(xyzw[i] / length); };
    return {part(3), part(0), part(1), part(2)};
}

Transform trsFrom(const candela_node& pushed, const AbiReader& element) {
    Transform trs;
    trs.translation = element.finiteVector("translation", pushed.translation);
    trs.rotation = unitQuaternion(element, pushed.rotation);
    trs.scale = element.finiteVector("scale", pushed.scale);
    return trs;
}

glm::mat4 matrixFrom(const candela_node& pushed, const AbiReader& element) {
    std::vector<glm::mat4> copies;
    element.numbers("matrix", pushed.matrix, 1, copies);
    return element.affine("matrix", copies.front());
}

}  // namespace

Node nodeFrom(const candela_node& pushed, const AbiReader& element, const Scene& scene) {
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

Camera cameraFrom(const candela_camera& pushed, const AbiReader& element, const Scene& scene) {
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

}  // namespace candela
