#include "render_command_line.h"

#include "common/scene_environment.h"
#include "common/shadow_stats.h"
#include "view_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <string_view>

namespace {

/// The shortest text that is read back as the same number.
template <typename Number>
std::string numberText(Number number) {
    std::array<char, 64> buffer;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return std::string(buffer.data(), end);
}

std::string pointText(const glm::dvec3& point) {
    return numberText(point.x) + "," + numberText(point.y) + "," + numberText(point.z);
}

bool needsNoQuotes(char c) {
    constexpr std::string_view plain = "-_./:,=+@%";
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           plain.find(c) != plain.npos;
}

std::string quoted(const std::string& word) {
    if (!word.empty() && std::ranges::all_of(word, needsNoQuotes)) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

bool isNumeral(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

/// A file whose name begins with a dash is reached by its folder.
std::string sceneWord(const std::string& scene) {
    return scene.starts_with('-') ? "./" + scene : scene;
}

class Command {
  public:
    void word(const std::string& text) { text_ += (text_.empty() ? "" : " ") + quoted(text); }
    void flag(const char* name) { text_ += " " + std::string(name); }
    void option(const char* name, const std::string& value) {
        text_ += " " + std::string(name);
        // A name may look like an option; a negative number does not.
        const bool likeOption = value.size() > 1 && value[0] == '-' && !isNumeral(value[1]);
        text_ += (likeOption ? "=" : " ") + quoted(value);
    }
    void optionUnlessEmpty(const char* name, const std::string& value) {
        if (!value.empty()) option(name, value);
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

std::string scatterText(const candela::LightScatter& options) {
    std::string text = std::to_string(options.count);
    if (options.range) text += "," + numberText(*options.range);
    if (options.range && options.candela) text += "," + numberText(*options.candela);
    if (options.range && options.candela && options.seed != 1) text += "," + std::to_string(options.seed);
    return text;
}

std::string debugViewText(const DebugViewOptions& options) {
    std::string text = candela::toString(options.view);
    if (options.overlays.wireframe) text += ",wireframe";
    if (options.overlays.cage) text += ",cage";
    return text;
}

void addCamera(Command& command, const SceneOptions& options) {
    if (options.eye) {
        command.option("--eye", pointText(options.eye->eye));
        command.option("--target", pointText(options.eye->target));
    } else if (options.camera) {
        command.option("--camera", *options.camera);
    }
    if (options.verticalFov)
        command.option("--fov", numberText(*options.verticalFov * 180.0 / std::numbers::pi));
    if (options.orthographicHeight) command.option("--ortho", numberText(*options.orthographicHeight));
}

/// A debug view has one sample anyway.
void addSampling(Command& command, const SceneOptions& options) {
    const SamplingOptions& sampling = options.sampling;
    const SamplingOptions standard;
    if (options.debug.isDefault())
        command.option("--samples", std::to_string(sampling.count.value_or(defaultViewSamples)));
    if (sampling.fNumber) {
        command.option("--aperture", numberText(*sampling.fNumber));
        command.option("--focus", numberText(*sampling.focusDistance));
        if (sampling.blades != 0) command.option("--blades", std::to_string(sampling.blades));
    }
    if (sampling.shutter != standard.shutter) command.option("--shutter", numberText(sampling.shutter));
    if (sampling.framesPerSecond != standard.framesPerSecond)
        command.option("--fps", numberText(sampling.framesPerSecond));
}

void addSubdivision(Command& command, const candela::SubdivisionSettings& settings) {
    const candela::SubdivisionSettings standard;
    if (settings.level) command.option("--subdivision-level", std::to_string(*settings.level));
    if (settings.edgePixels != standard.edgePixels)
        command.option("--subdivision-edge", numberText(settings.edgePixels));
    if (settings.maxLevel != standard.maxLevel)
        command.option("--subdivision-max-level", std::to_string(settings.maxLevel));
}

}  // namespace

std::string renderCommandLine(const SceneOptions& options) {
    Command command;
    command.word("candela-render");
    command.word(sceneWord(options.scene));
    command.option("--size", std::to_string(options.width) + "x" + std::to_string(options.height));
    addCamera(command, options);
    addSampling(command, options);
    if (options.time != 0.0) command.option("--time", numberText(options.time));
    if (options.animation) command.option("--animation", *options.animation);
    if (options.variant) command.option("--variant", *options.variant);
    if (options.repeatAnimations) command.flag("--loop");
    if (options.lights) command.option("--lights", *options.lights);
    if (options.scatter) command.option("--scatter-lights", scatterText(*options.scatter));
    if (options.strictness == candela::Strictness::strict) command.flag("--strict");
    for (const std::filesystem::path& folder : options.pluginFolders)
        command.option("--plugin-path", folder.string());
    if (options.defaultLights != DefaultLights::automatic)
        command.option("--default-lights", toString(options.defaultLights));
    if (options.environment.source != EnvironmentOption::Source::own)
        command.option("--environment", toString(options.environment));
    if (options.environmentRays != SceneOptions{}.environmentRays)
        command.option("--environment-rays", std::to_string(options.environmentRays));
    if (options.background) command.option("--background", *options.background ? "on" : "off");
    command.option("--brdf", candela::toString(options.brdf));
    command.option("--technique", candela::toString(options.technique));
    if (options.tileBackend != candela::TileBackend::automatic)
        command.option("--tiles", candela::toString(options.tileBackend));
    if (drawnShadows(options.shadows) != drawnShadows(SceneOptions{}.shadows))
        command.option("--shadows", candela::toString(options.shadows));
    if (options.specularAntialiasing != SceneOptions{}.specularAntialiasing)
        command.option("--specular-aa", options.specularAntialiasing ? "on" : "off");
    if (options.layers != SceneOptions{}.layers) command.option("--layers", std::to_string(options.layers));
    if (options.pointSize != SceneOptions{}.pointSize)
        command.option("--point-size", numberText(options.pointSize));
    if (options.lineWidth != SceneOptions{}.lineWidth)
        command.option("--line-width", numberText(options.lineWidth));
    if (options.rangeLoss != candela::GpuSceneOptions{}.rangeLoss)
        command.option("--range-loss", numberText(options.rangeLoss));
    if (!options.debug.isDefault()) command.option("--show", debugViewText(options.debug));
    addSubdivision(command, options.subdivision);
    if (options.vertexEvaluator != candela::VertexEvaluator::automatic)
        command.option("--subdivision-evaluator", candela::toString(options.vertexEvaluator));
    if (options.ocio) command.option("--ocio", *options.ocio);
    command.optionUnlessEmpty("--display", options.display.display);
    command.optionUnlessEmpty("--view", options.display.view);
    command.optionUnlessEmpty("--look", options.display.look);
    if (options.autoExposure) {
        command.option("--exposure", "auto");
    } else if (options.display.exposure != 0.0) {
        command.option("--exposure", numberText(options.display.exposure));
    }
    if (options.threads != 0) command.option("--threads", std::to_string(options.threads));
    command.option("-o", "candela.png");
    return command.text();
}
