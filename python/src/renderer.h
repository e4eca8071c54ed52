#pragma once

#include "gpu_scene.h"
#include "settings.h"

#include <candela/accumulator.h>
#include <candela/color.h>
#include <candela/renderer.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela::python {

/// What `Renderer` in Python draws with. Targets belong to the frame that was drawn last.
struct RendererData {
    ContextPtr context;
    ColorConfig color;
    ContextObject<Renderer> renderer;
    ContextObject<Accumulator> accumulator;
    AccumulatorOptions accumulated;  ///< What `accumulator` was made for.
    std::uint64_t number = 0;        ///< Of the last frame.
    GpuScenePtr uploaded;            ///< Of the last `Scene` that was given to `render`.
    std::string uploadedWith;        ///< The options of the upload.

    RendererData(ContextPtr used, ColorConfig config)
        : context(std::move(used)), color(std::move(config)), renderer(context), accumulator(context) {}
    ~RendererData() {
        accumulator.discard();
        renderer.discard();
        tidy(context);
    }
};

using RendererPtr = std::shared_ptr<RendererData>;

/// A frame that was drawn, of one sample or more.
struct FrameData {
    RendererPtr renderer;
    GpuScenePtr scene;
    CameraView view;
    RenderSettings settings;
    std::uint64_t number = 0;
    std::uint32_t samples = 1;  ///< In the mean; 1: `frame` alone.
    bool accumulates = false;
    ContextObject<Frame> frame;
    std::shared_ptr<std::vector<Aov>> aovs = std::make_shared<std::vector<Aov>>();
    std::optional<double> autoExposure;

    explicit FrameData(RendererPtr drawn) : renderer(std::move(drawn)), frame(renderer->context) {}
    ~FrameData() {
        frame.discard();
        tidy(renderer->context);
    }

    /// Throws `Error` (badInput) when the renderer has drawn another one since.
    void requireLast() const;
};

using FramePtr = std::shared_ptr<FrameData>;

/// `Frame` in Python.
struct FrameHandle {
    FramePtr data;
};

/// Python's callback, or None, of a picture that is drawn in `parts`, of which this is one.
struct Progress {
    nb::handle callback;
    std::size_t part = 0, parts = 1;
};

/// Called between samples, without the GIL: lets signals through, and calls Python's callback, if there is
/// one. Throws `Error` (cancelled) when that returns False.
void passProgress(const Progress& progress, std::uint32_t done, std::uint32_t count);

/// Keywords of `render` that panoramas do not have.
extern const std::vector<std::string> withoutPanorama;

/// Draws a panorama: radiance, (width / 2, width, 4) of float32.
nb::object renderPanorama(const RendererPtr& renderer, nb::handle scene, nb::handle camera, int width,
                          const nb::kwargs& options);

/// The AOV's name in the channel table: "depth", "position" and "normal" are other names of "Z", "P" and "N".
std::string channelName(const std::string& name);

ContextPtr contextOf(nb::handle context);
nb::object contextObject(const ContextPtr& data);

}  // namespace candela::python
