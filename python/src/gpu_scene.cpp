#include "gpu_scene.h"

#include "module.h"
#include "words.h"

#include <candela/default_lights.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <glm/geometric.hpp>

namespace candela::python {

const char* const uploadKeywords =
    ", *, environment: Environment | typing.Literal['auto'] | None = 'auto', range_loss: float = 0.01, "
    "subdivision_level: int | None = None, subdivision_edge_pixels: float = 8.0, subdivision_max_level: int "
    "= 5, subdivision_max_vertices: int = 2000000, vertex_evaluator: typing.Literal['auto', 'cpu', "
    "'compute'] = 'auto', "
    "vertex_detail: typing.Literal['as_needed', 'always'] = 'as_needed', plugins: PluginRegistry | None = "
    "None";

namespace {

// Of a studio that nobody asked for, a surface farther away than this share of the scene's size hides
// nothing: the inside of a closed room is lit too.
constexpr float occlusionShare = 0.1f;

struct UploadOptions {
    GpuSceneOptions scene;
    bool automatic = true;  ///< A studio lights a scene without light.
    bool replaces = false;  ///< `environment` takes the place of the scene's own.
    std::optional<Environment> environment;
    std::optional<PluginRegistry> plugins;
};

void readOption(UploadOptions& options, const std::string& name, nb::handle value) {
    SubdivisionSettings& subdivision = options.scene.subdivision;
    if (name == "environment") {
        options.automatic = nb::isinstance<nb::str>(value) && nb::str(value).equal(nb::str("auto"));
        options.replaces = !options.automatic;
        if (options.replaces) options.environment = Convert<std::optional<Environment>>::from(value, name);
    } else if (name == "range_loss") {
        options.scene.rangeLoss = Convert<float>::from(value, name);
    } else if (name == "subdivision_level") {
        subdivision.level = Convert<std::optional<std::uint32_t>>::from(value, name);
    } else if (name == "subdivision_edge_pixels") {
        subdivision.edgePixels = Convert<float>::from(value, name);
    } else if (name == "subdivision_max_level") {
        subdivision.maxLevel = Convert<std::uint32_t>::from(value, name);
    } else if (name == "subdivision_max_vertices") {
        subdivision.maxVertices = Convert<std::uint64_t>::from(value, name);
    } else if (name == "vertex_evaluator") {
        options.scene.vertexEvaluator = Convert<VertexEvaluator>::from(value, name);
    } else if (name == "vertex_detail") {
        options.scene.vertexDetail = Convert<VertexDetail>::from(value, name);
    } else if (name == "plugins") {
        if (value.is_none()) return;
        if (!nb::isinstance<PluginRegistry>(value)) failConversion(name, "a PluginRegistry", value);
        options.plugins = nb::cast<PluginRegistry>(value);
    } else {
        throw nb::type_error(("upload has no option '" + name + "'").c_str());
    }
}

Environment addedStudio(const Scene& scene) {
    Environment studio = studioEnvironment();
    const Bounds box = framedBox(scene);
    const float size = box.empty() ? 0.0f : glm::distance(box.min, box.max);
    if (size > 0.0f) studio.occlusionDistance = occlusionShare * size;
    return studio;
}

}  // namespace

void warnPolygons() {
    warnUser(
        "no plugin that refines subdivision cages was found (opensubdiv does): their polygons are drawn");
}

GpuScenePtr upload(const ContextPtr& context, const ColorConfig& color, const SceneHandle& handle,
                   const nb::kwargs& keywords) {
    UploadOptions options;
    for (const auto& [name, value] : keywords) readOption(options, nb::str(name).c_str(), value);
    options.scene.workingFromRec709 = color.workingFromRec709();
    const Scene& scene = handle.data->scene;
    // Also where there are none yet: cages may be added.
    options.scene.subdivider = (options.plugins ? *options.plugins : defaultPlugins()).subdivider();
    if (!scene.cages.empty() && !options.scene.subdivider) warnPolygons();

    auto data = std::make_shared<GpuSceneData>(context);
    data->source = handle.data;
    data->version = handle.data->version;
    data->isAnimated = candela::isAnimated(scene);
    data->subdivides = options.scene.subdivider.has_value();
    bool addsStudio = false;
    {
        const SceneReader reader(*handle.data);
        const Session session(context, "Renderer");
        GpuScene& uploaded = data->scene.emplace(session.context(), scene, options.scene);
        addsStudio = options.automatic && !scene.environment && !hasLight(scene);
        if (addsStudio) options.environment = addedStudio(scene);
        if (addsStudio || options.replaces) uploaded.setEnvironment(options.environment);
    }
    if (addsStudio)
        warnUser("the scene has no light of its own: a studio lights it (environment=None leaves it out)");
    return data;
}

CameraView viewOf(GpuSceneData& data, nb::handle camera, double time, float aspect) {
    if (nb::isinstance<CameraView>(camera)) return nb::cast<CameraView>(camera);
    const Scene& scene = data.source->scene;
    const std::optional<std::uint32_t> index = cameraFrom(scene, camera);
    // World matrices of all nodes take longer than a small picture.
    const std::optional<CachedView>& last = data.lastView;
    if (last && last->camera == index && last->time == time && last->aspect == aspect &&
        last->version == data.source->version)
        return last->view;
    const CameraView view = viewOf(scene, index, time, aspect, [&] {
        if (!data.box) data.box = framedBox(scene);
        return *data.box;
    });
    data.lastView = {index, time, aspect, data.source->version, view};
    return view;
}

namespace {

void setLights(const GpuSceneHandle& self, nb::object positions, const nb::kwargs& options) {
    const LightArrays arrays(positions, options);
    edited(self, [&](GpuScene& scene) {
        std::vector<WorldLight> lights(arrays.size());
        for (std::size_t i = 0; i < lights.size(); ++i) lights[i] = arrays.worldLight(i);
        scene.setLights(lights);
    });
}

nb::dict reportOf(const GpuSceneHandle& self) {
    LightReport lights;
    CageReport cages;
    DeformationReport deformed;
    OcclusionReport occlusion;
    std::uint64_t triangles = 0;
    std::uint32_t materials = 0;
    edited(self, [&](GpuScene& scene) {
        lights = scene.lightReport();
        cages = scene.cageReport();
        deformed = scene.deformationReport();
        occlusion = scene.occlusionReport();
        triangles = scene.triangleCount();
        materials = scene.materialCount();
    });
    nb::dict report;
    report["lights"] = lights.lights;
    report["lights_without_range"] = lights.rangesAssigned;
    report["min_range"] = lights.minRange;
    report["max_range"] = lights.maxRange;
    report["triangles"] = triangles + cages.triangles;
    report["materials"] = materials;
    report["cages"] = cages.cages;
    report["cage_levels"] = nb::make_tuple(cages.minLevel, cages.maxLevel);
    report["cages_coarser_than_asked"] = cages.lodClamped;
    report["deformed_meshes"] = deformed.meshes;
    report["deformed_vertices"] = deformed.vertices;
    report["occlusion_bytes"] = occlusion.bytes;
    report["occlusion_build_milliseconds"] = occlusion.buildMilliseconds;
    return report;
}

void bindAnimationEdits(nb::class_<GpuSceneHandle>& cls) {
    using Self = const GpuSceneHandle&;
    cls.def(
           "set_time",
           [](Self self, double seconds) {
               edited(self, [&](GpuScene& scene) { scene.setTime(seconds); });
               self.data->time = seconds;
           },
           nb::arg("seconds"), "Poses all that is animated.")
        .def(
            "keep_poses", [](Self self) { edited(self, [](GpuScene& scene) { scene.keepPoses(); }); },
            "Remembers where all nodes are, and the vertices that skins, morph targets, cages and the frame "
            "callback of a plugin move, for the AOV motion, which shows the way from there; not those of "
            "`set_positions`. Before the first call nothing moves but the camera (`previous_camera`).")
        .def(
            "play_animations",
            [](Self self, const std::vector<std::uint32_t>& animations) {
                edited(self, [&](GpuScene& scene) { scene.playAnimations(animations); });
            },
            nb::arg("animations"), "Lets the animations of these indices play, and no other.");
}

}  // namespace

void bindGpuScenes(nb::module_& module) {
    using Self = const GpuSceneHandle&;
    nb::class_<GpuSceneHandle> cls(
        module, "GpuScene",
        "A scene on a device, from `Renderer.upload`. Edits cost in proportion to "
        "what they change, and the next picture shows them. The Scene that it was made from stays as it is.");
    cls.def("set_lights", &setLights, nb::arg("positions").none(), nb::arg("options"),
            nb::sig(kept(std::string("def set_lights(self, positions: numpy.typing.ArrayLike | None") +
                         LightArrays::keywords() + ") -> None")),
            "Replaces all lights: positions (N, 3) in world space, metres, and what `Scene.add_lights` "
            "takes. 100,000 of them make one upload. Nodes and animations move lights no longer.")
        .def(
            "set_environment",
            [](Self self, nb::object environment) {
                const auto value = Convert<std::optional<Environment>>::from(environment, "environment");
                edited(self, [&](GpuScene& scene) { scene.setEnvironment(value); });
            },
            nb::arg("environment").none(),
            nb::sig("def set_environment(self, environment: Environment | None) -> None"),
            "Replaces the environment, which takes some tenths of a second.")
        .def(
            "set_environment_settings",
            [](Self self, nb::object rotation, float intensity, bool isBackground,
               std::optional<float> occlusionDistance) {
                const EnvironmentSettings settings{Convert<glm::quat>::from(rotation, "rotation"), intensity,
                                                   isBackground, occlusionDistance};
                edited(self, [&](GpuScene& scene) { scene.setEnvironmentSettings(settings); });
            },
            nb::kw_only(), nb::arg("rotation") = nb::make_tuple(0, 0, 0, 1), nb::arg("intensity") = 1.0f,
            nb::arg("is_background") = true, nb::arg("occlusion_distance") = nb::none(),
            nb::sig("def set_environment_settings(self, *, rotation: numpy.typing.ArrayLike = (0, 0, 0, 1), "
                    "intensity: float = 1.0, is_background: bool = True, occlusion_distance: float | None = "
                    "None) -> None"),
            "Turns, dims or shows the environment, at no cost.")
        .def(
            "set_subdivision",
            [](Self self, std::optional<std::uint32_t> level, float edgePixels, std::uint32_t maxLevel,
               std::uint64_t maxVertices) {
                edited(self, [&](GpuScene& scene) {
                    scene.setSubdivision({level, edgePixels, maxLevel, maxVertices});
                });
            },
            nb::kw_only(), nb::arg("level") = nb::none(), nb::arg("edge_pixels") = 8.0f,
            nb::arg("max_level") = 5, nb::arg("max_vertices") = 2'000'000,
            "How far cages are refined: to `level`, or by their size on the screen.")
        .def("report", &reportOf, nb::sig("def report(self) -> dict[str, object]"),
             "Counts: lights and the ranges that they were given, triangles, materials, levels of cages, "
             "memory.")
        .def_prop_ro(
            "source", [](Self self) { return SceneHandle{self.data->source}; },
            "The scene that it was made from.");
    bindAnimationEdits(cls);
    bindGpuSceneEdits(module, cls);
}

}  // namespace candela::python
