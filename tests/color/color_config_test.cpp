#include <candela/color.h>

#include "temporary_config.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <optional>

namespace candela {
namespace {

using test::messageOf;
using test::TemporaryConfig;

const std::string lutConfig = CANDELA_TEST_DATA "/config/luts.ocio";

/// Sets $OCIO during its lifetime, then restores it.
class OcioVariable {
  public:
    explicit OcioVariable(const char* value) {
        if (const char* old = std::getenv("OCIO")) old_ = old;
        if (value)
            setenv("OCIO", value, 1);
        else
            unsetenv("OCIO");
    }
    OcioVariable(const OcioVariable&) = delete;
    OcioVariable& operator=(const OcioVariable&) = delete;
    ~OcioVariable() {
        if (old_)
            setenv("OCIO", old_->c_str(), 1);
        else
            unsetenv("OCIO");
    }

  private:
    std::optional<std::string> old_;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(ColorConfig, pathThenVariableThenBuiltIn) {
    const TemporaryConfig other(test::configText("  scene_linear: lin\n", "  - !<ColorSpace> {name: lin}\n"));
    {
        const OcioVariable variable(nullptr);
        EXPECT_EQ(ColorConfig::choose(std::nullopt).source(), "built-in");
        EXPECT_EQ(ColorConfig::choose(lutConfig).source(), lutConfig);
    }
    {
        const OcioVariable variable("");
        EXPECT_EQ(ColorConfig::choose(std::nullopt).source(), "built-in") << "an empty $OCIO is none";
    }
    const OcioVariable variable(lutConfig.c_str());
    EXPECT_EQ(ColorConfig::choose(std::nullopt).source(), lutConfig);
    EXPECT_EQ(ColorConfig::choose(other.path()).source(), other.path());
}

TEST(ColorConfig, brokenVariableIsAnErrorAndNotIgnored) {
    const OcioVariable variable("/nowhere/config.ocio");
    const std::string message = messageOf([] { ColorConfig::choose(std::nullopt); });
    EXPECT_TRUE(contains(message, "/nowhere/config.ocio")) << message;
    EXPECT_TRUE(contains(message, "$OCIO")) << message;
}

TEST(ColorConfig, missingFileFolderAndInvalidFile) {
    EXPECT_TRUE(contains(messageOf([] { ColorConfig::load("/nowhere/config.ocio"); }),
                         "/nowhere/config.ocio: there is no such file"));
    EXPECT_TRUE(contains(messageOf([] { ColorConfig::load(CANDELA_TEST_DATA); }), "no such file"));
    EXPECT_TRUE(contains(messageOf([] { ColorConfig::load(""); }), "config"));
    for (const char* text : {"", "ocio_profile_version: [", "{}", "ocio_profile_version: 99\n", "\x89PNG\r\n",
                             "ocio_profile_version: 2\nroles: 7\n"}) {
        const TemporaryConfig file(text);
        const std::string message = messageOf([&] { ColorConfig::load(file.path()); });
        EXPECT_EQ(message.find(file.path()), 0u) << message;
    }
}

TEST(ColorConfig, listsDisplaysViewsAndLooks) {
    const ColorConfig config = ColorConfig::load(lutConfig);
    EXPECT_EQ(config.displays(), (std::vector<std::string>{"Monitor", "Projector"}));
    EXPECT_EQ(config.views("Projector"), (std::vector<std::string>{"Mono"}));
    EXPECT_EQ(config.views("projector"), (std::vector<std::string>{"Mono"})) << "names ignore case";
    EXPECT_EQ(config.looks(), (std::vector<std::string>{"warm", "faded"}));
    EXPECT_EQ(config.defaultDisplay(), "Monitor");
    EXPECT_EQ(config.defaultView("Monitor"), "Mono");
}

TEST(ColorConfig, unknownNamesListThoseThatExist) {
    const ColorConfig config = ColorConfig::load(lutConfig);
    EXPECT_EQ(messageOf([&] { config.views("foo"); }),
              lutConfig + ": there is no display 'foo'; the config has: Monitor, Projector");
    EXPECT_EQ(messageOf([&] { config.defaultView("foo"); }),
              lutConfig + ": there is no display 'foo'; the config has: Monitor, Projector");
    EXPECT_EQ(messageOf([&] {
                  config.displayTransform({"foo", "", "", 0.0});
              }),
              lutConfig + ": there is no display 'foo'; the config has: Monitor, Projector");
    EXPECT_EQ(messageOf([&] {
                  config.displayTransform({"Projector", "RGB", "", 0.0});
              }),
              lutConfig + ": the display 'Projector' has no view 'RGB'; it has: Mono");
    EXPECT_EQ(messageOf([&] {
                  config.displayTransform({"", "", "cold", 0.0});
              }),
              lutConfig + ": there is no look 'cold'; the config has: warm, faded");
    EXPECT_EQ(messageOf([&] {
                  config.displayTransform({"", "", "warm, cold", 0.0});
              }),
              lutConfig + ": there is no look 'cold'; the config has: warm, faded");
    EXPECT_EQ(messageOf([] {
                  ColorConfig::builtIn().displayTransform({"", "", "cold", 0.0});
              }),
              "built-in: there is no look 'cold'; the config has: none");
}

TEST(ColorConfig, optionsAreCompletedAndSpelledAsInTheConfig) {
    const DisplayTransform whole = ColorConfig::load(lutConfig).displayTransform({});
    EXPECT_EQ(whole.options().display, "Monitor");
    EXPECT_EQ(whole.options().view, "Mono");
    EXPECT_EQ(whole.options().look, "");
    EXPECT_EQ(ColorConfig::builtIn().displayTransform({"SRGB", "raw", "", 0.0}).options().view, "Raw");
    EXPECT_NO_THROW(ColorConfig::load(lutConfig).displayTransform({"monitor", "mono", "WARM", 0.0}));
}

TEST(ColorConfig, missingTableIsReportedWhenItsViewIsRequested) {
    const ColorConfig config = ColorConfig::load(lutConfig);
    const std::string message = messageOf([&] { config.displayTransform({"Monitor", "Missing", "", 0.0}); });
    EXPECT_TRUE(contains(message, lutConfig + ": display 'Monitor', view 'Missing': ")) << message;
    EXPECT_TRUE(contains(message, "nowhere.spi1d")) << message;
}

TEST(ColorConfig, exposureMustBeANumberOfStops) {
    const ColorConfig config = ColorConfig::builtIn();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double exposure : {infinity, -infinity, std::nan(""), 101.0, -101.0})
        EXPECT_TRUE(contains(messageOf([&] { config.displayTransform({"", "", "", exposure}); }), "stops"));
}

TEST(ColorConfig, aConfigWithoutDisplaysIsRefused) {
    const TemporaryConfig file(
        "ocio_profile_version: 2\nroles: {default: lin, scene_linear: lin}\n"
        "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
        "colorspaces:\n  - !<ColorSpace> {name: lin}\n");
    EXPECT_TRUE(contains(messageOf([&] { ColorConfig::load(file.path()); }), "display"));
}

}  // namespace
}  // namespace candela
