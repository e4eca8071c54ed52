// KHR_materials_variants.
#include <gtest/gtest.h>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

/// A triangle with three materials, and variants "red" and "blue"; `mappings` are those of its primitive.
GltfFile fileWithVariants(const std::string& mappings, const std::string& members = R"("material":0)") {
    GltfFile file =
        triangleFile(members + R"(,"extensions":{"KHR_materials_variants":{"mappings":)" + mappings + "}}");
    for (const char* name : {"plain", "red paint", "blue paint"})
        file.add("materials", R"({"name":")" + std::string(name) + "\"}");
    file.set("extensions", R"({"KHR_materials_variants":{"variants":[{"name":"red"},{"name":"blue"}]}})");
    file.set("extensionsUsed", R"(["KHR_materials_variants"])");
    return file;
}

TEST(Variants, areTheFileS) {
    const candela::ImportedScene imported =
        load(fileWithVariants(R"([{"material":1,"variants":[0],"name":"a"},{"material":2,"variants":[1]}])"));
    EXPECT_TRUE(imported.report.notes.empty());
    candela::Scene scene = imported.scene;
    EXPECT_EQ(scene.variants, (std::vector<std::string>{"red", "blue"}));
    const auto& material = scene.meshes.at(0).submeshes.at(0).material;
    EXPECT_EQ(material, 0u);
    candela::selectVariant(scene, 0);
    EXPECT_EQ(material, 1u);
    candela::selectVariant(scene, 1);
    EXPECT_EQ(material, 2u);
    candela::selectVariant(scene, std::nullopt);
    EXPECT_EQ(material, 0u);
}

TEST(Variants, aMappingMayNameSeveralAndAPrimitiveNoMaterial) {
    candela::Scene scene =
        load(fileWithVariants(R"([{"material":2,"variants":[0,1]}])", R"("mode":4)")).scene;
    const auto& material = scene.meshes.at(0).submeshes.at(0).material;
    EXPECT_EQ(material, 3u) << "the default material of glTF, behind those of the file";
    for (const std::uint32_t variant : {0u, 1u}) {
        candela::selectVariant(scene, variant);
        EXPECT_EQ(material, 2u);
    }
}

TEST(Variants, whatIsWrongInOneIsNotedAndLeftOut) {
    const candela::ImportedScene imported = load(fileWithVariants(
        R"([{"material":9,"variants":[0]},{"material":1,"variants":[0,7]},{"material":2,"variants":[0,1]},3])"));
    const std::string mapping = "mesh 0, primitive 0, KHR_materials_variants, mapping ";
    EXPECT_TRUE(
        hasNote(imported, mapping + "0, material: material 9 does not exist: the file has 3: left out"));
    EXPECT_TRUE(
        hasNote(imported, mapping + "1, variants: variant 7 does not exist: the file has 2: left out"));
    EXPECT_TRUE(hasNote(imported, "mesh 0, primitive 0: two materials for a variant: the first one is used"));
    EXPECT_TRUE(hasNote(imported, mapping + "3: is not an object: left out"));
    const std::vector<candela::VariantMaterial> expected{{0, std::nullopt, 0}, {0, 0, 1}, {0, 1, 2}};
    EXPECT_EQ(imported.scene.meshes.at(0).variantMaterials, expected);
}

// One mesh has one pair of texture coordinates, whichever material is selected.
TEST(Variants, theirMaterialsShareTextureCoordinates) {
    GltfFile file;
    addTriangle(file);
    file.add("images", R"({"uri":"data:image/png;base64,)" + base64(makePng(1, 1, 1, 2, 3, 4)) + "\"}");
    file.add("textures", R"({"source":0})");
    for (const char* set : {"0", "3"})
        file.add("materials", R"({"emissiveTexture":{"index":0,"texCoord":)" + std::string(set) + "}}");
    for (const float first : {0.0f, 1.0f, 3.0f}) file.addData<float>("VEC2", {first, 0, 1, 0, 0, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":3,"TEXCOORD_3":4},
        "material":0,"extensions":{"KHR_materials_variants":{"mappings":[{"material":1,"variants":[0]}]}})");
    file.set("extensions", R"({"KHR_materials_variants":{"variants":[{"name":"other"}]}})");
    const candela::ImportedScene imported = load(file);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_TRUE(imported.report.notes.empty());
    EXPECT_EQ(imported.scene.materials.at(0).emissionTexture.value().uvSet, 0u);
    EXPECT_EQ(imported.scene.materials.at(1).emissionTexture.value().uvSet, 1u);
    EXPECT_EQ(mesh.uv0.at(0), glm::vec2(0, 0));
    EXPECT_EQ(mesh.uv1.at(0), glm::vec2(3, 0));
}

TEST(Variants, ofACageAreThoseOfItsPrimitives) {
    GltfFile file = fileWithVariants(R"([{"material":1,"variants":[0]}])");
    const std::string positions = std::to_string(file.addData<float>("VEC3", {0, 0, 5, 1, 0, 5, 0, 1, 5}));
    file.add("meshes", R"({"name":"cage","primitives":[{"attributes":{"POSITION":0},"material":0,
        "extensions":{"KHR_materials_variants":{"mappings":[{"material":1,"variants":[0]}]}}},
        {"attributes":{"POSITION":)" +
                           positions + R"(},"material":1,
        "extensions":{"KHR_materials_variants":{"mappings":[{"material":2,"variants":[1,0]}]}}}],
        "extras":{"candela_subdivision":{"scheme":"loop"}}})");
    file.add("nodes", R"({"mesh":1})");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    candela::Scene scene = imported.scene;
    using Materials = std::vector<std::optional<std::uint32_t>>;
    const Materials& shown = scene.cages.at(0).faceMaterials;
    EXPECT_EQ(shown, (Materials{0, 1}));
    candela::selectVariant(scene, 0);
    EXPECT_EQ(shown, (Materials{1, 2}));
    candela::selectVariant(scene, 1);
    EXPECT_EQ(shown, (Materials{0, 2})) << "the first primitive has no material of its own in it";
    candela::selectVariant(scene, std::nullopt);
    EXPECT_EQ(shown, (Materials{0, 1}));
}

}  // namespace
}  // namespace candela_test
