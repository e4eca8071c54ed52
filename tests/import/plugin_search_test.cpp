// The folders in which plugins are searched, and their order.
#include "expect_error.h"
#include "scoped_environment.h"
#include "temporary_folder.h"

#include "import/plugin_folders.h"

#include <candela/import.h>
#include <candela/plugin_registry.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

const fs::path fixtures = CANDELA_TEST_FIXTURES;
constexpr const char* pathVariable = "CANDELA_PLUGIN_PATH";

std::string versionOfSame(const PluginRegistry& registry) {
    const candela_plugin* plugin = registry.importerForScheme("same");
    return plugin ? plugin->version : "none";
}

TEST(PluginSearch, GivenFoldersComeBeforeTheEnvironment) {
    const ScopedEnvironment environment(pathVariable, (fixtures / "second").string());
    EXPECT_EQ(versionOfSame(PluginRegistry({fixtures / "first"})), "first");
    EXPECT_EQ(versionOfSame(PluginRegistry()), "second");
}

TEST(PluginSearch, GivenFoldersAreSearchedInOrder) {
    EXPECT_EQ(versionOfSame(PluginRegistry({fixtures / "third", fixtures / "first"})), "third");
    EXPECT_EQ(versionOfSame(PluginRegistry({fixtures / "first", fixtures / "third"})), "first");
}

TEST(PluginSearch, FoldersOfTheEnvironmentAreSearchedInOrder) {
    const std::string second = (fixtures / "second").string(), third = (fixtures / "third").string();
    const ScopedEnvironment environment(pathVariable, second + "::" + third + ":");
    const PluginRegistry registry;
    EXPECT_EQ(versionOfSame(registry), "second");
    EXPECT_NE(registry.importerForScheme("another"), nullptr);
}

TEST(PluginSearch, FilesOfAFolderAreSortedByName) {
    const PluginRegistry registry({fixtures / "states"});
    std::vector<std::string> names;
    for (const PluginReport& report : registry.reports())
        if (report.file.parent_path() == fixtures / "states") names.push_back(report.file.filename());
    EXPECT_EQ(names, (std::vector<std::string>{"bad_description.so", "loaded.so", "no_entry_point.so",
                                               "no_service.so", "not_a_library.so", "null_refine.so",
                                               "refused.so", "throwing_query.so", "wrong_version.so"}));
}

TEST(PluginSearch, ARepeatedFolderIsSearchedOnce) {
    TemporaryFolder folder;
    fs::create_directory_symlink(fixtures / "first", folder.path() / "link");
    const PluginRegistry registry({fixtures / "first", folder.path() / "link", fixtures / "first" / "."});
    int found = 0;
    for (const PluginReport& report : registry.reports())
        found += report.file.parent_path() == fixtures / "first";
    EXPECT_EQ(found, 1);
}

TEST(PluginSearch, OnlyRegularFilesEndingInSoGiveReports) {
    TemporaryFolder folder;
    folder.write("readme.txt", "no plugin");
    folder.write("versioned.so.1", "no plugin");
    folder.write("folder.so/inner.so", "not searched");
    fs::create_symlink("nowhere", folder.path() / "dangling.so");
    folder.write("text.so", "no plugin");
    EXPECT_EQ(pluginFilesIn(folder.path()), std::vector<fs::path>{folder.path() / "text.so"});
}

TEST(PluginSearch, AMissingFolderIsAnError) {
    expectError([] { PluginRegistry({"/nowhere/at/all"}); }, ErrorKind::environment,
                "/nowhere/at/all: there is no such plugin folder");
    const ScopedEnvironment environment(pathVariable, "/nowhere/else");
    expectError([] { PluginRegistry(); }, ErrorKind::environment, "named in CANDELA_PLUGIN_PATH");
}

TEST(PluginSearch, AFileInPlaceOfAFolderIsAnError) {
    TemporaryFolder folder;
    const fs::path file = folder.write("file", "");
    expectError([&] { PluginRegistry({file}); }, ErrorKind::environment, "a plugin folder was expected");
}

TEST(PluginSearch, StandardFoldersComeLastAndMayBeAbsent) {
    const PluginFolders folders{
        {fixtures / "third"}, {fixtures / "second"}, {"/nowhere", fixtures / "first"}};
    EXPECT_EQ(searchOrder(folders),
              (std::vector<fs::path>{fs::canonical(fixtures / "third"), fs::canonical(fixtures / "second"),
                                     fs::canonical(fixtures / "first")}));
}

TEST(PluginSearch, TheInstallFolderIsTheLast) {
    const PluginFolders folders = processPluginFolders({});
    ASSERT_EQ(folders.standard.size(), 2u);
    EXPECT_EQ(folders.standard[0].parent_path(), fs::read_symlink("/proc/self/exe").parent_path());
    EXPECT_EQ(folders.standard[0].filename(), "candela-plugins");
    EXPECT_TRUE(folders.standard[1].is_absolute());
}

std::string outputOf(const std::string& command) {
    FILE* pipe = ::popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("no shell");
    std::string output;
    char buffer[256];
    while (std::fgets(buffer, sizeof buffer, pipe)) output += buffer;
    EXPECT_EQ(::pclose(pipe), 0) << command;
    return output;
}

// The probe has a folder "candela-plugins" beside it, and is run in a working directory that contains plugins
// too.
TEST(PluginSearch, BesideTheLibraryButNeverInTheWorkingDirectory) {
    TemporaryFolder working;
    fs::copy_file(fixtures / "first" / "same.so", working.path() / "same.so");
    fs::create_directory(working.path() / "candela-plugins");
    fs::copy_file(fixtures / "first" / "same.so", working.path() / "candela-plugins" / "same.so");
    const fs::path probe = fixtures / "beside" / "import_beside_probe";
    const std::string change = "cd '" + working.path().string() + "' && ";
    for (const char* environment : {"CANDELA_PLUGIN_PATH= ", "CANDELA_PLUGIN_PATH=: ", ""}) {
        const std::string output = outputOf(change + environment + "'" + probe.string() + "'");
        const fs::path beside = fixtures / "beside" / "candela-plugins" / "beside.so";
        EXPECT_NE(output.find("loaded beside " + beside.string() + "\n"), std::string::npos) << output;
        EXPECT_EQ(output.find("same"), std::string::npos) << output;
    }
}

}  // namespace
}  // namespace candela
