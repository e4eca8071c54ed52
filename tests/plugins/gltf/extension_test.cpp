// Extensions that are not supported: what is said to be missing, and what stays.
#include <gtest/gtest.h>

#include "loading.h"

namespace candela_test {
namespace {

TEST(Extensions, whatTheyAddIsNotedForTheElementsThatHaveThem) {
    GltfFile file = triangleFile(R"("material":0)");
    file.set("extensionsRequired", R"(["ADOBE_materials_clearcoat_tint","VENDOR_materials_wet"])");
    file.add("materials", R"({"name":"car","extensions":{"ADOBE_materials_clearcoat_tint":{}}})");
    file.add("materials",
             R"({"extensions":{"ADOBE_materials_clearcoat_tint":{},"VENDOR_materials_wet":{}}})");
    file.add("nodes", R"({"name":"tree","mesh":0,"extensions":{"VENDOR_wind":{}}})");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(hasNote(imported,
                        "material 0 'car' and 1 more: the colour of its clear coat (ADOBE_"
                        "materials_clearcoat_tint)"));
    EXPECT_TRUE(hasNote(imported, "material 1: a part of its look (VENDOR_materials_wet)"));
    EXPECT_TRUE(hasNote(imported, "node 1 'tree': what 'VENDOR_wind' adds to it"));
    EXPECT_EQ(imported.report.notes.size(), 3u);
}

TEST(Extensions, thatAreOnlyListedAreNotNoted) {
    GltfFile file = triangleFile();
    file.set("extensionsUsed", R"(["VENDOR_unheard_of","EXT_texture_avif"])");
    EXPECT_TRUE(load(file).report.notes.empty());
}

TEST(Extensions, anImageOfAnotherFormatIsNamed) {
    GltfFile file = triangleFile();
    file.set("extensionsRequired", R"(["MSFT_texture_dds"])");
    file.add("textures", R"({"extensions":{"MSFT_texture_dds":{"source":0}}})");
    file.add("images", R"({"uri":"a.dds"})");
    file.add("materials", R"({"normalTexture":{"index":0}})");
    const candela::ImportedScene imported = load(file);
    EXPECT_FALSE(imported.scene.materials.at(0).normalTexture);
    EXPECT_TRUE(
        hasNote(imported, "texture 0: no PNG, JPEG, WebP or KTX2 image, but one of MSFT_texture_dds"));
}

}  // namespace
}  // namespace candela_test
