#include "application.h"

#include "close_signals.h"
#include "common/output_file.h"
#include "common/program.h"
#include "common/scene_selection.h"
#include "panels/panels.h"
#include "refinement.h"
#include "render_command_line.h"
#include "scene_lighting.h"
#include "settings.h"
#include "window.h"

#include <candela/error.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <system_error>
#include <utility>

namespace {

constexpr std::size_t keptFrames = 240;
constexpr int settlingFrames = 3;
constexpr double longestStep = 0.25;  ///< The maximum advance of time between two frames, seconds.

/// Everything that the picture depends on, as text: equal texts, equal pictures.
std::string pictureKey(const ViewModel& model) {
    return renderCommandLine(model.options) + " #" + std::to_string(model.document->revision()) + "/" +
           std::to_string(model.divisor);
}

ViewModel modelOf(const ViewOptions& options, const std::filesystem::path& folder) {
    ViewModel model;
    model.options = options;
    // A script draws one sample unless it asks for more.
    if (options.scripted() && !options.sampling.count) model.options.sampling.count = 1;
    if (!options.scripted()) readSettings(folder, options, model);
    return model;
}

bool sameDisplayOptions(const candela::DisplayOptions& a, const candela::DisplayOptions& b) {
    return a.display == b.display && a.view == b.view && a.look == b.look && a.exposure == b.exposure;
}

std::filesystem::path preparedFolder(const ViewOptions& options) {
    const std::filesystem::path folder = settingsFolder();
    if (options.settings == StoredSettings::reset) forgetSettings(folder);
    return options.scripted() ? std::filesystem::path() : folder;
}

void checkOutputs(const ViewOptions& options) {
    if (options.screenshot) checkWritable(*options.screenshot);
    if (options.windowScreenshot) checkWritable(*options.windowScreenshot);
}

}  // namespace

Application::Application(const ViewOptions& options)
    : options_(options),
      settingsFolder_(preparedFolder(options)),
      model_(modelOf(options, settingsFolder_)),
      window_({model_.options.width, model_.options.height}, layoutFile(settingsFolder_)),
      context_(candela::Context::adoptCurrent()),
      plugins_(options.pluginFolders),
      viewport_(context_),
      shaders_(&Window::wake) {
    model_.renderer = context_.renderer();
    checkOutputs(options);
    chooseFirstColor();
    if (!model_.options.scene.empty()) open(model_.options.scene);
}

/// Objects on the device are destroyed before its context.
Application::~Application() {
    model_.document.reset();
}

/// The config of the last session may be gone, or have other displays now.
void Application::chooseFirstColor() {
    try {
        changeConfig(model_.options.ocio, model_.options.display);
    } catch (const candela::Error& error) {
        if (options_.scripted() || options_.displayGiven) throw;
        model_.messages.push_back(
            {Message::Kind::note,
             std::string("the colours of the last session are not used: ") + error.what()});
        changeConfig(std::nullopt, {});
    }
}

template <typename Work>
void Application::guarded(Work&& work) {
    try {
        work();
    } catch (const std::exception& error) {
        reportFailure(error.what());
    }
}

void Application::reportFailure(const std::string& text) {
    if (options_.scripted()) throw candela::Error(candela::ErrorKind::badInput, "", text);
    // What is tried in every frame fails in every frame.
    if (!model_.messages.empty() && model_.messages.back().text == text) return;
    model_.messages.push_back({Message::Kind::error, text});
}

void Application::run() {
    std::optional<CloseSignals> signals;
    if (!options_.scripted()) signals.emplace(&Window::wake);
    while (!window_.shouldClose() && !(signals && signals->raised()) && !ended()) {
        window_.handleEvents(sleep());
        step();
    }
    if (options_.scripted()) return finishScript();
    try {
        writeSettings(settingsFolder_, model_);
    } catch (const std::exception& error) {
        std::cerr << "note: the settings of this session are not kept: " << error.what() << "\n";
    }
}

void Application::finishScript() {
    if (!ended())
        throw candela::Error(candela::ErrorKind::environment, "", "the window was closed too early");
    if (options_.screenshot) writePicture(*options_.screenshot);
}

bool Application::timeAdvances() const {
    return model_.playing && model_.document && model_.document->animated();
}

/// Panels settle before the loop waits for events; full resolution returns after a short delay.
Window::Sleep Application::sleep() const {
    if (options_.scripted()) return model_.loading ? Window::Sleep::briefly : Window::Sleep::none;
    if (timeAdvances() || motion_ == Motion::moves || settling_ > 0 || isRefining())
        return Window::Sleep::none;
    return resolutionScale_.isReduced() ? Window::Sleep::briefly : Window::Sleep::untilEvent;
}

/// A screenshot of the window shows settled panels.
std::uint32_t Application::wantedFrames() const {
    return options_.frames.value_or(options_.windowScreenshot ? settlingFrames : 1);
}

bool Application::ended() const {
    return options_.scripted() && drawnFrames_ >= wantedFrames();
}

void Application::step() {
    settling_ = settling_ > 0 ? settling_ - 1 : settlingFrames;
    const glm::ivec2 size = window_.framebufferSize();
    if (size.x < 1 || size.y < 1) return;  // minimised
    // A script gets the size that it asks for, even where the desktop gives its window another one.
    if (!options_.scripted()) {
        model_.options.width = size.x;
        model_.options.height = size.y;
    }
    for (const std::string& file : window_.takeDropped())
        if (!takeAsEnvironment(model_, file)) model_.requests.open = file;
    takeLoaded();
    guarded([this] { takeEnvironment(model_, environments_); });
    if (shaders_.takeChange()) reloadShaders();
    advanceTime();
    window_.beginPanels();
    drawPanels(model_);
    motion_ = interact(model_, window_.pixelRatio());
    serveRequests();
    drawPicture(timeAdvances() ? Motion::moves : motion_);
    serveReadings();
    viewport_.show(size);
    window_.endPanels();
    if (options_.windowScreenshot && ended()) writeWindowPicture(*options_.windowScreenshot, size);
    window_.swap();
}

void Application::open(const std::string& scene) {
    SceneOptions wanted = model_.options;
    // Another scene has other cameras and lights of its own.
    if (scene != options_.scene || model_.document) takeOptionsOfScene({}, wanted);
    wanted.scene = scene;
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

void Application::advanceTime() {
    const Clock::time_point now = Clock::now();
    const double seconds = std::min(std::chrono::duration<double>(now - lastStep_).count(), longestStep);
    lastStep_ = now;
    if (!model_.document) return;
    if (model_.playing) model_.options.time += seconds;
    guarded([this] {
        model_.document->setTime(poseTime(model_.document->scene(), model_.options, model_.options.time));
    });
}

/// What the picture depends on.
void Application::serveRequests() {
    const auto open = std::exchange(model_.requests.open, std::nullopt);
    if (open) guarded([&] { this->open(*open); });
    const auto environment = std::exchange(model_.requests.openEnvironment, std::nullopt);
    if (environment) environments_.start(*environment, model_.options.strictness, &Window::wake);
    if (std::exchange(model_.requests.cancelLoading, false)) loader_.cancel();
    const auto variant = std::exchange(model_.requests.variant, std::nullopt);
    if (variant && model_.document) guarded([&] { showVariant(*variant); });
    const auto config = std::exchange(model_.requests.ocioConfig, std::nullopt);
    if (config) {
        candela::DisplayOptions display;  // the new config has its own names
        display.exposure = model_.options.display.exposure;
        guarded([&] { changeConfig(config->empty() ? std::nullopt : config, display); });
    }
    const bool all = std::exchange(model_.requests.frameAll, false);
    const bool picked = std::exchange(model_.requests.framePicked, false);
    if (!model_.document) return;
    if (all) frameBox(model_, model_.document->bounds());
    if (picked && model_.pickedNode) frameBox(model_, model_.document->bounds(*model_.pickedNode));
}

/// What depends on the picture, which is drawn by now.
void Application::serveReadings() {
    const Requests requests = std::exchange(model_.requests, {});
    if (!model_.document || viewport_.frame() == nullptr) return;
    guarded([&] {
        if (model_.panels.probe) probePointer();
        if (requests.pick) pick(*requests.pick);
        if (requests.measureExposure) measureExposure();
        if (requests.countPairs) model_.pairs = viewport_.frame()->countPairs();
    });
    if (requests.savePng) guarded([&] { writePicture(*requests.savePng); });
    if (requests.saveExr) guarded([&] { writePicture(*requests.saveExr); });
    if (requests.copyCommand) copyCommand();
}

/// Nothing changes when it throws.
void Application::changeConfig(const std::optional<std::string>& config,
                               const candela::DisplayOptions& displayOptions) {
    const candela::ColorConfig color = candela::ColorConfig::choose(config);
    const candela::DisplayTransform display = color.displayTransform(displayOptions);
    // Colours are uploaded in the working space.
    if (model_.document) model_.document->adopt(model_.document->upload(context_, uploadOptions(color)));
    model_.color = color;
    model_.options.ocio = config;
    model_.options.display = displayOptions;
    display_ = display;
    appliedDisplayOptions_ = displayOptions;
    drawnPicture_.clear();
}

void Application::pick(const glm::ivec2& pixel) {
    const glm::ivec2 place = viewport_.pixelAt(pixel);
    const auto probe = viewport_.frame()->probe(place.x, place.y);
    model_.pickedNode = probe ? std::optional(probe->node) : std::nullopt;
}

void Application::copyCommand() {
    window_.copyToClipboard(renderCommandLine(model_.options));
    std::string text = "the command is in the clipboard";
    const std::vector<std::string> changes = model_.document->changes();
    for (std::size_t i = 0; i < changes.size(); ++i)
        text += (i == 0 ? "; it does not include these edits: " : ", ") + changes[i];
    model_.messages.push_back({Message::Kind::note, text});
}

void Application::changeDisplay() {
    if (sameDisplayOptions(appliedDisplayOptions_, model_.options.display)) return;
    guarded([this] { display_ = model_.color.displayTransform(model_.options.display); });
    appliedDisplayOptions_ = model_.options.display;
}

void Application::drawPicture(Motion motion) {
    if (!model_.document) {
        // Where no scene comes, the frames of a script show none.
        if (options_.scripted() && options_.scene.empty()) ++drawnFrames_;
        return;
    }
    changeDisplay();
    if (!options_.scripted()) model_.divisor = resolutionScale_.divisor(motion, Clock::now());
    const std::string key = pictureKey(model_);
    if (key == drawnPicture_ && !options_.scripted()) {
        if (motion == Motion::rests && isRefining()) refinePicture();
        return;
    }
    drawnPicture_ = key;
    guarded([&] {
        const candela::CameraView view = selectedView(model_);
        followView(model_, view);
        lightDocument(model_, view);
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
        if (model_.options.autoExposure) measureExposure();
        noteFirstPicture(model_, *viewport_.frame());
    });
}

bool Application::isRefining() const {
    return model_.document && viewport_.frame() != nullptr && !drawnPicture_.empty() && model_.divisor == 1 &&
           viewport_.samples() < wantedSamples(model_);
}

void Application::refinePicture() {
    try {
        drawSample(model_, viewport_, *display_);
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

void Application::probePointer() {
    model_.probe.reset();
    if (!model_.pointer) return;
    const glm::ivec2 pixel = viewport_.pixelAt(*model_.pointer);
    model_.probe = viewport_.frame()->probe(pixel.x, pixel.y);
    model_.probeDisplay = viewport_.displayValue(*model_.pointer);
}

void Application::writePicture(const std::filesystem::path& file) {
    drawnPicture_.clear();
    ::writePicture(model_, viewport_, *display_, file);
    model_.messages.push_back({Message::Kind::note, "wrote " + file.string()});
}
