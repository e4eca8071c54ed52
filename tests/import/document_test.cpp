// The example of docs/plugins.md: the page has the source that is compiled, and it works as the page says.
#include "expect_error.h"
#include "temporary_folder.h"

#include <candela/import.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace candela {
namespace {

namespace fs = std::filesystem;

const fs::path documents = CANDELA_TEST_DOCUMENTS;

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(PluginDocument, HasTheSourceOfTheExample) {
    const std::string example = contentOf(documents / "examples" / "triangle_importer.cpp");
    const std::string page = contentOf(documents / "plugins.md");
    EXPECT_NE(page.find("```cpp\n" + example + "```\n"), std::string::npos)
        << "docs/plugins.md and docs/examples/triangle_importer.cpp differ";
}

TEST(PluginDocument, TheExampleReadsTriangles) {
    const PluginRegistry plugins({fs::path(CANDELA_TEST_FIXTURES) / "importers"});
    TemporaryFolder folder;
    const fs::path file = folder.write("two.tri", "0 0 0  1 0 0  0 1 0\n0 0 1  1 0 1  0 1 1\n");
    const Scene scene = importScene(plugins, file.string()).scene;
    EXPECT_EQ(triangleCount(scene), 2u);
    EXPECT_EQ(scene.meshes.at(0).normals.at(0), glm::vec3(0, 0, 1));

    expectError([&] { importScene(plugins, file.string() + "?a"); }, ErrorKind::badInput, "query: ");

    const fs::path broken = folder.write("broken.tri", "0 0 0  1 0 0  0 one 0\n");
    const std::string text =
        expectError([&] { importScene(plugins, broken.string()); }, ErrorKind::badInput, "");
    EXPECT_EQ(text, broken.string() + ": after number 7: nine numbers a triangle were expected");
}

TEST(ErrorDocument, ExplainsEveryExitCode) {
    const std::string page = contentOf(documents / "errors.md");
    for (const char* code : {"| 0 |", "| 1 |", "| 2 |"})
        EXPECT_NE(page.find(code), std::string::npos) << code;
}

}  // namespace
}  // namespace candela
