#pragma once

#include "gpu_context.h"
#include "scene_types.h"

#include <candela/gpu_scene.h>
#include <candela/handle.h>

#include <memory>
#include <optional>

namespace candela::python {

/// The view of a camera of a scene, or of all of it, as it was asked for last.
struct CachedView {
    std::optional<std::uint32_t> camera;
    double time = 0.0;
    float aspect = 0.0f;
    std::uint64_t version = 0;  ///< Of the scene.
    CameraView view;
};

/// A scene on a device, with what views of it need of the scene.
struct GpuSceneData {
    ContextPtr context;
    ScenePtr source;
    std::uint64_t version = 0;  ///< Of the source, when it was uploaded.
    ContextObject<GpuScene> scene;
    std::optional<Bounds> box;  ///< Of the automatic view, once it was asked for.
    std::optional<CachedView> lastView;
    bool isAnimated = false;
    bool subdivides = false;  ///< There is a plugin that refines cages.
    double time = 0.0;        ///< Seconds, at which it is posed.

    explicit GpuSceneData(ContextPtr used) : context(std::move(used)), scene(context) {}
    ~GpuSceneData() {
        scene.discard();
        tidy(context);
    }
};

using GpuScenePtr = std::shared_ptr<GpuSceneData>;

/// `GpuScene` in Python.
struct GpuSceneHandle {
    GpuScenePtr data;
};

/// Calls `edit(GpuScene&)` without the GIL.
template <typename Edit>
void edited(const GpuSceneHandle& self, const Edit& edit) {
    const Session session(self.data->context, "GpuScene");
    edit(*self.data->scene);
}

/// Binds what changes elements of a `GpuScene`.
void bindGpuSceneEdits(nb::module_& module, nb::class_<GpuSceneHandle>& cls);

/// Warns that cages are drawn as polygons.
void warnPolygons();

/// Uploads with the keywords of `options` (`uploadKeywords`).
GpuScenePtr upload(const ContextPtr& context, const ColorConfig& color, const SceneHandle& scene,
                   const nb::kwargs& options);
extern const char* const uploadKeywords;

/// The view that a picture of an uploaded scene shows (`resolveView`).
CameraView viewOf(GpuSceneData& data, nb::handle camera, double time, float aspect);

}  // namespace candela::python
