// The table of extensions and docs/gltf.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "loading.h"
#include "plugins/gltf/extension_table.h"

namespace candela_test {
namespace {

using candela_plugins::gltf::Extension;
using candela_plugins::gltf::extensionTable;
using candela_plugins::gltf::Support;

std::string nameOf(Support support) {
    switch (support) {
        case Support::drawn:
            return "drawn";
        case Support::partly:
            return "partly drawn";
        case Support::notDrawn:
            return "not drawn";
        default:
            return "nothing to draw";
    }
}

TEST(ExtensionTable, isSorted) {
    const auto less = [](const Extension& a, const Extension& b) {
        return std::lexicographical_compare(a.name.begin(), a.name.end(), b.name.begin(), b.name.end(),
                                            [](char x, char y) {
                                                return std::tolower(static_cast<unsigned char>(x)) <
                                                       std::tolower(static_cast<unsigned char>(y));
                                            });
    };
    EXPECT_TRUE(std::is_sorted(std::begin(extensionTable), std::end(extensionTable), less));
}

TEST(ExtensionTable, matchesTheDocumentation) {
    std::string expected;
    for (const Extension& extension : extensionTable) {
        expected += "| `" + std::string(extension.name) + "` | " + nameOf(extension.support) + " | " +
                    std::string(extension.remark) + " |\n";
    }
    std::ifstream document(CANDELA_TEST_DATA "/../../../docs/gltf.md");
    std::string rows;
    for (std::string line; std::getline(document, line);) {
        if (line.starts_with("| `")) rows += line + "\n";
    }
    EXPECT_EQ(rows, expected);
}

/// A file whose node has the extension, which it requires.
GltfFile fileWith(const std::string& extension) {
    GltfFile file = triangleFile();
    file.set("extensionsRequired", "[\"" + extension + "\"]");
    file.add("nodes", R"({"name":"part","extensions":{")" + extension + R"(":{"visible":false}}})");
    return file;
}

TEST(ExtensionTable, agreesWithTheLoader) {
    for (const Extension& extension : extensionTable) {
        const candela::ImportedScene imported = load(fileWith(std::string(extension.name)));
        EXPECT_EQ(candela::triangleCount(imported.scene), 1u) << extension.name;
        if (!extension.loss.empty()) {
            EXPECT_TRUE(hasNote(imported, std::string(extension.loss))) << extension.name;
            EXPECT_NE(extension.support, Support::drawn) << extension.name;
        }
        if (extension.support == Support::noPicture) {
            EXPECT_TRUE(imported.report.notes.empty()) << extension.name;
        }
    }
    EXPECT_NE(errorOf(fileWith("VENDOR_shape")).find("extension 'VENDOR_shape' is not supported"),
              std::string::npos);
}

}  // namespace
}  // namespace candela_test
