#pragma once

#include "renderer.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace candela::python {

/// What a picture was asked for by keywords.
struct Request {
    RenderSettings settings;
    std::vector<std::string> aovs;
    std::optional<double> time;
    nb::object progress = nb::none();
    nb::kwargs upload = nb::steal<nb::kwargs>(PyDict_New());
};

/// Checks the keywords. Throws `Error` (badInput), and TypeError for one that there is none of.
Request requestOf(const nb::kwargs& options);

/// The scene on the device: a `Scene` is uploaded, and again when it has changed.
GpuScenePtr uploadedScene(RendererData& renderer, nb::handle scene, const Request& request);

/// The views of all samples where the shutter sees motion; otherwise one.
std::vector<CameraView> viewsOf(GpuSceneData& scene, const RenderSettings& settings, nb::handle camera,
                                double time);

/// Draws all samples of `frame`, whose scene and settings are set.
void drawSamples(const Session& session, FrameData& frame, const std::vector<CameraView>& views, double time,
                 const AccumulatorOptions& options, const Progress& progress);

}  // namespace candela::python
