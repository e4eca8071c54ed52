#include <candela/color.h>
#include <candela/error.h>
#include <candela/nearest_name.h>

#include "color/display_encoding.h"
#include "color/display_transform.h"
#include "color/ocio.h"
#include "color/working_space.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace candela {

struct ColorConfig::State {
    std::string source;
    OCIO::ConstConfigRcPtr config;
    WorkingSpace working;
};

namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

/// The name as the config writes it: OpenColorIO tells displays, views and looks apart without regard to
/// case.
const std::string* findName(const std::vector<std::string>& names, const std::string& wanted) {
    const auto lower = [](std::string text) {
        for (char& c : text)
            if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
        return text;
    };
    for (const std::string& name : names)
        if (lower(name) == lower(wanted)) return &name;
    return nullptr;
}

/// The names in "first, +second, -third": OpenColorIO's way of writing several looks (| parts alternatives).
std::vector<std::string> lookNames(const std::string& looks) {
    constexpr const char* separators = ",:|";
    std::vector<std::string> names;
    for (std::size_t start = 0; start <= looks.size();) {
        const std::size_t end = std::min(looks.find_first_of(separators, start), looks.size());
        const std::size_t first = std::min(looks.find_first_not_of(" +-", start), end);
        std::string name = looks.substr(first, end - first);
        name.erase(name.find_last_not_of(' ') + 1);
        names.push_back(name);
        start = end + 1;
    }
    return names;
}

OCIO::ConstProcessorRcPtr makeProcessor(const OCIO::ConstConfigRcPtr& config, const std::string& from,
                                        const DisplayOptions& options) {
    const auto displayView = OCIO::DisplayViewTransform::Create();
    displayView->setSrc(from.c_str());
    displayView->setDisplay(options.display.c_str());
    displayView->setView(options.view.c_str());
    const auto pipeline = OCIO::LegacyViewingPipeline::Create();
    pipeline->setDisplayViewTransform(displayView);
    // Without a look that the user names, those that the config gives to the view apply.
    pipeline->setLooksOverrideEnabled(!options.look.empty());
    pipeline->setLooksOverride(options.look.c_str());
    return pipeline->getProcessor(config);
}

}  // namespace

ColorConfig::ColorConfig(std::shared_ptr<const State> state) : state_(std::move(state)) {}

ColorConfig ColorConfig::builtIn() {
    State state{"built-in", builtInConfig(), {}};
    state.working = findWorkingSpace(state.config, state.source);
    return ColorConfig(std::make_shared<const State>(std::move(state)));
}

ColorConfig ColorConfig::load(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error) || std::filesystem::is_directory(path, error))
        throw Error(ErrorKind::badInput, path, "there is no such file; an OpenColorIO config was expected");
    try {
        State state{path, OCIO::Config::CreateFromFile(path.c_str()), {}};
        state.working = findWorkingSpace(state.config, path);
        if (state.config->getNumDisplays() == 0)
            throw Error(ErrorKind::badInput, path, "the config has no display");
        return ColorConfig(std::make_shared<const State>(std::move(state)));
    } catch (const OCIO::Exception& e) {
        throw Error(ErrorKind::badInput, path, "not a usable OpenColorIO config: " + oneLine(e.what()));
    }
}

ColorConfig ColorConfig::choose(const std::optional<std::string>& path) {
    if (path) return load(*path);
    const char* environment = std::getenv("OCIO");
    if (!environment || !*environment) return builtIn();
    try {
        return load(environment);
    } catch (const Error& e) {
        const std::string text = std::string(e.what()).substr(e.path().size() + 2);
        throw Error(e.kind(), e.path(), text + " (the environment's $OCIO names this file)");
    }
}

const std::string& ColorConfig::source() const {
    return state_->source;
}

std::vector<std::string> ColorConfig::displays() const {
    std::vector<std::string> names;
    for (int i = 0; i < state_->config->getNumDisplays(); ++i)
        names.emplace_back(state_->config->getDisplay(i));
    return names;
}

std::vector<std::string> ColorConfig::views(const std::string& display) const {
    const std::vector<std::string> all = displays();
    const std::string* known = findName(all, display);
    if (!known)
        throw Error(ErrorKind::badInput, source(),
                    "there is no display '" + display + "'; the config has: " + listed(all) +
                        didYouMean(display, all));
    std::vector<std::string> names;
    for (int i = 0; i < state_->config->getNumViews(known->c_str()); ++i)
        names.emplace_back(state_->config->getView(known->c_str(), i));
    return names;
}

std::vector<std::string> ColorConfig::looks() const {
    std::vector<std::string> names;
    for (int i = 0; i < state_->config->getNumLooks(); ++i)
        names.emplace_back(state_->config->getLookNameByIndex(i));
    return names;
}

std::string ColorConfig::defaultDisplay() const {
    return state_->config->getDefaultDisplay();
}

std::string ColorConfig::defaultView(const std::string& display) const {
    const std::vector<std::string> all = views(display);
    // A config may say which views suit which space.
    const std::string suited = state_->config->getDefaultView(display.c_str(), state_->working.name.c_str());
    if (!suited.empty()) return suited;
    return state_->config->getDefaultView(display.c_str());
}

std::string ColorConfig::workingSpace() const {
    return state_->working.name;
}
glm::dmat3 ColorConfig::workingFromRec709() const {
    return state_->working.fromRec709;
}

glm::vec3 ColorConfig::luminanceWeights() const {
    // The middle row of XYZ from linear Rec.709 (ITU-R BT.709-6).
    const glm::dvec3 ofRec709(0.2126, 0.7152, 0.0722);
    return glm::vec3(ofRec709 * glm::inverse(workingFromRec709()));
}
Chromaticities ColorConfig::chromaticities() const {
    return state_->working.chromaticities;
}
std::vector<std::string> ColorConfig::notes() const {
    return state_->working.notes;
}

DisplayTransform ColorConfig::displayTransform(const DisplayOptions& options) const {
    if (!(std::abs(options.exposure) <= 100.0))
        throw Error(
            ErrorKind::badInput, "",
            "an exposure of " + std::to_string(options.exposure) + " stops; -100 to 100 was expected");
    auto state = std::make_shared<DisplayTransform::State>();
    state->source = source();
    DisplayOptions& chosen = state->options = options;

    if (chosen.display.empty()) chosen.display = defaultDisplay();
    const std::vector<std::string> allViews = views(chosen.display);
    chosen.display = *findName(displays(), chosen.display);
    if (chosen.view.empty()) chosen.view = defaultView(chosen.display);
    const std::string* view = findName(allViews, chosen.view);
    if (!view)
        throw Error(ErrorKind::badInput, source(),
                    "the display '" + chosen.display + "' has no view '" + chosen.view +
                        "'; it has: " + listed(allViews) + didYouMean(chosen.view, allViews));
    chosen.view = *view;
    if (!chosen.look.empty())
        for (const std::string& look : lookNames(chosen.look))
            if (!findName(looks(), look))
                throw Error(ErrorKind::badInput, source(),
                            "there is no look '" + look + "'; the config has: " + listed(looks()) +
                                didYouMean(look, looks()));
    try {
        state->processor = makeProcessor(state_->config, state_->working.name, chosen);
        state->cpu = state->processor->getOptimizedCPUProcessor(ocioPrecision);
        state->encoding = findDisplayEncoding(state_->config, chosen.display, chosen.view);
    } catch (const OCIO::Exception& e) {
        throw Error(ErrorKind::badInput, source(),
                    "display '" + chosen.display + "', view '" + chosen.view + "': " + oneLine(e.what()));
    }
    return DisplayTransform(std::move(state));
}

}  // namespace candela
