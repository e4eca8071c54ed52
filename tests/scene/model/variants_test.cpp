// Variants: what is selected, what stays, and what is no variant.
#include "sample_scene.h"
#include "validate/broken_rule.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

namespace candela {
namespace {

/// The sample scene with three materials and two variants, of which submesh 0 of mesh 0 takes part.
Scene sceneWithVariants() {
    Scene scene = sampleScene();
    while (scene.materials.size() < 3) scene.materials.push_back(scene.materials.front());
    scene.variants = {"red", "blue"};
    scene.meshes[0].submeshes[0].material = 0;
    scene.meshes[0].variantMaterials = {{0, std::nullopt, 0}, {0, 0, 1}, {0, 1, std::nullopt}};
    return scene;
}

TEST(Variants, SelectMaterials) {
    Scene scene = sceneWithVariants();
    EXPECT_NO_THROW(validate(scene));
    const auto other = scene.meshes[0].submeshes[1].material;
    const auto materialIn = [&](std::optional<std::uint32_t> variant) {
        selectVariant(scene, variant);
        EXPECT_EQ(scene.meshes[0].submeshes[1].material, other);
        EXPECT_NO_THROW(validate(scene));
        return scene.meshes[0].submeshes[0].material;
    };
    EXPECT_EQ(materialIn(0), 1u);
    EXPECT_EQ(materialIn(1), std::nullopt) << "the default material";
    EXPECT_EQ(materialIn(std::nullopt), 0u);
    scene.meshes[0].variantMaterials.pop_back();
    EXPECT_EQ(materialIn(0), 1u);
    EXPECT_EQ(materialIn(1), 0u) << "blue does not name it";
}

/// With a cage of one face that takes part.
Scene sceneWithCage() {
    Scene scene = sceneWithVariants();
    Cage cage;
    cage.name = "body";
    cage.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    cage.faceSizes = {3};
    cage.faceVertices = {0, 1, 2};
    cage.uvs.resize(3);
    cage.faceUvs = {0, 1, 2};
    cage.faceMaterials = {0};
    cage.variants = {{std::nullopt, {0}}, {1, {2}}};
    scene.cages.push_back(cage);
    return scene;
}

TEST(Variants, SelectMaterialsOfCages) {
    Scene scene = sceneWithCage();
    EXPECT_NO_THROW(validate(scene));
    const auto materialIn = [&](std::optional<std::uint32_t> variant) {
        selectVariant(scene, variant);
        return scene.cages[0].faceMaterials.at(0);
    };
    EXPECT_EQ(materialIn(1), 2u);
    EXPECT_EQ(materialIn(0), 0u) << "red does not name it";
    EXPECT_EQ(materialIn(1), 2u);
    EXPECT_EQ(materialIn(std::nullopt), 0u);
}

TEST(Variants, RulesOfCages) {
    expectMessages(
        sceneWithCage(),
        {
            {"cage 0 'body': refers to variant 2, but the scene has 2 (counted from 0)",
             [](Scene& s) { s.cages[0].variants[1].variant = 2; }},
            {"cage 0 'body': has 2 materials for 1 faces",
             [](Scene& s) { s.cages[0].variants[1].faceMaterials.push_back(0); }},
            {"cage 0 'body': refers to material 3, but the scene has 3 (counted from 0)",
             [](Scene& s) { s.cages[0].variants[1].faceMaterials = {3}; }},
            {"cage 0 'body': has its materials for the same variant twice",
             [](Scene& s) {
                 s.cages[0].variants.push_back({1, {0}});
             }},
            {"cage 0 'body': has materials for variants and none without a variant",
             [](Scene& s) { s.cages[0].variants.erase(s.cages[0].variants.begin()); }},
            {"cage 0 'body': has no texture coordinates 0, which a texture of material 2 'wall' reads",
             [](Scene& s) {
                 s.materials[0].baseColorTexture.reset();
                 s.cages[0].uvs.clear();
                 s.cages[0].faceUvs.clear();
             }},
        });
}

TEST(Variants, OfNoSuchNumberAreRefused) {
    Scene scene = sceneWithVariants();
    try {
        selectVariant(scene, 2);
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "scene: refers to variant 2, but the scene has 2 (counted from 0)");
    }
    scene.meshes[0].variantMaterials[0].submesh = 9;
    EXPECT_THROW(selectVariant(scene, 0), Error);
}

TEST(Variants, Rules) {
    expectMessages(
        sceneWithVariants(),
        {
            {"mesh 0 'wheel': refers to variant 2, but the scene has 2 (counted from 0)",
             [](Scene& s) { s.meshes[0].variantMaterials[1].variant = 2; }},
            {"mesh 0 'wheel': a variant names submesh 2, but there are 2",
             [](Scene& s) { s.meshes[0].variantMaterials[1].submesh = 2; }},
            {"mesh 0 'wheel': refers to material 3, but the scene has 3 (counted from 0)",
             [](Scene& s) { s.meshes[0].variantMaterials[1].material = 3; }},
            {"mesh 0 'wheel': a submesh has two materials for the same variant",
             [](Scene& s) { s.meshes[0].variantMaterials[1].variant = 1; }},
            {"mesh 0 'wheel': a submesh with materials for variants has none without a variant",
             [](Scene& s) { s.meshes[0].variantMaterials.erase(s.meshes[0].variantMaterials.begin()); }},
            {"mesh 0 'wheel': has no texture coordinates 1, which a texture of material 2 'wall' reads",
             [](Scene& s) {
                 s.materials[2].baseColorTexture->uvSet = 1;
                 s.meshes[0].variantMaterials[1].material = 2;
             }},
        });
}

}  // namespace
}  // namespace candela
