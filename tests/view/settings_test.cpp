// view.json: written and read back, invalid files, and removal.

#include "settings.h"
#include "common/shadow_stats.h"
#include "scoped_environment.h"
#include "temporary_folder.h"

#include <candela/error.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

using Json = nlohmann::json;

/// Not the default, where the library has shadows.
candela::Shadows changedShadows() {
    using enum candela::Shadows;
    return candela::hasShadows() && drawnShadows(SceneOptions{}.shadows) == off ? on : off;
}

ViewModel changedModel() {
    ViewModel model;
    model.windowSize = {801, 603};
    model.dockSizes.left = 20.5f;
    model.dockSizes.weights[2] = 3.0f;
    model.textScale = 1.25f;
    model.options.brdf = candela::BrdfModel::gltf;
    model.options.technique = candela::Technique::volumes;
    model.options.shadows = changedShadows();
    model.options.specularAntialiasing = false;
    model.options.sampling.count = 256;
    model.options.ocio = "/some/where.ocio";
    model.options.display = {"Display P3", "Raw", "a look", 0.0};
    model.options.subdivision.edgePixels = 3.5f;
    model.options.subdivision.maxLevel = 7;
    model.panels.scene = false;
    model.panels.probe = true;
    model.recent = {"/a b/c.gltf", "plaza:64"};
    return model;
}

class SettingsTest : public testing::Test {
  protected:
    ViewModel readWith(const ViewOptions& given) const {
        ViewModel model;
        static_cast<SceneOptions&>(model.options) = given;
        readSettings(folder.path(), given, model);
        return model;
    }
    ViewModel read() const { return readWith({}); }
    Json stored() const { return Json::parse(std::ifstream(folder / "view.json")); }
    void store(const std::string& text) const { folder.write("view.json", text); }

    /// A file of this text leaves one message that names it, and the defaults.
    void expectRefused(const std::string& text) const {
        store(text);
        const ViewModel model = read(), fresh;
        ASSERT_EQ(model.messages.size(), 1u) << text;
        EXPECT_NE(model.messages[0].text.find(folder / "view.json"), std::string::npos)
            << model.messages[0].text;
        EXPECT_EQ(model.options.width, fresh.options.width) << text;
        EXPECT_EQ(model.options.display.display, "") << text;
        EXPECT_EQ(model.options.ocio, std::nullopt) << text;
        EXPECT_EQ(model.panels.scene, fresh.panels.scene) << text;
        EXPECT_TRUE(model.recent.empty()) << text;
    }

    TemporaryFolder folder;
};

TEST_F(SettingsTest, RoundTrip) {
    writeSettings(folder.path(), changedModel());
    const ViewModel read = this->read(), written = changedModel();
    EXPECT_TRUE(read.messages.empty());
    EXPECT_EQ(read.options.width, 801);
    EXPECT_EQ(read.options.height, 603);
    EXPECT_EQ(read.options.brdf, candela::BrdfModel::gltf);
    EXPECT_EQ(read.options.technique, candela::Technique::volumes);
    EXPECT_EQ(read.options.shadows, changedShadows());
    EXPECT_FALSE(read.options.specularAntialiasing);
    EXPECT_EQ(read.options.sampling.count, 256u);
    EXPECT_EQ(read.options.ocio, "/some/where.ocio");
    EXPECT_EQ(read.options.display.display, "Display P3");
    EXPECT_EQ(read.options.display.view, "Raw");
    EXPECT_EQ(read.options.display.look, "a look");
    EXPECT_EQ(read.dockSizes.left, 20.5f);
    EXPECT_EQ(read.dockSizes.weights, written.dockSizes.weights);
    EXPECT_EQ(read.textScale, 1.25f);
    EXPECT_EQ(read.options.subdivision.edgePixels, 3.5f);
    EXPECT_EQ(read.options.subdivision.maxLevel, 7u);
    EXPECT_FALSE(read.panels.scene);
    EXPECT_TRUE(read.panels.probe);
    EXPECT_TRUE(read.panels.lights);
    EXPECT_EQ(read.recent, written.recent);
}

TEST_F(SettingsTest, AreOverriddenByTheCommandLine) {
    writeSettings(folder.path(), changedModel());
    ViewOptions given;
    given.sampling.count = 3;
    given.sizeGiven = given.displayGiven = given.drawingGiven = given.subdivisionGiven = true;
    const ViewModel read = readWith(given);
    EXPECT_EQ(read.options.width, 1280);
    EXPECT_EQ(read.options.brdf, candela::BrdfModel::course);
    EXPECT_EQ(read.options.shadows, SceneOptions{}.shadows);
    EXPECT_TRUE(read.options.specularAntialiasing);
    EXPECT_EQ(read.options.sampling.count, 3u);
    EXPECT_EQ(read.options.ocio, std::nullopt);
    EXPECT_EQ(read.options.display.view, "");
    EXPECT_EQ(read.options.subdivision.maxLevel, 5u);
    EXPECT_EQ(read.recent.size(), 2u) << "what no option gives is read";
}

TEST_F(SettingsTest, AreDefaultsWithoutAFile) {
    const ViewModel model = read();
    EXPECT_TRUE(model.messages.empty());
    EXPECT_EQ(model.options.width, 1280);
    readSettings({}, {}, const_cast<ViewModel&>(model));
    EXPECT_TRUE(model.messages.empty());
}

TEST_F(SettingsTest, WithErrorsAreNotUsed) {
    writeSettings(folder.path(), changedModel());
    const Json good = stored();
    expectRefused("");
    expectRefused("{");
    expectRefused("[]");
    expectRefused("null");
    expectRefused("{\"size\": 1e999}");
    expectRefused(std::string(100'000, '['));
    for (const auto& [key, value] : good.items()) {
        Json lacking = good;
        lacking.erase(key);
        expectRefused(lacking.dump());
        Json other = good;
        other[key] = Json::object({{"an", "object"}});
        expectRefused(other.dump());
    }
    Json unknown = good;
    unknown["brdf"] = "phong";
    expectRefused(unknown.dump());
}

TEST_F(SettingsTest, AreClampedToTheRangesOfTheOptions) {
    writeSettings(folder.path(), changedModel());
    Json extreme = stored();
    extreme["size"] = {-5, 1000000};
    extreme["docks"] = {-3.0, 1.0e9, 12.0};
    extreme["text_scale"] = 1000.0;
    extreme["subdivision_edge"] = -1.0;
    extreme["subdivision_max_level"] = 99;
    store(extreme.dump());
    const ViewModel model = read();
    EXPECT_TRUE(model.messages.empty());
    EXPECT_EQ(model.options.width, 1);
    EXPECT_EQ(model.options.height, 16384);
    EXPECT_GT(model.dockSizes.left, 0.0f);
    EXPECT_LE(model.dockSizes.right, 1000.0f);
    EXPECT_EQ(model.textScale, 3.0f);
    EXPECT_GT(model.options.subdivision.edgePixels, 0.0f);
    EXPECT_EQ(model.options.subdivision.maxLevel, candela::maxSubdivisionLevel);
}

TEST_F(SettingsTest, SupportNamesThatAreNotUtf8) {
    ViewModel model = changedModel();
    model.recent = {"latin-1 \xfc.gltf"};
    writeSettings(folder.path(), model);
    EXPECT_EQ(read().recent.size(), 1u);
}

TEST_F(SettingsTest, CreateTheirFolder) {
    writeSettings(folder.path() / "new" / "candela", changedModel());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "new" / "candela" / "view.json"));
}

TEST_F(SettingsTest, ThatCanNotBeWrittenAreAnErrorWithThePath) {
    folder.write("file", "no folder");
    try {
        writeSettings(folder.path() / "file", changedModel());
        FAIL() << "a file is no folder";
    } catch (const candela::Error& error) {
        EXPECT_NE(std::string(error.what()).find(folder / "file"), std::string::npos) << error.what();
    }
}

TEST_F(SettingsTest, AreRemoved) {
    writeSettings(folder.path(), changedModel());
    folder.write("view-layout.ini", "[Window]");
    folder.write("another", "stays");
    forgetSettings(folder.path());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"another"});
    forgetSettings(folder.path());
    forgetSettings({});
}

TEST_F(SettingsTest, AreInTheConfigFolderOfTheUser) {
    const ScopedEnvironment home("HOME", "/someone");
    {
        const ScopedEnvironment config("XDG_CONFIG_HOME", "/config");
        EXPECT_EQ(settingsFolder(), "/config/candela");
    }
    const ScopedEnvironment config("XDG_CONFIG_HOME", "");
    EXPECT_EQ(settingsFolder(), "/someone/.config/candela");
    const ScopedEnvironment nowhere("HOME", "");
    EXPECT_TRUE(settingsFolder().empty());
    EXPECT_TRUE(layoutFile({}).empty());
}

}  // namespace
