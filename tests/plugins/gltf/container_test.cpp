#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "loading.h"

namespace candela_test {
namespace {

void expectTriangle(const candela::ImportedScene& imported) {
    ASSERT_EQ(imported.scene.meshes.size(), 1u);
    EXPECT_EQ(imported.scene.meshes[0].positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(Container, gltfWithADataUri) {
    expectTriangle(load(triangleFile()));
}

TEST(Container, glb) {
    expectTriangle(loadGlb(triangleFile().glb()));
}

TEST(Container, theFormatIsDetectedByContent) {
    const TemporaryFolder folder;
    expectTriangle(loadPath(folder.write("a.gltf", triangleFile().glb())));
    expectTriangle(loadPath(folder.write("b.glb", triangleFile().text())));
}

TEST(Container, glbWithAnExternalBuffer) {
    const TemporaryFolder folder;
    folder.write("data.bin", triangleFile().binary());
    expectTriangle(
        loadPath(folder.write("a.glb", makeGlb(triangleFile().textWithBufferFile("data.bin"), {}))));
}

TEST(Container, chunksAfterTheSecondAreSkipped) {
    Bytes glb = triangleFile().glb();
    const Bytes extra{4, 0, 0, 0, 'X', 'T', 'R', 'A', 1, 2, 3, 4};
    glb.insert(glb.end(), extra.begin(), extra.end());
    const auto length = static_cast<std::uint32_t>(glb.size());
    std::memcpy(&glb[8], &length, sizeof length);
    expectTriangle(loadGlb(glb));
}

TEST(Container, byteOrderMarkIsSkipped) {
    expectTriangle(loadText("\xEF\xBB\xBF" + triangleFile().text()));
}

TEST(Container, everyDataUriForm) {
    const GltfFile file = triangleFile();
    std::string percent;
    for (const std::uint8_t byte : file.binary()) {
        char text[4];
        std::snprintf(text, sizeof text, "%%%02x", static_cast<unsigned>(byte));
        percent += text;
    }
    std::string unpadded = base64(file.binary());
    while (unpadded.back() == '=') unpadded.pop_back();
    expectTriangle(loadText(file.textWithBufferFile("data:," + percent)));
    expectTriangle(loadText(file.textWithBufferFile("data:;base64," + unpadded)));
    expectTriangle(loadText(file.textWithBufferFile("data:application/gltf-buffer;base64," + unpadded)));
}

TEST(Container, aBufferFileMayBeLongerThanItsBuffer) {
    const TemporaryFolder folder;
    Bytes bytes = triangleFile().binary();
    bytes.resize(bytes.size() + 100);
    folder.write("data.bin", bytes);
    expectTriangle(loadPath(folder.write("a.gltf", triangleFile().textWithBufferFile("data.bin"))));
}

TEST(Container, integersMayHaveADecimalPoint) {
    GltfFile file = triangleFile();
    file.set("scene", "0.0");
    file.add("scenes", R"({"nodes":[0.0]})");
    expectTriangle(load(file));
}

TEST(Container, anEmptyDocumentIsAnEmptyScene) {
    EXPECT_TRUE(loadText(R"({"asset":{"version":"2.0"}})").scene.nodes.empty());
}

TEST(Container, laterMinorVersionsAreRead) {
    GltfFile file = triangleFile();
    file.set("asset", R"({"version":"2.7","minVersion":"2.0"})");
    expectTriangle(load(file));
}

TEST(FilePolicy, buffersOutsideTheFolderAreRefused) {
    const TemporaryFolder folder;
    const std::string outside = folder.write("secret.bin", triangleFile().binary());
    std::filesystem::create_directories(folder.path() / "scene");
    std::filesystem::create_symlink(outside, folder.path() / "scene/link.bin");
    for (const std::string& uri : {std::string("../secret.bin"), std::string("..%2Fsecret.bin"),
                                   std::string("x/../../secret.bin"), outside, std::string("link.bin")}) {
        const std::string path = folder.write("scene/a.gltf", triangleFile().textWithBufferFile(uri));
        EXPECT_NE(errorOfPath(path), "") << uri;
    }
    folder.write("scene/inside/data.bin", triangleFile().binary());
    expectTriangle(
        loadPath(folder.write("scene/a.gltf", triangleFile().textWithBufferFile("inside/data.bin"))));
}

TEST(FilePolicy, otherSchemesAreRefused) {
    for (const char* uri : {"file:///etc/passwd", "http://example.com/a.bin"}) {
        const std::string error = errorOfText(triangleFile().textWithBufferFile(uri));
        EXPECT_NE(error.find("buffer 0: URI scheme '"), std::string::npos) << error;
    }
}

TEST(FilePolicy, missingFilesAreNamed) {
    const std::string error = errorOfText(triangleFile().textWithBufferFile("not%20there.bin"));
    EXPECT_NE(error.find("not there.bin"), std::string::npos) << error;
}

}  // namespace
}  // namespace candela_test
