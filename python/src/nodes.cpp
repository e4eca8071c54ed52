#include "module.h"
#include "scene_data.h"
#include "words.h"

#include <glm/gtc/matrix_transform.hpp>

namespace candela::python {

namespace {

glm::mat4 matrixOf(const Node& node) {
    if (const auto* matrix = std::get_if<glm::mat4>(&node.transform)) return *matrix;
    const auto& transform = std::get<Transform>(node.transform);
    return glm::scale(
        glm::translate(glm::mat4(1.0f), transform.translation) * glm::mat4_cast(transform.rotation),
        transform.scale);
}

// A part of a transform; a node that has a matrix gets a transform in its place.
template <auto Member>
auto setPart() {
    return [](Node& node, nb::handle value, const std::string& where) {
        using V = std::remove_cvref_t<decltype(std::declval<Transform>().*Member)>;
        const V part = Convert<V>::from(value, where);
        if (!std::holds_alternative<Transform>(node.transform)) node.transform = Transform{};
        std::get<Transform>(node.transform).*Member = part;
    };
}

template <auto Member>
nb::object getPart(const Node& node) {
    const auto* transform = std::get_if<Transform>(&node.transform);
    if (!transform) return nb::none();
    return Convert<std::remove_cvref_t<decltype(transform->*Member)>>::to(transform->*Member);
}

const std::string optionalArray = std::string(floatArray) + " | None";

}  // namespace

template <>
const Record<Node>& recordOf<Node>() {
    static const Record<Node> record =
        Record<Node>("Node")
            .field("name", &Node::name, "The node's name.")
            .field("parent", &Node::parent, "Index into `Scene.nodes`, less than this node's own.")
            .custom(
                "matrix", floatArray, "The local transform, (4, 4): points are columns.",
                [](Node& node, nb::handle value, const std::string& where) {
                    node.transform = Convert<glm::mat4>::from(value, where);
                },
                [](const Node& node) { return Convert<glm::mat4>::to(matrixOf(node)); })
            .custom(
                "translation", optionalArray,
                "Metres, (3,); None of a node with a matrix, which becomes a transform when one is assigned.",
                setPart<&Transform::translation>(), getPart<&Transform::translation>)
            .custom("rotation", optionalArray,
                    "Unit quaternion x, y, z, w, (4,); None of a node with a matrix.",
                    setPart<&Transform::rotation>(), getPart<&Transform::rotation>)
            .custom("scale", optionalArray, "(3,); None of a node with a matrix.",
                    setPart<&Transform::scale>(), getPart<&Transform::scale>)
            .field("mesh", &Node::mesh, "Index into `Scene.meshes`.")
            .field("cage", &Node::cage, "Index into `Scene.cages`.")
            .field("skin", &Node::skin, "Index into `Scene.skins`.")
            .field("morph_weights", &Node::morphWeights, "One for each morph target; empty: all 0.")
            .field("translation_remainder", &Node::translationRemainder,
                   "Metres, added to the translation in double precision, (3,).")
            .field("casts_shadow", &Node::castsShadow, "Whether the node's own mesh and cage cast shadows.")
            .field("visible", &Node::visible, "False: neither this node nor what is below it is drawn.");
    return record;
}

template <>
const Record<Camera>& recordOf<Camera>() {
    static const Record<Camera> record =
        Record<Camera>("Camera")
            .field("name", &Camera::name, "The camera's name.")
            .field("vertical_fov", &Camera::verticalFov, "Radians, over 0 and under pi.")
            .field("orthographic_height", &Camera::orthographicHeight, "Metres: an orthographic camera.")
            .field("near_plane", &Camera::nearPlane, "Metres; None: by the size of the scene.")
            .field("far_plane", &Camera::farPlane, "Metres; None: at infinity.")
            .field("node", &Camera::node,
                   "Index into `Scene.nodes`; None: the world's frame. It looks along -Z.")
            .field("number", &Camera::number, "The camera's number in its file.");
    return record;
}

template <>
const Record<Light>& recordOf<Light>() {
    static const Record<Light> record =
        Record<Light>("Light")
            .field("name", &Light::name, "The light's name.")
            .field("type", &Light::type, "The kind of light.")
            .field("color", &Light::color, "Linear Rec.709, 0 or more, (3,).")
            .field("intensity", &Light::intensity, "Candela; of a directional light lux.")
            .field("range", &Light::range, "Metres, over 0; None: as far as it matters.")
            .field("inner_cone_angle", &Light::innerConeAngle, "Spot: radians, 0 or more.")
            .field("outer_cone_angle", &Light::outerConeAngle, "Spot: radians, at most pi / 2.")
            .field("position", &Light::position, "In the node's frame, metres, (3,).")
            .field("direction", &Light::direction,
                   "In the node's frame, unit length, (3,): where the light goes.")
            .field("node", &Light::node, "Index into `Scene.nodes`; None: the world's frame.")
            .field("casts_shadow", &Light::castsShadow,
                   "Whether surfaces keep its light from what is behind them.")
            .field("radius", &Light::radius,
                   "Metres, 0 or more: of the sphere that emits, which softens shadows.");
    return record;
}

void bindNodes(nb::module_& module) {
    bindElement<Node>(module, "A node of the hierarchy. Parents precede their children in the scene.");
    bindElement<Camera>(module, "A camera of a scene. It looks along -Z of its node's frame with +Y up.");
    bindElement<Light>(module, "A light of a scene. `Scene.add_lights` adds many from arrays.");
}

}  // namespace candela::python
