// How the name of a scene selects a file and a plugin, and the errors for unknown names.
#include "expect_error.h"
#include "note_lines.h"
#include "temporary_folder.h"

#include <candela/import.h>

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

class ImportScene : public testing::Test {
  protected:
    const PluginRegistry plugins{{fs::path(CANDELA_TEST_FIXTURES) / "importers"}};
    TemporaryFolder folder;
};

TEST_F(ImportScene, EndingsIgnoreCase) {
    const fs::path file = folder.write("scene.LIST", "");
    EXPECT_EQ(importScene(plugins, file.string()).report.plugin, "list-reader");
}

TEST_F(ImportScene, SchemesIgnoreCase) {
    EXPECT_EQ(importScene(plugins, "ADD:all").report.plugin, "add-cases");
}

TEST_F(ImportScene, AnExistingFileHasPriorityOverAScheme) {
    folder.write("add:all.list", "");
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const ImportedScene imported = importScene(plugins, "add:all.list");
    fs::current_path(before);
    EXPECT_EQ(imported.report.plugin, "list-reader");
}

TEST_F(ImportScene, AnUnknownEndingListsTheKnownOnes) {
    const fs::path file = folder.write("room.XYZ", "");
    const std::string text =
        expectError([&] { importScene(plugins, file.string()); }, ErrorKind::unsupported,
                    "no plugin takes files ending in '.XYZ'; the plugins loaded take .list, .opt, .tri");
    EXPECT_EQ(text.find(file.string()), 0u) << text;
    EXPECT_NE(text.find("add:"), std::string::npos) << text;
}

TEST_F(ImportScene, NoEnding) {
    const fs::path file = folder.write("room", "");
    expectError([&] { importScene(plugins, file.string()); }, ErrorKind::unsupported, "has no ending");
}

TEST_F(ImportScene, UnknownScheme) {
    expectError([&] { importScene(plugins, "cloud:9"); }, ErrorKind::unsupported,
                "cloud:9: there is no such file, and no plugin takes the scheme 'cloud:'");
}

TEST_F(ImportScene, MissingFile) {
    expectError([&] { importScene(plugins, "nowhere/room.list"); }, ErrorKind::environment,
                "nowhere/room.list: there is no such file");
    expectError([&] { importScene(plugins, "c:room.list"); }, ErrorKind::environment,
                "c:room.list: there is no such file");
}

TEST_F(ImportScene, EmptyOrInvalidName) {
    expectError([&] { importScene(plugins, ""); }, ErrorKind::badInput, "the name of the scene is empty");
    expectError([&] { importScene(plugins, std::string("a\0b.list", 8)); }, ErrorKind::badInput,
                "a zero byte");
}

TEST_F(ImportScene, AFolderOrAPipe) {
    const fs::path inner = folder.path() / "folder.list";
    fs::create_directory(inner);
    expectError([&] { importScene(plugins, inner.string()); }, ErrorKind::badInput,
                "this is a folder, but a scene file was expected");
    const fs::path pipe = folder.path() / "pipe.list";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    expectError([&] { importScene(plugins, pipe.string()); }, ErrorKind::badInput,
                "this is not a regular file");
}

TEST_F(ImportScene, AQueryAfterAFileName) {
    const fs::path file = folder.write("scene.list", "");
    const auto notes = [&](const std::string& uri) { return noteLines(importScene(plugins, uri)); };
    EXPECT_EQ(notes(file.string()), Lines{});
    EXPECT_EQ(notes(file.string() + "?a=b:c/d"), Lines{"query: a=b:c/d"});
    EXPECT_EQ(notes(file.string() + "?"), Lines{"query: "});
}

TEST_F(ImportScene, AFileWithAQuestionMarkInItsName) {
    folder.write("what.list", "");
    const fs::path file = folder.write("what.list?now.list", "");
    EXPECT_TRUE(importScene(plugins, file.string()).report.notes.empty());
    EXPECT_EQ(noteLines(importScene(plugins, file.string() + "?q")), Lines{"query: q"});
}

TEST_F(ImportScene, AQueryAfterAMissingFile) {
    const std::string missing = (folder.path() / "gone.list").string() + "?q";
    expectError([&] { importScene(plugins, missing); }, ErrorKind::environment,
                missing + ": there is no such file");
    fs::create_directory(folder.path() / "folder.list");
    expectError([&] { importScene(plugins, (folder.path() / "folder.list").string() + "?q"); },
                ErrorKind::environment, "there is no such file");
    const fs::path unknown = folder.write("room.xyz", "");
    expectError([&] { importScene(plugins, unknown.string() + "?q"); }, ErrorKind::unsupported,
                "no plugin takes files ending in '.xyz'");
}

TEST_F(ImportScene, APluginOfVersion1_0AcceptsNoQuery) {
    const fs::path file = folder.write("scene.v10", "");
    EXPECT_EQ(importScene(plugins, file.string()).report.plugin, "first-version");
    expectError([&] { importScene(plugins, file.string() + "?q"); }, ErrorKind::unsupported,
                "the plugin 'first-version' takes no query, but '?q' follows the name");
}

}  // namespace
}  // namespace candela
