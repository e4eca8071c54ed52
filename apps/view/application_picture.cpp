// The part of `Application` that draws pictures of the scene.

#include "application.h"

#include "common/scene_environment.h"
#include "common/scene_lights.h"
#include "comparison.h"
#include "refinement.h"
#include "render_command_line.h"
#include "scene_lighting.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace {

constexpr std::size_t keptFrames = 240;

/// Everything that a picture depends on, as text: equal texts, equal pictures.
std::string pictureKey(const ViewModel& model, const SceneOptions& options) {
    return renderCommandLine(options) + " " + std::to_string(options.display.exposure) + " #" +
           std::to_string(model.document->revision()) + "/" + std::to_string(model.divisor);
}

bool sameDisplayOptions(const candela::DisplayOptions& a, const candela::DisplayOptions& b) {
    return a.display == b.display && a.view == b.view && a.look == b.look && a.exposure == b.exposure;
}

}  // namespace

void Application::changeDisplay() {
    if (sameDisplayOptions(appliedDisplayOptions_, model_.options.display)) return;
    guarded([this] { display_ = model_.color.displayTransform(model_.options.display); });
    appliedDisplayOptions_ = model_.options.display;
}

void Application::drawExamplePictures() {
    const bool drawn = examples_.advance(
        {plugins_, viewport_, model_.color, *display_, uploadOptions(model_.color), &Window::wake},
        model_.examples);
    if (drawn) settling_ = settlingFrames;
}

void Application::drawPicture(Motion motion) {
    if (!model_.document) {
        // Where no scene comes, the frames of a script show none.
        if (options_.scripted() && options_.scene.empty()) ++drawnFrames_;
        if (!model_.loading && !window_.hasPendingInput()) drawExamplePictures();
        return;
    }
    changeDisplay();
    if (!options_.scripted()) model_.divisor = resolutionScale_.divisor(motion, Clock::now());
    const std::string key = pictureKey(model_, model_.options);
    const bool isDrawn = key == drawnPicture_ && !options_.scripted();
    if (!isDrawn) drawWholePicture(key);
    drawLeftSide();
    // Input does not wait for a sample.
    if (isDrawn && motion == Motion::rests && !window_.hasPendingInput()) refine();
}

void Application::drawWholePicture(const std::string& key) {
    settling_ = std::max(settling_, 1);  // panels show the numbers of this picture in the next frame
    drawnPicture_ = key;
    guarded([&] {
        const candela::CameraView view = selectedView(model_);
        followView(model_, view);
        lightDocument(model_, view);
        hasLeftLight_ = false;
        const double milliseconds =
            viewport_.draw({model_.document->gpuScene(), model_.options, view, *display_, model_.divisor});
        resolutionScale_.tookMilliseconds(milliseconds);
        model_.frames.push_back({viewport_.frame()->passTimes(), milliseconds});
        if (model_.frames.size() > keptFrames) model_.frames.pop_front();
        model_.technique = viewport_.frame()->technique();
        model_.maxLightCount = viewport_.frame()->maxLightCount();
        model_.layerCounts = viewport_.frame()->layerCounts();
        model_.samples = viewport_.samples();
        model_.pairs.reset();
        ++drawnFrames_;
        if (!std::exchange(newDocument_, false)) return;
        if (model_.options.autoExposure || exposesScenes()) measureExposure();
        model_.document->history().rebase(model_.options);
        noteFirstPicture(model_, *viewport_.frame());
    });
}

Viewport& Application::besideViewport() {
    if (!beside_) beside_.emplace(context_);
    return *beside_;
}

bool Application::showsLeftSide() const {
    return model_.comparison.shown && !options_.scripted() && model_.document && beside_ &&
           beside_->frame() != nullptr && !drawnLeft_.empty();
}

int Application::lineColumn() const {
    return static_cast<int>(std::lround(model_.comparison.line * static_cast<float>(pictureSize_.x)));
}

/// What shows this pixel of the picture.
const Viewport& Application::viewportAt(const glm::ivec2& pixel) const {
    return showsLeftSide() && pixel.x < lineColumn() ? *beside_ : viewport_;
}

/// The light of the left side stays on the device while only that side is refined: another environment takes
/// long to bring there.
void Application::lightLeftSide(const SceneOptions& options, const candela::CameraView& view) {
    hasLeftLight_ = true;
    lightDocumentAs(model_, options, view);
}

void Application::lightRightSide() {
    if (std::exchange(hasLeftLight_, false)) lightDocument(model_, selectedView(model_));
}

/// The left side of a comparison, of one sample.
void Application::drawLeftSide() {
    if (!model_.comparison.shown || options_.scripted()) {
        drawnLeft_.clear();
        guarded([this] { lightRightSide(); });
        return model_.document->forgetEnvironmentFiles();
    }
    model_.document->keepEnvironmentFiles();
    const SceneOptions options = leftOptions(model_);
    const std::string key = pictureKey(model_, options);
    if (key == drawnLeft_) return;
    drawnLeft_ = key;
    settling_ = std::max(settling_, 1);
    guarded([&] {
        leftDisplay_ = model_.color.displayTransform(options.display);
        const candela::CameraView view = selectedView(model_);
        lightLeftSide(options, view);
        besideViewport().draw({model_.document->gpuScene(), options, view, *leftDisplay_, model_.divisor});
    });
}

/// One more sample of what has not all of them, or a small picture.
void Application::refine() {
    const bool picture = isRefiningPicture(), left = isRefiningLeft();
    if (left && (!picture || leftIsNext())) return refineLeftSide();
    if (picture) return refinePicture();
    if (!thumbnails_.isDue(model_) || model_.comparison.shown) return;
    settling_ = settlingFrames;
    guarded([&] {
        thumbnails_.drawNext(model_, {besideViewport(), *display_, uploadOptions(model_.color)});
    });
}

/// The sides take turns, unless each turn brings another environment to the device.
bool Application::leftIsNext() const {
    const SceneOptions& left = model_.comparison.left;
    const bool sameLight = toString(left.environment) == toString(model_.options.environment) &&
                           left.environment.source == model_.options.environment.source;
    return sameLight && beside_->samples() < viewport_.samples();
}

bool Application::isRefining() const {
    return model_.document && !drawnPicture_.empty() &&
           (isRefiningPicture() || isRefiningLeft() ||
            (thumbnails_.isDue(model_) && !model_.comparison.shown));
}

bool Application::isRefiningPicture() const {
    return model_.document && viewport_.frame() != nullptr && !drawnPicture_.empty() && model_.divisor == 1 &&
           viewport_.samples() < wantedSamples(model_.options);
}

bool Application::isRefiningLeft() const {
    return showsLeftSide() && model_.divisor == 1 && beside_->samples() < wantedSamples(leftOptions(model_));
}

void Application::refineLeftSide() {
    settling_ = std::max(settling_, 1);
    guarded([&] {
        const SceneOptions options = leftOptions(model_);
        lightLeftSide(options, selectedView(model_));
        drawSample(model_, options, *beside_, *leftDisplay_);
    });
}

void Application::refinePicture() {
    settling_ = std::max(settling_, 1);
    try {
        lightRightSide();
        drawSample(model_, model_.options, viewport_, *display_);
        model_.samples = viewport_.samples();
    } catch (const std::exception& error) {
        drawnPicture_.clear();
        reportFailure(error.what());
    }
}

void Application::measureExposure() {
    ::measureExposure(model_, *viewport_.frame());
    changeDisplay();
    drawnPicture_.clear();
}

/// A scene is shown at its own exposure, unless the command line says another. Default lights suit any.
bool Application::exposesScenes() const {
    return !options_.scripted() && !options_.exposureGiven &&
           !usesDefaultLights(model_.document->scene(), model_.options.defaultLights);
}
