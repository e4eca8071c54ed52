#include "frame.h"
#include "render_request.h"

#include <candela/panorama.h>

#include <array>

namespace candela::python {

const std::vector<std::string> withoutPanorama{"width", "height", "region", "show"};

namespace {

Request panoramaRequest(int width, const nb::kwargs& options) {
    std::vector<std::string> refused = withoutPanorama;
    refused.insert(refused.end(), {"aovs", "previous_camera"});
    for (const std::string& name : refused)
        if (options.contains(name.c_str()))
            throw nb::type_error(("render_panorama has no option '" + name + "'").c_str());
    Request request = requestOf(options);
    FrameSettings& settings = request.settings.frame;
    if (settings.debugView != DebugView::none || settings.region)
        throw Error(ErrorKind::badInput, "",
                    "render_panorama: the settings have a region or show data, which no panorama does");
    settings.width = width;
    settings.height = width / 2;
    return request;
}

}  // namespace

nb::object renderPanorama(const RendererPtr& renderer, nb::handle scene, nb::handle camera, int width,
                          const nb::kwargs& options) {
    const Request request = panoramaRequest(width, options);
    FrameData face(renderer);
    face.scene = uploadedScene(*renderer, scene, request);
    face.settings = request.settings;
    const double time = request.time.value_or(face.scene->time);
    std::vector<PanoramaFaces> faces;  // Of the views of all samples, or of the one.
    for (const CameraView& view : viewsOf(*face.scene, request.settings, camera, time))
        faces.push_back(panoramaFaces(view, width));
    face.settings.frame.width = face.settings.frame.height = faces.front().size;
    HdrImage whole;
    {
        const Session session(renderer->context, "Renderer");
        std::array<HdrImage, 6> pictures;
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            std::vector<CameraView> views;
            for (const PanoramaFaces& each : faces) views.push_back(each.views[i]);
            const Progress progress{request.progress, i, pictures.size()};
            drawSamples(session, face, views, time, {}, progress);
            if (!face.accumulates) passProgress(progress, 1, 1);
            pictures[i] = radianceOf(face);
        }
        whole = panorama(pictures, width);
    }
    return imageArray(std::move(whole));
}

}  // namespace candela::python
