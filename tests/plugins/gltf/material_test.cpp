#include <gtest/gtest.h>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

/// A file with two images, used by textures 0 and 1, and one material.
GltfFile fileWithMaterial(const std::string& material) {
    GltfFile file;
    for (const std::uint8_t red : {std::uint8_t(10), std::uint8_t(20)}) {
        const std::string uri = "data:image/png;base64," + base64(makePng(1, 1, red, 0, 0, 255));
        file.add("images", R"({"uri":")" + uri + "\"}");
    }
    file.add("textures", R"({"source":0})");
    file.add("textures", R"({"source":1,"sampler":0})");
    file.add("samplers", R"({"wrapS":33071,"wrapT":33648,"minFilter":9985,"magFilter":9728})");
    file.add("materials", material);
    return file;
}

candela::ImportedScene loadMaterial(const std::string& material) {
    return load(fileWithMaterial(material));
}

candela::Material materialOf(const std::string& material) {
    return loadMaterial(material).scene.materials.at(0);
}

TEST(Material, specificationDefaults) {
    const candela::Material material = materialOf("{}");
    EXPECT_EQ(material.baseColor, glm::vec4(1));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_EQ(material.emission, glm::vec3(0));
    EXPECT_EQ(material.alphaMode, candela::AlphaMode::opaque);
    EXPECT_FALSE(material.doubleSided);
    EXPECT_FALSE(material.unlit);
    EXPECT_FALSE(material.baseColorTexture || material.metallicRoughnessTexture || material.normalTexture ||
                 material.occlusionTexture || material.emissionTexture);
}

TEST(Material, factors) {
    const candela::Material material = materialOf(R"({"name":"brass","pbrMetallicRoughness":
        {"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.5,"roughnessFactor":0.25},
        "emissiveFactor":[0.5,1,0],"doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.75})");
    EXPECT_EQ(material.name, "brass");
    EXPECT_EQ(material.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.5f);
    EXPECT_EQ(material.roughness, 0.25f);
    EXPECT_EQ(material.emission, glm::vec3(0.5f, 1, 0));
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.alphaMode, candela::AlphaMode::mask);
    EXPECT_EQ(material.alphaCutoff, 0.75f);
}

TEST(Material, allFiveTextures) {
    const candela::ImportedScene imported = loadMaterial(R"({"pbrMetallicRoughness":
        {"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1,"texCoord":1}},
        "normalTexture":{"index":0,"scale":0.5},"occlusionTexture":{"index":1,"strength":0.25},
        "emissiveTexture":{"index":0,"texCoord":1}})");
    const candela::Material& material = imported.scene.materials.at(0);
    ASSERT_EQ(imported.scene.images.size(), 2u);
    ASSERT_TRUE(material.baseColorTexture && material.metallicRoughnessTexture && material.normalTexture &&
                material.occlusionTexture && material.emissionTexture);
    EXPECT_EQ(material.baseColorTexture->image, 0u);
    EXPECT_EQ(material.baseColorTexture->uvSet, 0u);
    EXPECT_EQ(material.metallicRoughnessTexture->image, 1u);
    EXPECT_EQ(material.metallicRoughnessTexture->uvSet, 1u);
    EXPECT_EQ(material.normalScale, 0.5f);
    EXPECT_EQ(material.occlusionStrength, 0.25f);
    EXPECT_EQ(material.emissionTexture->image, 0u);
    EXPECT_EQ(material.emissionTexture->uvSet, 1u);
}

TEST(Material, samplers) {
    const candela::Material material =
        materialOf(R"({"normalTexture":{"index":0},"emissiveTexture":{"index":1}})");
    const candela::Texture &without = *material.normalTexture, &with = *material.emissionTexture;
    EXPECT_EQ(without.wrapS, candela::Wrap::repeat);
    EXPECT_EQ(without.minFilter, candela::Filter::linearMipmapLinear);
    EXPECT_EQ(without.magFilter, candela::Filter::linear);
    EXPECT_EQ(with.wrapS, candela::Wrap::clampToEdge);
    EXPECT_EQ(with.wrapT, candela::Wrap::mirroredRepeat);
    EXPECT_EQ(with.minFilter, candela::Filter::linearMipmapNearest);
    EXPECT_EQ(with.magFilter, candela::Filter::nearest);
}

TEST(Material, minificationFilters) {
    const std::pair<const char*, candela::Filter> cases[] = {
        {"9728", candela::Filter::nearest},
        {"9729", candela::Filter::linear},
        {"9984", candela::Filter::nearestMipmapNearest},
        {"9985", candela::Filter::linearMipmapNearest},
        {"9986", candela::Filter::nearestMipmapLinear},
        {"9987", candela::Filter::linearMipmapLinear},
    };
    for (const auto& [value, expected] : cases) {
        GltfFile file = fileWithMaterial(R"({"normalTexture":{"index":2}})");
        file.add("samplers", std::string("{\"minFilter\":") + value + "}");
        file.add("textures", R"({"source":0,"sampler":1})");
        EXPECT_EQ(load(file).scene.materials.at(0).normalTexture->minFilter, expected) << value;
    }
}

TEST(Material, textureTransform) {
    const candela::Material material = materialOf(R"({"normalTexture":{"index":0,"texCoord":0,"extensions":
        {"KHR_texture_transform":{"offset":[0.5,-2],"rotation":1.5,"scale":[2,3],"texCoord":1}}},
        "emissiveTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":{}}}})");
    const candela::Texture& moved = *material.normalTexture;
    EXPECT_EQ(moved.offset, glm::vec2(0.5f, -2));
    EXPECT_EQ(moved.rotation, 1.5f);
    EXPECT_EQ(moved.scale, glm::vec2(2, 3));
    EXPECT_EQ(moved.uvSet, 1u) << "the extension's texCoord overrides the texture's";
    const candela::Texture& plain = *material.emissionTexture;
    EXPECT_EQ(plain.offset, glm::vec2(0));
    EXPECT_EQ(plain.scale, glm::vec2(1));
    EXPECT_EQ(plain.uvSet, 1u);
}

TEST(Material, emissiveStrength) {
    const candela::Material material = materialOf(R"({"emissiveFactor":[1,0.5,0],"extensions":
        {"KHR_materials_emissive_strength":{"emissiveStrength":8}}})");
    EXPECT_EQ(material.emission, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(material.emissionStrength, 8.0f);
    EXPECT_EQ(materialOf(R"({"emissiveFactor":[1,0.5,0]})").emissionStrength, 1.0f);
}

TEST(Material, unlit) {
    EXPECT_TRUE(materialOf(R"({"extensions":{"KHR_materials_unlit":{}}})").unlit);
}

TEST(Material, blendIsReadWithoutANote) {
    const candela::ImportedScene imported = loadMaterial(R"({"name":"glass","alphaMode":"BLEND"})");
    EXPECT_EQ(imported.scene.materials.at(0).alphaMode, candela::AlphaMode::blend);
    EXPECT_EQ(imported.scene.materials.at(0).alphaCutoff, 0.5f);
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(Material, textureWithoutImageIsNotedAndOmitted) {
    GltfFile file = fileWithMaterial(R"({"normalTexture":{"index":2}})");
    file.add("textures", R"({"extensions":{"MSFT_texture_dds":{"source":0}}})");
    file.set("extensionsUsed", R"(["MSFT_texture_dds"])");
    const candela::ImportedScene imported = load(file);
    EXPECT_FALSE(imported.scene.materials.at(0).normalTexture.has_value());
    EXPECT_TRUE(hasNote(
        imported, "texture 2: no PNG, JPEG, WebP or KTX2 image, but one of MSFT_texture_dds: left out"));
    EXPECT_EQ(imported.report.notes.size(), 1u);
}

}  // namespace
}  // namespace candela_test
