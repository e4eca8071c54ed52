#include "color/display_shader.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace candela {
namespace {

DisplayTransform lutView(const char* view) {
    return ColorConfig::load(CANDELA_TEST_DATA "/config/luts.ocio")
        .displayTransform({"Monitor", view, "", 0.0});
}

int occurrences(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// Each texture has to be declared as a sampler of its dimensions, with the number of values that they give.
void expectConsistent(const DisplayShader& shader) {
    std::set<std::string> names;
    for (const LookupTexture& table : shader.textures) {
        const std::string declaration =
            "uniform sampler" + std::to_string(table.dimensions) + "D " + table.sampler + ";";
        EXPECT_NE(shader.glsl.find(declaration), std::string::npos) << declaration;
        EXPECT_TRUE(names.insert(table.sampler).second) << table.sampler;
        EXPECT_EQ(table.values.size(),
                  std::size_t(table.width) * table.height * table.depth * table.channels);
        EXPECT_TRUE(table.channels == 1 || table.channels == 3);
        EXPECT_EQ(table.height > 1, table.dimensions > 1);
        EXPECT_EQ(table.depth > 1, table.dimensions > 2);
    }
    EXPECT_EQ(occurrences(shader.glsl, "uniform "), int(shader.textures.size())) << "no other uniform";
    EXPECT_EQ(occurrences(shader.glsl, "vec4 displayTransform(vec4 radiance)"), 1);
}

TEST(DisplayShader, everyViewOfTheLutConfigIsConsistent) {
    for (const char* view :
         {"Mono", "RGB", "Inverse", "Tetrahedral", "Trilinear", "Film and print", "Graded"}) {
        SCOPED_TRACE(view);
        const DisplayTransform transform = lutView(view);
        EXPECT_FALSE(displayShader(transform).textures.empty());
        expectConsistent(displayShader(transform));
    }
}

TEST(DisplayShader, everyBuiltInViewIsConsistent) {
    const ColorConfig config = ColorConfig::builtIn();
    for (const std::string& display : config.displays())
        for (const std::string& view : config.views(display)) {
            SCOPED_TRACE(display + ", " + view);
            const DisplayTransform transform = config.displayTransform({display, view, "", 0.0});
            expectConsistent(displayShader(transform));
        }
}

TEST(DisplayShader, tablesOfAllShapes) {
    const DisplayTransform mono = lutView("Mono"), rgb = lutView("RGB"), inverse = lutView("Inverse"),
                           both = lutView("Film and print");
    EXPECT_EQ(displayShader(mono).textures.at(0).dimensions, 1);
    EXPECT_EQ(displayShader(mono).textures.at(0).channels, 1);
    EXPECT_EQ(displayShader(rgb).textures.at(0).channels, 3);
    EXPECT_EQ(displayShader(inverse).textures.at(0).dimensions, 2) << "long tables are folded into rows";
    EXPECT_EQ(displayShader(both).textures.size(), 4u);
}

TEST(DisplayShader, cornersOfTetrahedraAreFetchedUnfiltered) {
    const DisplayTransform tetrahedral = lutView("Tetrahedral"), trilinear = lutView("Trilinear");
    EXPECT_EQ(displayShader(tetrahedral).textures.at(0).filter, LookupTexture::Filter::nearest);
    EXPECT_EQ(displayShader(trilinear).textures.at(0).filter, LookupTexture::Filter::linear);
}

TEST(DisplayShader, isCreatedOncePerTransform) {
    const DisplayTransform transform = lutView("Mono");
    const DisplayTransform copy = transform;
    EXPECT_EQ(&displayShader(transform), &displayShader(copy));
}

}  // namespace
}  // namespace candela
