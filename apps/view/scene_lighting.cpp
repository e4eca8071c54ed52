#include "scene_lighting.h"

#include "common/scene_environment.h"
#include "common/scene_lights.h"
#include "interaction.h"

#include <candela/error.h>
#include <candela/exposure.h>

#include <array>
#include <utility>

namespace {

/// Default lights depend on the environment that is there.
void setDefaultLighting(Document& document, const SceneOptions& options, const candela::CameraView& view) {
    std::optional<Document::DefaultLighting> lighting;
    if (usesDefaultLights(document.scene(), options.defaultLights))
        lighting = {view, options.autoExposure ? 0.0 : options.display.exposure};
    document.setDefaultLighting(lighting);
}

}  // namespace

void lightDocument(ViewModel& model, const candela::CameraView& view) {
    try {
        for (const std::string& note : model.document->setEnvironment(model.options))
            model.messages.push_back({Message::Kind::note, note});
    } catch (...) {
        model.options.environment = model.document->environmentOption();
        throw;
    }
    setDefaultLighting(*model.document, model.options, view);
    const auto& environment = model.document->scene().environment;
    model.background = environment ? std::optional(environment->isBackground) : std::nullopt;
}

void lightDocumentAs(ViewModel& model, const SceneOptions& options, const candela::CameraView& view) {
    model.document->setEnvironment(options);
    setDefaultLighting(*model.document, options, view);
}

void withLighting(ViewModel& model, const SceneOptions& options, const candela::CameraView& view,
                  const std::function<void()>& work) {
    Document& document = *model.document;
    const auto restore = [&] {
        document.setEnvironment(model.options);
        setDefaultLighting(document, model.options, selectedView(model));
    };
    document.setEnvironment(options);
    try {
        setDefaultLighting(document, options, view);
        work();
    } catch (...) {
        restore();
        throw;
    }
    restore();
}

bool takeAsEnvironment(ViewModel& model, const std::string& file) {
    if (!isEnvironmentFile(file)) return false;
    model.requests.openEnvironment = file;
    return true;
}

void takeEnvironment(ViewModel& model, EnvironmentLoader& loader) {
    std::optional<EnvironmentLoader::Result> loaded = loader.take();
    model.loadingEnvironment = loader.reading();
    if (!loaded) return;
    if (!loaded->error.empty()) throw candela::Error(candela::ErrorKind::badInput, "", loaded->error);
    SceneOptions options = model.options;
    options.environment.source = EnvironmentOption::Source::file;
    options.environment.file = loaded->file;
    if (model.document) {
        for (const std::string& note : loaded->light.notes)
            model.messages.push_back({Message::Kind::note, note});
        model.document->setEnvironment(options, std::move(loaded->light));
    }
    model.options.environment = options.environment;
}

void measureExposure(ViewModel& model, const candela::Frame& frame) {
    const std::array<candela::HdrImage, 1> frames{frame.radiance()};
    model.options.display.exposure =
        candela::autoExposure(frames, model.color.luminanceWeights()).value_or(0.0);
}

void noteFirstPicture(ViewModel& model, const candela::Frame& frame) {
    const bool added = usesDefaultLights(model.document->scene(), model.options.defaultLights);
    if (added && model.options.defaultLights == DefaultLights::automatic)
        model.messages.push_back({Message::Kind::note, defaultLightsNote});
    if (model.options.debug.view != candela::DebugView::none) return;
    const candela::ExposureCounts counts = candela::countExposure(
        frame.radiance(), model.color.luminanceWeights(), model.options.display.exposure);
    if (const std::optional<std::string> note = pictureNote(counts))
        model.messages.push_back({Message::Kind::note, *note});
}
