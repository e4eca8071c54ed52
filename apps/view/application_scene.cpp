// The part of `Application` that opens scenes and brings them to the device.

#include "application.h"

#include "common/program.h"
#include "common/scene_selection.h"
#include "interaction.h"
#include "settings.h"

#include <candela/error.h>

#include <utility>

void Application::open(const std::string& scene) {
    SceneOptions wanted = model_.options;
    // Another scene has other cameras and lights of its own.
    if (scene != options_.scene || model_.document) takeOptionsOfScene({}, wanted);
    wanted.scene = scene;
    examples_.stop();
    loader_.start(plugins_, wanted, &Window::wake);
}

void Application::takeLoaded() {
    std::optional<SceneLoader::Result> loaded = loader_.take();
    model_.loading = loader_.status();
    if (!loaded) return;
    if (!loaded->error.empty()) return reportFailure(loaded->error);
    if (loaded->scene) guarded([&] { install(std::move(*loaded)); });
}

candela::GpuSceneOptions Application::uploadOptions(const candela::ColorConfig& color) const {
    candela::GpuSceneOptions upload;
    upload.workingFromRec709 = color.workingFromRec709();
    upload.rangeLoss = model_.options.rangeLoss;
    upload.subdivider = plugins_.subdivider();
    upload.subdivision = model_.options.subdivision;
    upload.vertexEvaluator = model_.options.vertexEvaluator;
    return upload;
}

/// The old scene stays until the new one is on the device.
void Application::install(SceneLoader::Result loaded) {
    const std::size_t scattered = loaded.options.scatter ? loaded.options.scatter->count : 0;
    auto document = uploading(loaded.options.scene, [&] {
        return std::make_unique<Document>(std::move(*loaded.scene), context_, uploadOptions(model_.color),
                                          scattered);
    });
    document->setTime(poseTime(document->scene(), loaded.options, loaded.options.time));
    SceneOptions options = model_.options;
    takeOptionsOfScene(loaded.options, options);
    std::swap(model_.document, document);
    std::swap(model_.options, options);
    try {
        loadCamera(model_);  // an unknown --camera shows here
    } catch (...) {
        std::swap(model_.document, document);
        std::swap(model_.options, options);
        throw;
    }
    outline_.forget();
    thumbnails_.forget(model_);
    drawnLeft_.clear();
    hasLeftLight_ = false;
    model_.gizmo.dragged.reset();
    model_.gizmo.middle = {};
    model_.pickedNode.reset();
    model_.pickedLight.reset();
    model_.pickedMaterial.reset();
    model_.pairs.reset();
    drawnPicture_.clear();
    newDocument_ = true;
    rememberScene(model_.recent, model_.options.scene);
    window_.setTitle(model_.options.scene + " - candela");
}

/// Of the open scene; empty: none.
void Application::showVariant(const std::string& variant) {
    const std::optional<std::string> wanted = variant.empty() ? std::nullopt : std::optional(variant);
    Document& document = *model_.document;
    document.setVariant(wanted, context_, uploadOptions(model_.color));
    model_.options.variant = wanted;
    drawnPicture_.clear();
}

void Application::reloadShaders() {
    drawnPicture_.clear();
    drawnLeft_.clear();
    beside_.reset();
    try {
        if (!model_.document) {
            viewport_.reloadShaders(std::nullopt);
        } else {
            Document& document = *model_.document;
            // Cages hold a program of their own.
            std::optional<candela::GpuScene> fresh;
            if (!document.scene().cages.empty())
                fresh = document.upload(context_, uploadOptions(model_.color));
            viewport_.reloadShaders(Viewport::Inputs{fresh ? *fresh : document.gpuScene(), model_.options,
                                                     selectedView(model_), *display_, model_.divisor});
            if (fresh) document.adopt(std::move(*fresh));
        }
        model_.shaderError.clear();
    } catch (const candela::Error& error) {
        model_.shaderError = error.what();
    }
}
