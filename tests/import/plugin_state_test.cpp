// Each state of a load report, with a file that causes it.
#include <candela/plugin_registry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace candela {
namespace {

namespace fs = std::filesystem;

const fs::path fixtures = CANDELA_TEST_FIXTURES;

class PluginStates : public testing::Test {
  protected:
    const PluginReport& reportOf(const std::string& file) const {
        const auto matches = [&](const PluginReport& report) {
            return report.file == fixtures / "states" / file;
        };
        const auto found = std::find_if(registry.reports().begin(), registry.reports().end(), matches);
        if (found == registry.reports().end()) throw std::runtime_error("no report for " + file);
        return *found;
    }

    void expectState(const std::string& file, PluginState state, const std::string& detail) const {
        const PluginReport& report = reportOf(file);
        EXPECT_STREQ(toString(report.state), toString(state)) << report.detail;
        EXPECT_NE(report.detail.find(detail), std::string::npos) << report.detail;
        EXPECT_EQ(report.detail.find('\n'), std::string::npos) << report.detail;
    }

    const PluginRegistry registry{{fixtures / "states"}};
};

TEST_F(PluginStates, Loaded) {
    expectState("loaded.so", PluginState::loaded, "");
    const PluginReport& report = reportOf("loaded.so");
    EXPECT_EQ(report.detail, "");
    EXPECT_EQ(report.name, "good");
    EXPECT_EQ(report.version, "1.0");
    EXPECT_EQ(report.description, "a fixture");
    EXPECT_EQ(report.extensions, std::vector<std::string>{"good"});
    EXPECT_EQ(report.schemes, std::vector<std::string>{"good"});
    ASSERT_NE(registry.importerForExtension("good"), nullptr);
    EXPECT_STREQ(registry.importerForExtension("good")->name, "good");
    EXPECT_EQ(registry.importerForScheme("good"), registry.importerForExtension("good"));
}

TEST_F(PluginStates, NotALibrary) {
    expectState("not_a_library.so", PluginState::notALibrary, "ELF");
}

TEST_F(PluginStates, NoEntryPoint) {
    expectState("no_entry_point.so", PluginState::noEntryPoint, "candela_plugin_query");
}

TEST_F(PluginStates, WrongVersion) {
    expectState("wrong_version.so", PluginState::wrongVersion, "it was built for version 2");
}

TEST_F(PluginStates, Refused) {
    expectState("refused.so", PluginState::refused, "returned NULL for version 1.6");
}

TEST_F(PluginStates, QueryThatThrowsIsRefused) {
    expectState("throwing_query.so", PluginState::refused, "threw an exception");
}

TEST_F(PluginStates, BadDescription) {
    expectState("bad_description.so", PluginState::badDescription, "its name 'Bad Name' is not made of");
    EXPECT_EQ(registry.importerForScheme("bad"), nullptr);
}

TEST_F(PluginStates, BadDescriptionOfAService) {
    expectState("no_service.so", PluginState::badDescription, "it offers no service");
    expectState("null_refine.so", PluginState::badDescription, "refine of its subdivider is NULL");
    EXPECT_FALSE(reportOf("null_refine.so").subdivides);
}

TEST(PluginState, DuplicateInALaterFolder) {
    const PluginRegistry registry({fixtures / "first", fixtures / "second"});
    ASSERT_GE(registry.reports().size(), 2u);
    EXPECT_EQ(registry.reports()[0].state, PluginState::loaded);
    const PluginReport& second = registry.reports()[1];
    EXPECT_EQ(second.state, PluginState::duplicate);
    EXPECT_NE(second.detail.find((fixtures / "first" / "same.so").string()), std::string::npos)
        << second.detail;
    EXPECT_STREQ(registry.importerForScheme("same")->version, "first");
}

TEST(PluginState, EveryStateHasAName) {
    EXPECT_STREQ(toString(PluginState::loaded), "loaded");
    EXPECT_STREQ(toString(PluginState::notALibrary), "not a library");
    EXPECT_STREQ(toString(PluginState::noEntryPoint), "no entry point");
    EXPECT_STREQ(toString(PluginState::wrongVersion), "wrong version");
    EXPECT_STREQ(toString(PluginState::refused), "refused");
    EXPECT_STREQ(toString(PluginState::badDescription), "bad description");
    EXPECT_STREQ(toString(PluginState::duplicate), "duplicate");
}

TEST(PluginState, ACopyOfTheRegistryKeepsPluginsLoaded) {
    const candela_plugin* plugin = nullptr;
    PluginRegistry copy = [&] {
        const PluginRegistry first({fixtures / "first"});
        plugin = first.importerForScheme("same");
        return PluginRegistry(first);
    }();
    EXPECT_EQ(copy.importerForScheme("same"), plugin);
    EXPECT_STREQ(plugin->version, "first");
}

}  // namespace
}  // namespace candela
