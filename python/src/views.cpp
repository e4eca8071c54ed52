#include "module.h"
#include "scene_types.h"

#include <candela/sampling.h>

#include <nanobind/stl/optional.h>

#include <glm/geometric.hpp>

#include <charconv>
#include <cmath>

namespace candela::python {

template <>
const Record<CameraView>& recordOf<CameraView>() {
    static const Record<CameraView> record =
        Record<CameraView>("CameraView")
            .field("world_from_camera", &CameraView::worldFromCamera,
                   "A rigid transform, (4, 4): the camera looks along -Z with +Y up.")
            .field("vertical_fov", &CameraView::verticalFov, "Radians, over 0 and under pi.")
            .field("near_plane", &CameraView::nearPlane, "Metres, over 0.")
            .field("far_plane", &CameraView::farPlane, "Metres; None: at infinity.")
            .field("orthographic_height", &CameraView::orthographicHeight, "Metres: an orthographic view.")
            .field("shift", &CameraView::shift,
                   "How far right of and above the view axis the middle of the picture lies, in units of its "
                   "width and height, (2,).")
            .field(
                "aspect", &CameraView::aspect,
                "Width over height of what the picture shows on a plane across the axis; None: that of its "
                "pixels, which are squares then.");
    return record;
}

namespace {

constexpr float defaultFov = 0.785398f;
// The near plane of `look_at` as a share of the distance.
constexpr float nearShareOfDistance = 0.01f;

CameraView lookAtView(nb::handle eye, nb::handle target, float verticalFov, std::optional<float> nearPlane) {
    const glm::vec3 from = Convert<glm::vec3>::from(eye, "eye"),
                    to = Convert<glm::vec3>::from(target, "target");
    CameraView view = lookAt(from, to, verticalFov);
    view.nearPlane =
        nearPlane.value_or(std::min(view.nearPlane, nearShareOfDistance * glm::distance(from, to)));
    return view;
}

// By the name of its node, its own name or its number in the file.
std::optional<std::uint32_t> findCamera(const Scene& scene, const std::string& text) {
    const auto find = [&](const auto& matches) -> std::optional<std::uint32_t> {
        for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
            if (matches(scene.cameras[i])) return i;
        return std::nullopt;
    };
    if (auto found = find([&](const Camera& c) { return c.node && scene.nodes.at(*c.node).name == text; }))
        return found;
    return find([&](const Camera& c) { return c.name == text; });
}

std::string cameraNames(const Scene& scene) {
    std::string text;
    for (const Camera& camera : scene.cameras) {
        const std::string& node = camera.node ? scene.nodes.at(*camera.node).name : camera.name;
        text += (text.empty() ? "'" : ", '") + (camera.name.empty() ? node : camera.name) + "'";
    }
    return text.empty() ? "the scene has none" : "there are " + text;
}

}  // namespace

Bounds framedBox(const Scene& scene) {
    Bounds box = framingBounds(scene);
    if (!box.empty()) return box;
    for (const WorldLight& light : worldLights(scene, worldTransforms(scene))) {
        if (light.type == LightType::directional) continue;
        box.add({light.position, light.position});
    }
    return box;
}

std::optional<std::uint32_t> cameraFrom(const Scene& scene, nb::handle camera) {
    if (camera.is_none()) return scene.cameras.empty() ? std::nullopt : std::optional<std::uint32_t>(0);
    if (nb::isinstance<nb::str>(camera)) {
        const std::string name = nb::str(camera).c_str();
        if (const auto found = findCamera(scene, name)) return found;
        throw Error(ErrorKind::badInput, "", "no camera '" + name + "'; " + cameraNames(scene));
    }
    if (!PyIndex_Check(camera.ptr()))
        failConversion("camera", "a CameraView, a name, a number or None", camera);
    return static_cast<std::uint32_t>(integerFrom(camera, 0, UINT32_MAX, "camera"));
}

CameraView viewOf(const Scene& scene, std::optional<std::uint32_t> camera, double time, float aspect,
                  const std::function<Bounds()>& framed) {
    if (camera) return cameraView(scene, *camera, worldTransforms(scene, time), time);
    const Bounds box = framed();
    CameraView view = frameBounds(box, aspect, defaultFov);
    view.nearPlane = defaultNearPlane(box);
    return view;
}

void bindCameraViews(nb::module_& module) {
    bindValue<CameraView>(
        module,
        "A camera in world space, which a picture is rendered from. It does not change: `replace` "
        "gives a changed copy.")
        .def_prop_ro(
            "eye", [](const CameraView& view) { return Convert<glm::vec3>::to(view.eye()); },
            nb::sig("def eye(self) -> numpy.typing.NDArray[numpy.float32]"), "Where it stands, metres, (3,).")
        .def(
            "projection",
            [](const CameraView& view, float aspect) {
                return Convert<glm::mat4>::to(projection(view, aspect));
            },
            nb::arg("aspect"),
            nb::sig("def projection(self, aspect: float) -> numpy.typing.NDArray[numpy.float32]"),
            "Clip space from camera space, (4, 4), with reversed depth: 1 at the near plane. `aspect` is "
            "width over height.");
    module.def(
        "look_at", &lookAtView, nb::arg("eye"), nb::arg("target"), nb::arg("vertical_fov") = defaultFov,
        nb::arg("near_plane") = nb::none(),
        nb::sig(
            "def look_at(eye: numpy.typing.ArrayLike, target: numpy.typing.ArrayLike, vertical_fov: float = "
            "0.785398, near_plane: float | None = None) -> CameraView"),
        "A view from `eye` towards `target`, world space, metres, +Y up. `vertical_fov` is in radians; the "
        "near plane is 1 cm or a hundredth of the distance, the nearer one, unless it is given.");
}

}  // namespace candela::python
