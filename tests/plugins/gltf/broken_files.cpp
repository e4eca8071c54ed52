#include "broken_files.h"

#include <gtest/gtest.h>

namespace candela_test {

std::string document(const std::string& members) {
    return R"({"asset":{"version":"2.0"},)" + members + "}";
}

GltfFile wheel(const std::string& primitive) {
    GltfFile file;
    addTriangle(file);
    file.addMeshNode(primitive, "wheel");
    return file;
}

std::string wheelWithIndices(const std::vector<std::uint16_t>& indices, const std::string& more) {
    GltfFile file = wheel(onlyTriangle + R"(,"indices":2)" + more);
    file.addData<std::uint16_t>("SCALAR", indices);
    return file.text();
}

namespace {

const std::string plane = R"("buffers":[{"byteLength":36,"uri":"data:;base64,)" +
                          base64(bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0})) + R"("}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"type":"VEC3","componentType":5126,"count":3}])";

}  // namespace

std::string withPrimitives(const std::string& primitives) {
    return document(plane + R"(,"nodes":[{"mesh":0}],"meshes":[{"name":"wheel","primitives":[)" + primitives +
                    "]}]");
}

void expectErrors(const std::vector<Case>& cases) {
    for (const Case& test : cases) {
        const std::string error = errorOfText(test.text);
        EXPECT_FALSE(error.empty()) << test.name << " was accepted";
        EXPECT_NE(error.find("scene.gltf: "), std::string::npos) << test.name << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << test.name << ": " << error;
        for (const std::string& part : test.parts) {
            EXPECT_NE(error.find(part), std::string::npos)
                << test.name << ": '" << part << "' is not in: " << error;
        }
    }
}

void expectNotes(const std::vector<Case>& cases) {
    for (const Case& test : cases) {
        SCOPED_TRACE(test.name);
        ASSERT_EQ(errorOfText(test.text), "");
        const candela::ImportedScene imported = loadText(test.text);
        ASSERT_EQ(imported.report.notes.size(), 1u)
            << (imported.report.notes.empty() ? "" : imported.report.notes[1].line());
        const std::string line = imported.report.notes[0].line();
        for (const std::string& part : test.parts) {
            EXPECT_NE(line.find(part), std::string::npos) << "'" << part << "' is not in: " << line;
        }
        EXPECT_NE(strictErrorOfText(test.text).find("scene.gltf: " + line), std::string::npos);
    }
}

}  // namespace candela_test
