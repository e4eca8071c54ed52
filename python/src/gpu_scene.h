#pragma once

#include "gpu_context.h"
#include "scene_types.h"

#include <candela/gpu_scene.h>

#include <memory>
#include <optional>

namespace candela::python {

/// A scene on a device, with what views of it need of the scene.
struct GpuSceneData {
    ContextPtr context;
    ScenePtr source;
    std::uint64_t version = 0;  ///< Of the source, when it was uploaded.
    ContextObject<GpuScene> scene;
    std::optional<Bounds> box;  ///< Of the automatic view, once it was asked for.
    bool isAnimated = false;
    double time = 0.0;  ///< Seconds, at which it is posed.

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

/// Uploads with the keywords of `options` (`uploadKeywords`).
GpuScenePtr upload(const ContextPtr& context, const ColorConfig& color, const SceneHandle& scene,
                   const nb::kwargs& options);
extern const char* const uploadKeywords;

/// The view that a picture of an uploaded scene shows (`resolveView`).
CameraView viewOf(GpuSceneData& data, nb::handle camera, double time, float aspect);

}  // namespace candela::python
