#include "application.h"

#include "close_signals.h"
#include "common/output_file.h"
#include "common/program.h"
#include "common/scene_lights.h"
#include "common/scene_selection.h"
#include "light_saving.h"
#include "panels/panels.h"
#include "refinement.h"
#include "render_command_line.h"
#include "scene_lighting.h"
#include "settings.h"
#include "window.h"

#include <candela/error.h>

#include <imgui.h>
#include <glm/common.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <system_error>
#include <utility>

namespace {

/// Thickness of the line around what is picked, in units of ImGui.
constexpr float outlinePoints = 2.0f;
constexpr double longestStep = 0.25;  ///< The maximum advance of time between two frames, seconds.

ViewModel modelOf(const ViewOptions& options, const std::filesystem::path& folder) {
    ViewModel model;
    model.options = options;
    // A script draws one sample unless it asks for more.
    if (options.scripted() && !options.sampling.count) model.options.sampling.count = 1;
    if (!options.scripted()) readSettings(folder, options, model);
    return model;
}

/// Whether anything is asked for that depends on the picture and its light.
bool readsPicture(const Requests& requests) {
    return requests.pick || requests.measureExposure || requests.countPairs || requests.savePng ||
           requests.saveExr || requests.saveLights || requests.copyCommand;
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
    listPlugins();
    checkOutputs(options);
    chooseFirstColor();
    if (!model_.options.scene.empty()) open(model_.options.scene);
}

void Application::listPlugins() {
    std::vector<std::string> schemes;
    for (const candela::PluginReport& report : plugins_.reports()) {
        for (const std::string& ending : report.extensions) model_.sceneEndings.push_back("." + ending);
        schemes.insert(schemes.end(), report.schemes.begin(), report.schemes.end());
    }
    model_.examples = exampleScenes(schemes);
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
    if (!options_.screenshot) return;
    // That of the window is as small as the panels leave it.
    model_.options.width = options_.width;
    model_.options.height = options_.height;
    writePicture(*options_.screenshot);
}

bool Application::timeAdvances() const {
    return model_.playing && model_.document && model_.document->animated();
}

/// Panels settle before the loop waits for events; full resolution returns after a short delay.
Window::Sleep Application::sleep() const {
    if (options_.scripted()) return model_.loading ? Window::Sleep::briefly : Window::Sleep::none;
    if (timeAdvances() || motion_ == Motion::moves || settling_ > 0 || isRefining() ||
        window_.hasPendingInput())
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
    const bool active = window_.takeActivity() || window_.hasPendingInput();
    settling_ = active ? settlingFrames : std::max(settling_ - 1, 0);
    const glm::ivec2 size = window_.framebufferSize();
    if (size.x < 1 || size.y < 1) return;  // minimised
    model_.windowSize = size;
    for (const std::string& file : window_.takeDropped())
        if (!takeAsEnvironment(model_, file)) model_.requests.open = file;
    takeLoaded();
    guarded([this] { takeEnvironment(model_, environments_); });
    if (shaders_.takeChange()) reloadShaders();
    advanceTime();
    window_.beginPanels(model_.textScale);
    placePicture();
    drawPanels(model_);
    recordEdits();
    motion_ = interact(model_, window_.pixelRatio());
    serveRequests();
    drawPicture(timeAdvances() ? Motion::moves : motion_);
    serveReadings();
    viewport_.show(size, model_.pictureCorner, model_.document ? pictureSize_ : glm::ivec2(0));
    if (showsLeftSide()) beside_->showLeft(size, model_.pictureCorner, pictureSize_, lineColumn());
    outlinePicked();
    window_.endPanels();
    if (options_.windowScreenshot && ended()) writeWindowPicture(*options_.windowScreenshot, size);
    window_.swap();
}

/// The picture takes what the panels leave free. That of a script has the size that it asks for, even where
/// the desktop gives its window another one.
void Application::placePicture() {
    layPanels(model_);
    const bool wholeWindow = options_.scripted() && !options_.windowScreenshot;
    const float ratio = window_.pixelRatio();
    const PanelPlace& place = model_.layout.picture;
    const glm::ivec2 corner(glm::round(place.position * ratio)),
        end(glm::round((place.position + place.size) * ratio));
    model_.pictureCorner = wholeWindow ? glm::ivec2(0) : corner;
    pictureSize_ = wholeWindow ? model_.windowSize : glm::max(end - corner, 1);
    if (wholeWindow) return;
    model_.options.width = pictureSize_.x;
    model_.options.height = pictureSize_.y;
}

/// What is done from the press of a button to its release, or while a field is edited, is one step.
void Application::recordEdits() {
    if (!model_.document) return;
    EditHistory& history = model_.document->history();
    history.watch(model_.options);
    if (!ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) history.endStep();
}

void Application::outlinePicked() {
    if (!model_.document || !model_.pickedNode || !model_.guides.outline || viewport_.frame() == nullptr)
        return;
    Document& document = *model_.document;
    if (document.visibility(*model_.pickedNode) == candela::GpuScene::Visibility::hidden) return;
    const glm::ivec2 corner(model_.pictureCorner.x,
                            model_.windowSize.y - model_.pictureCorner.y - pictureSize_.y);
    guarded([&] {
        outline_.draw({document.scene(), *model_.pickedNode, document.time(), document.revision(),
                       plugins_.subdivider()},
                      selectedView(model_), {corner, pictureSize_}, outlinePoints * window_.pixelRatio());
    });
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
    if (model_.requests.quit) window_.close();
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
        if (readsPicture(requests)) lightRightSide();
        if (model_.panels.probe) probePointer();
        if (requests.pick) pick(*requests.pick);
        if (requests.measureExposure) measureExposure();
        if (requests.countPairs) model_.pairs = viewport_.frame()->countPairs();
    });
    if (requests.savePng) guarded([&] { writePicture(*requests.savePng); });
    if (requests.saveExr) guarded([&] { writePicture(*requests.saveExr); });
    if (requests.saveLights) guarded([&] { saveLights(model_, *requests.saveLights); });
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
    drawnLeft_.clear();
    if (!model_.document) return;
    // Steps name displays and views of the old config.
    model_.document->history().clear();
    model_.document->history().rebase(model_.options);
}

void Application::pick(const glm::ivec2& pixel) {
    const glm::ivec2 place = viewport_.pixelAt(pixel);
    const auto probe = viewport_.frame()->probe(place.x, place.y);
    model_.pickedNode = probe ? std::optional(probe->node) : std::nullopt;
    model_.pickedLight.reset();
}

void Application::copyCommand() {
    window_.copyToClipboard(renderCommandLine(optionsWithLights(model_)));
    model_.messages.push_back(
        {Message::Kind::note, "the command is in the clipboard" + textOfOtherEdits(*model_.document)});
}

void Application::probePointer() {
    model_.probe.reset();
    if (!model_.pointer) return;
    const glm::ivec2 pixel = viewport_.pixelAt(*model_.pointer);
    const Viewport& viewport = viewportAt(*model_.pointer);
    model_.probe = viewport.frame()->probe(pixel.x, pixel.y);
    model_.probeDisplay = viewport.displayValue(*model_.pointer);
}

void Application::writePicture(const std::filesystem::path& file) {
    drawnPicture_.clear();
    ::writePicture(model_, viewport_, *display_, file);
    model_.messages.push_back({Message::Kind::note, "wrote " + file.string()});
}
