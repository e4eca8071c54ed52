// Lobes and media of materials, specular-glossiness values, and further sets of texture coordinates.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

/// A file with `images` images and a texture for each, and one material.
GltfFile fileWithMaterial(const std::string& material, std::uint8_t images = 14) {
    GltfFile file;
    for (std::uint8_t i = 0; i < images; ++i) {
        const std::string uri = "data:image/png;base64," + base64(makePng(1, 1, i, 0, 0, 255));
        file.add("images", R"({"uri":")" + uri + "\"}");
        file.add("textures", R"({"source":)" + std::to_string(i) + "}");
    }
    file.add("materials", material);
    return file;
}

candela::Material materialOf(const std::string& extensions) {
    return load(fileWithMaterial(R"({"extensions":{)" + extensions + "}}")).scene.materials.at(0);
}

std::uint32_t imageOf(const std::optional<candela::Texture>& texture) {
    return texture ? texture->image : 999;
}

TEST(LayeredMaterial, allFactorsAndTextures) {
    const candela::Material material = materialOf(R"("KHR_materials_ior":{"ior":1.25},
        "KHR_materials_specular":{"specularFactor":0.5,"specularTexture":{"index":0},
            "specularColorFactor":[0.25,2,0],"specularColorTexture":{"index":1}},
        "KHR_materials_clearcoat":{"clearcoatFactor":0.75,"clearcoatTexture":{"index":2},
            "clearcoatRoughnessFactor":0.125,"clearcoatRoughnessTexture":{"index":3},
            "clearcoatNormalTexture":{"index":4,"scale":-2}},
        "KHR_materials_sheen":{"sheenColorFactor":[0.25,0.5,1],"sheenColorTexture":{"index":5},
            "sheenRoughnessFactor":0.375,"sheenRoughnessTexture":{"index":6}},
        "KHR_materials_anisotropy":{"anisotropyStrength":0.625,"anisotropyRotation":7,
            "anisotropyTexture":{"index":7}},
        "KHR_materials_iridescence":{"iridescenceFactor":0.5,"iridescenceTexture":{"index":8},
            "iridescenceIor":1.75,"iridescenceThicknessMinimum":50,"iridescenceThicknessMaximum":300,
            "iridescenceThicknessTexture":{"index":9}},
        "KHR_materials_transmission":{"transmissionFactor":0.875,"transmissionTexture":{"index":10}},
        "KHR_materials_volume":{"thicknessFactor":0.25,"thicknessTexture":{"index":11},
            "attenuationDistance":4,"attenuationColor":[0.5,0.75,1]},
        "KHR_materials_dispersion":{"dispersion":0.25},
        "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.5,
            "diffuseTransmissionTexture":{"index":12},"diffuseTransmissionColorFactor":[1,0.5,0.25],
            "diffuseTransmissionColorTexture":{"index":13}})");
    EXPECT_EQ(material.ior, 1.25f);
    EXPECT_EQ(material.specular.factor, 0.5f);
    EXPECT_EQ(material.specular.color, glm::vec3(0.25f, 2.0f, 0.0f));
    EXPECT_EQ(imageOf(material.specular.texture), 0u);
    EXPECT_EQ(imageOf(material.specular.colorTexture), 1u);
    EXPECT_EQ(material.clearcoat.factor, 0.75f);
    EXPECT_EQ(material.clearcoat.roughness, 0.125f);
    EXPECT_EQ(material.clearcoat.normalScale, -2.0f);
    EXPECT_EQ(imageOf(material.clearcoat.texture), 2u);
    EXPECT_EQ(imageOf(material.clearcoat.roughnessTexture), 3u);
    EXPECT_EQ(imageOf(material.clearcoat.normalTexture), 4u);
    EXPECT_EQ(material.sheen.color, glm::vec3(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(material.sheen.roughness, 0.375f);
    EXPECT_EQ(imageOf(material.sheen.colorTexture), 5u);
    EXPECT_EQ(imageOf(material.sheen.roughnessTexture), 6u);
    EXPECT_EQ(material.anisotropy.strength, 0.625f);
    EXPECT_EQ(material.anisotropy.rotation, 7.0f);
    EXPECT_EQ(imageOf(material.anisotropy.texture), 7u);
    EXPECT_EQ(material.iridescence.factor, 0.5f);
    EXPECT_EQ(material.iridescence.ior, 1.75f);
    EXPECT_EQ(material.iridescence.minThickness, 50.0f);
    EXPECT_EQ(material.iridescence.maxThickness, 300.0f);
    EXPECT_EQ(imageOf(material.iridescence.texture), 8u);
    EXPECT_EQ(imageOf(material.iridescence.thicknessTexture), 9u);
    EXPECT_EQ(material.transmission.factor, 0.875f);
    EXPECT_EQ(imageOf(material.transmission.texture), 10u);
    EXPECT_EQ(material.volume.thickness, 0.25f);
    EXPECT_EQ(material.volume.attenuationDistance, 4.0f);
    EXPECT_EQ(material.volume.attenuationColor, glm::vec3(0.5f, 0.75f, 1.0f));
    EXPECT_EQ(material.volume.dispersion, 0.25f);
    EXPECT_EQ(imageOf(material.volume.thicknessTexture), 11u);
    EXPECT_EQ(material.diffuseTransmission.factor, 0.5f);
    EXPECT_EQ(material.diffuseTransmission.color, glm::vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(imageOf(material.diffuseTransmission.texture), 12u);
    EXPECT_EQ(imageOf(material.diffuseTransmission.colorTexture), 13u);
}

// The defaults of the extensions' specifications; those of candela are a material without the extension.
TEST(LayeredMaterial, specificationDefaults) {
    const candela::Material material = materialOf(R"("KHR_materials_ior":{},"KHR_materials_specular":{},
        "KHR_materials_clearcoat":{},"KHR_materials_sheen":{},"KHR_materials_anisotropy":{},
        "KHR_materials_iridescence":{},"KHR_materials_transmission":{},"KHR_materials_volume":{},
        "KHR_materials_dispersion":{},"KHR_materials_diffuse_transmission":{})");
    const candela::Material plain;
    EXPECT_EQ(material.ior, 1.5f);
    EXPECT_EQ(material.specular, plain.specular);
    EXPECT_EQ(material.clearcoat, plain.clearcoat);
    EXPECT_EQ(material.sheen, plain.sheen);
    EXPECT_EQ(material.anisotropy, plain.anisotropy);
    EXPECT_EQ(material.iridescence, plain.iridescence);
    EXPECT_EQ(material.transmission, plain.transmission);
    EXPECT_EQ(material.volume, plain.volume);
    EXPECT_EQ(material.diffuseTransmission, plain.diffuseTransmission);
}

TEST(LayeredMaterial, texturesHaveTransforms) {
    const candela::Texture texture = materialOf(R"("KHR_materials_sheen":{"sheenColorTexture":{"index":0,
        "extensions":{"KHR_texture_transform":{"offset":[0.5,-2],"rotation":1.5,"scale":[2,3],"texCoord":1}}}})")
                                         .sheen.colorTexture.value();
    EXPECT_EQ(texture.offset, glm::vec2(0.5f, -2.0f));
    EXPECT_EQ(texture.rotation, 1.5f);
    EXPECT_EQ(texture.scale, glm::vec2(2.0f, 3.0f));
    EXPECT_EQ(texture.uvSet, 1u);
}

TEST(LayeredMaterial, indicesOfRefraction) {
    EXPECT_EQ(materialOf(R"("KHR_materials_ior":{"ior":0})").ior, std::numeric_limits<float>::infinity());
    EXPECT_EQ(materialOf(R"("KHR_materials_ior":{"ior":1})").ior, 1.0f);
    const candela::ImportedScene low =
        load(fileWithMaterial(R"({"name":"air","extensions":{"KHR_materials_ior":{"ior":0.5}}})"));
    EXPECT_EQ(low.scene.materials.at(0).ior, 1.0f);
    EXPECT_TRUE(hasNote(low, "material 0 'air', KHR_materials_ior, ior: neither 0 nor 1 or more"));
}

TEST(LayeredMaterial, numbersOutOfRangeAreClampedAndNoted) {
    const candela::ImportedScene imported = load(fileWithMaterial(R"({"extensions":{
        "KHR_materials_clearcoat":{"clearcoatFactor":1.5},"KHR_materials_iridescence":{"iridescenceIor":0.5},
        "KHR_materials_volume":{"thicknessFactor":-1,"attenuationDistance":0},
        "KHR_materials_sheen":{"sheenColorFactor":[0,2,0],"sheenColorTexture":{"index":99}}}})"));
    const candela::Material& material = imported.scene.materials.at(0);
    EXPECT_EQ(material.clearcoat.factor, 1.0f);
    EXPECT_EQ(material.iridescence.ior, 1.0f);
    EXPECT_EQ(material.volume.thickness, 0.0f);
    EXPECT_EQ(material.volume.attenuationDistance, std::numeric_limits<float>::infinity());
    EXPECT_EQ(material.sheen.color, glm::vec3(0, 1, 0));
    EXPECT_FALSE(material.sheen.colorTexture);
    EXPECT_TRUE(hasNote(
        imported, "material 0, KHR_materials_clearcoat, clearcoatFactor and 1 more: more than 1, clamped"));
    EXPECT_TRUE(hasNote(imported, "material 0, KHR_materials_volume, thicknessFactor: less than 0, clamped"));
    EXPECT_TRUE(hasNote(imported, "KHR_materials_volume, attenuationDistance: is 0, expected more than 0"));
    EXPECT_TRUE(
        hasNote(imported, "KHR_materials_sheen, sheenColorTexture, index: texture 99 does not exist"));
}

// KHR_materials_pbrSpecularGlossiness

TEST(SpecularGlossiness, factors) {
    const candela::Material material = materialOf(R"("KHR_materials_pbrSpecularGlossiness":{
        "diffuseFactor":[0.1,0.2,0.3,0.4],"specularFactor":[0.5,0.25,0.125],"glossinessFactor":0.75})");
    EXPECT_EQ(material.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.roughness, 0.25f);
    EXPECT_EQ(material.ior, std::numeric_limits<float>::infinity());
    EXPECT_EQ(material.specular.factor, 1.0f);
    EXPECT_EQ(material.specular.color, glm::vec3(0.5f, 0.25f, 0.125f));
}

TEST(SpecularGlossiness, specificationDefaultsTakeThePlaceOfMetallicRoughness) {
    const candela::Material material = load(fileWithMaterial(R"({"pbrMetallicRoughness":{
        "baseColorFactor":[0.5,0.5,0.5,0.5],"baseColorTexture":{"index":0},"roughnessFactor":0.5,
        "metallicRoughnessTexture":{"index":1}},"extensions":{"KHR_materials_pbrSpecularGlossiness":{}}})"))
                                           .scene.materials.at(0);
    EXPECT_EQ(material.baseColor, glm::vec4(1.0f));
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.roughness, 0.0f);
    EXPECT_EQ(material.specular.color, glm::vec3(1.0f));
    EXPECT_FALSE(material.baseColorTexture || material.metallicRoughnessTexture);
}

/// The first texel of an image of 8 bits.
std::vector<int> texelOf(const candela::Image& image) {
    std::vector<int> texel;
    for (std::size_t i = 0; i < 4; ++i) texel.push_back(std::to_integer<int>(image.pixels.at(i)));
    return texel;
}

TEST(SpecularGlossiness, aTextureBecomesColorsAndRoughness) {
    GltfFile file = fileWithMaterial(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
        "diffuseTexture":{"index":0},"glossinessFactor":0.5,"specularGlossinessTexture":{"index":1,
        "texCoord":1,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}}}}})",
                                     1);
    file.add("images", R"({"name":"gloss","uri":"data:image/png;base64,)" +
                           base64(makePng(2, 1, 10, 20, 30, 100)) + "\"}");
    file.add("textures", R"({"source":1})");
    // The same image with the same factor, and with another one.
    file.add("materials", R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"glossinessFactor":0.5,
        "specularGlossinessTexture":{"index":1}}}})");
    file.add("materials", R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
        "specularGlossinessTexture":{"index":1}}}})");
    const candela::Scene scene = load(file).scene;
    const candela::Material& material = scene.materials.at(0);
    EXPECT_EQ(imageOf(material.baseColorTexture), 0u);
    EXPECT_EQ(imageOf(material.specular.colorTexture), 1u);
    EXPECT_EQ(texelOf(scene.images.at(1)), (std::vector{10, 20, 30, 100}));
    EXPECT_EQ(material.roughness, 1.0f) << "the image has the factor";
    const candela::Texture roughness = material.metallicRoughnessTexture.value();
    EXPECT_EQ(roughness.uvSet, 1u);
    EXPECT_EQ(roughness.scale, glm::vec2(2.0f));
    EXPECT_EQ(texelOf(scene.images.at(roughness.image)), (std::vector{0, 255 - 50, 0, 255}));
    EXPECT_EQ(scene.images.at(roughness.image).name, "gloss (roughness)");
    EXPECT_EQ(imageOf(scene.materials.at(1).metallicRoughnessTexture), roughness.image);
    const std::uint32_t glossier = imageOf(scene.materials.at(2).metallicRoughnessTexture);
    EXPECT_EQ(texelOf(scene.images.at(glossier)), (std::vector{0, 255 - 100, 0, 255}));
    EXPECT_EQ(scene.images.size(), 4u);
}

TEST(SpecularGlossiness, imagesOf16BitsKeepThem) {
    GltfFile file = fileWithMaterial(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
        "specularGlossinessTexture":{"index":0}}}})",
                                     0);
    const Bytes samples{0, 1, 0, 2, 0, 3, 0x12, 0x34};
    file.add("images", R"({"uri":"data:image/png;base64,)" +
                           base64(makePng(1, 1, 16, PngColor::rgba, samples)) + "\"}");
    file.add("textures", R"({"source":0})");
    const candela::Scene scene = load(file).scene;
    const std::uint32_t image = imageOf(scene.materials.at(0).metallicRoughnessTexture);
    ASSERT_EQ(scene.images.at(image).format, candela::PixelFormat::rgba16);
    std::uint16_t green = 0;
    std::memcpy(&green, scene.images.at(image).pixels.data() + 2, sizeof green);
    EXPECT_EQ(green, 0xFFFF - 0x1234);
}

TEST(SpecularGlossiness, anImageThatCannotBeReadIsNotedOnce) {
    GltfFile file = fileWithMaterial(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
        "glossinessFactor":0.75,"specularGlossinessTexture":{"index":0}}}})",
                                     0);
    file.add("images", R"({"uri":"data:image/png;base64,AAAA"})");
    file.add("textures", R"({"source":0})");
    const candela::ImportedScene imported = load(file);
    const candela::Material& material = imported.scene.materials.at(0);
    EXPECT_FALSE(material.metallicRoughnessTexture || material.specular.colorTexture);
    EXPECT_EQ(material.roughness, 0.25f);
    EXPECT_TRUE(hasNote(imported, "image 0: of no known format"));
}

// The same look in the extensions that took its place: the materials are equal, and so are their pictures.
TEST(SpecularGlossiness, isTheSameLookAsIorAndSpecular) {
    GltfFile file = fileWithMaterial(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
        "diffuseFactor":[0.5,0.25,0.125,1],"diffuseTexture":{"index":0},"specularFactor":[0.5,0.75,1],
        "glossinessFactor":0.5,"specularGlossinessTexture":{"index":1}}}})",
                                     1);
    for (const Bytes& image : {makePng(1, 1, 10, 20, 30, 100), makePng(1, 1, 99, 205, 0, 255)})
        file.add("images", R"({"uri":"data:image/png;base64,)" + base64(image) + "\"}");
    for (const char* texture : {R"({"source":1})", R"({"source":2})"}) file.add("textures", texture);
    file.add("materials", R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],
        "baseColorTexture":{"index":0},"metallicFactor":0,"metallicRoughnessTexture":{"index":2}},
        "extensions":{"KHR_materials_ior":{"ior":0},"KHR_materials_specular":{
        "specularColorFactor":[0.5,0.75,1],"specularColorTexture":{"index":1}}}})");
    const candela::Scene scene = load(file).scene;
    const candela::Material &old = scene.materials.at(0), &present = scene.materials.at(1);
    EXPECT_EQ(old.baseColor, present.baseColor);
    EXPECT_EQ(old.baseColorTexture, present.baseColorTexture);
    EXPECT_EQ(old.metallic, present.metallic);
    EXPECT_EQ(old.roughness, present.roughness);
    EXPECT_EQ(old.ior, present.ior);
    EXPECT_EQ(old.specular, present.specular);
    const auto greenOf = [&](const candela::Material& material) {
        return texelOf(scene.images.at(imageOf(material.metallicRoughnessTexture))).at(1);
    };
    EXPECT_EQ(greenOf(old), greenOf(present));
}

// Further sets of texture coordinates

/// A triangle with `sets` sets of texture coordinates, whose first coordinate at the first vertex is the
/// number of the set.
GltfFile fileWithSets(int sets, const std::string& material, std::uint8_t images = 3) {
    GltfFile file = fileWithMaterial(material, images);
    addTriangle(file);
    std::string attributes = R"("attributes":{"POSITION":0,"NORMAL":1)";
    for (int set = 0; set < sets; ++set) {
        const auto first = static_cast<float>(set);
        const int accessor = file.addData<float>("VEC2", {first, 0, 1, 0, 0, 1});
        attributes += ",\"TEXCOORD_" + std::to_string(set) + "\":" + std::to_string(accessor);
    }
    file.addMeshNode(attributes + R"(},"material":0)");
    return file;
}

TEST(UvSets, aSetBeyondTheSecondTakesAFreePlace) {
    const candela::ImportedScene imported = load(fileWithSets(5, R"({"normalTexture":{"index":0,"texCoord":4},
        "emissiveTexture":{"index":1,"texCoord":1}})"));
    const candela::Material& material = imported.scene.materials.at(0);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(material.normalTexture.value().uvSet, 0u);
    EXPECT_EQ(material.emissionTexture.value().uvSet, 1u);
    EXPECT_EQ(mesh.uv0.at(0), glm::vec2(4, 0));
    EXPECT_EQ(mesh.uv1.at(0), glm::vec2(1, 0));
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(UvSets, twoBeyondTheSecond) {
    const candela::Scene scene = load(fileWithSets(6, R"({"normalTexture":{"index":0,"texCoord":5},
        "occlusionTexture":{"index":2,"texCoord":5},"emissiveTexture":{"index":1,"texCoord":2}})"))
                                     .scene;
    const candela::Material& material = scene.materials.at(0);
    EXPECT_EQ(material.normalTexture.value().uvSet, material.occlusionTexture.value().uvSet);
    EXPECT_NE(material.normalTexture.value().uvSet, material.emissionTexture.value().uvSet);
    const candela::Mesh& mesh = scene.meshes.at(0);
    const auto firstOf = [&](const candela::Texture& texture) {
        return (texture.uvSet == 0 ? mesh.uv0 : mesh.uv1).at(0).x;
    };
    EXPECT_EQ(firstOf(*material.normalTexture), 5.0f);
    EXPECT_EQ(firstOf(*material.emissionTexture), 2.0f);
}

TEST(UvSets, setsThatNothingReadStayWhereTheyAre) {
    const candela::Mesh mesh = load(fileWithSets(3, R"({"normalTexture":{"index":0}})")).scene.meshes.at(0);
    EXPECT_EQ(mesh.uv0.at(0), glm::vec2(0, 0));
    EXPECT_EQ(mesh.uv1.at(0), glm::vec2(1, 0));
}

TEST(UvSets, threeAndMoreAreRead) {
    const candela::ImportedScene imported = load(fileWithSets(4, R"({"name":"far","pbrMetallicRoughness":{
        "baseColorTexture":{"index":0,"texCoord":3}},"normalTexture":{"index":1,"texCoord":0},
        "occlusionTexture":{"index":2,"texCoord":2}})"));
    const candela::Material& material = imported.scene.materials.at(0);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(material.normalTexture.value().uvSet, 0u);
    EXPECT_EQ(material.baseColorTexture.value().uvSet, 1u);
    EXPECT_EQ(material.occlusionTexture.value().uvSet, 2u);
    EXPECT_EQ(mesh.uv0.at(0), glm::vec2(0, 0));
    EXPECT_EQ(mesh.uv1.at(0), glm::vec2(3, 0));
    ASSERT_EQ(mesh.furtherUvs.size(), 1u);
    EXPECT_EQ(mesh.furtherUvs[0].at(0), glm::vec2(2, 0));
    EXPECT_TRUE(imported.report.notes.empty());
}

// Two meshes, whose materials read three sets and one: only the first has more than two.
TEST(UvSets, aMeshHasThoseThatItsMaterialsRead) {
    GltfFile file =
        fileWithSets(3, R"({"normalTexture":{"index":0},"emissiveTexture":{"index":1,"texCoord":1},
        "occlusionTexture":{"index":2,"texCoord":2}})");
    file.add("materials", R"({"normalTexture":{"index":0,"texCoord":2}})");
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":3,"TEXCOORD_2":4},
        "material":1)");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.meshes.at(0).furtherUvs.size(), 1u);
    EXPECT_TRUE(scene.meshes.at(1).furtherUvs.empty());
    EXPECT_EQ(scene.meshes[1].uv0.at(0), glm::vec2(2, 0));
}

/// A material whose 19 textures read 19 sets.
std::string materialOfNineteenSets() {
    int count = 0;
    const auto texture = [&](const char* name) {
        const std::string number = std::to_string(count++);
        return "\"" + std::string(name) + "\":{\"index\":" + number + ",\"texCoord\":" + number + "}";
    };
    const auto extension = [&](const char* name, std::initializer_list<const char*> textures) {
        std::string members;
        for (const char* member : textures) members += (members.empty() ? "" : ",") + texture(member);
        return "\"KHR_materials_" + std::string(name) + "\":{" + members + "}";
    };
    const std::string basic = "\"pbrMetallicRoughness\":{" + texture("baseColorTexture") + "," +
                              texture("metallicRoughnessTexture") + "}," + texture("normalTexture") + "," +
                              texture("emissiveTexture") + "," + texture("occlusionTexture");
    std::string lobes = extension("specular", {"specularTexture", "specularColorTexture"});
    lobes += "," + extension("clearcoat",
                             {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"});
    lobes += "," + extension("sheen", {"sheenColorTexture", "sheenRoughnessTexture"});
    lobes += "," + extension("anisotropy", {"anisotropyTexture"});
    lobes += "," + extension("iridescence", {"iridescenceTexture", "iridescenceThicknessTexture"});
    lobes += "," + extension("transmission", {"transmissionTexture"});
    lobes += "," + extension("volume", {"thicknessTexture"});
    lobes += "," + extension("diffuse_transmission",
                             {"diffuseTransmissionTexture", "diffuseTransmissionColorTexture"});
    return "{" + basic + ",\"extensions\":{" + lobes + "}}";
}

TEST(UvSets, theNineteenthOfAMaterialIsNotedAndOmitted) {
    GltfFile file = fileWithSets(19, materialOfNineteenSets(), 19);
    const candela::ImportedScene imported = load(file);
    const candela::Material& material = imported.scene.materials.at(0);
    EXPECT_EQ(imported.scene.meshes.at(0).furtherUvs.size(), 16u);
    EXPECT_EQ(material.diffuseTransmission.texture.value().uvSet, 17u);
    EXPECT_EQ(imported.scene.meshes[0].furtherUvs.at(15).at(0), glm::vec2(17, 0));
    EXPECT_FALSE(material.diffuseTransmission.colorTexture);
    EXPECT_TRUE(hasNote(imported,
                        "material 0, diffuseTransmissionColorTexture: more sets of texture coordinates than "
                        "a mesh may have, TEXCOORD_18: left out"));
}

TEST(UvSets, thoseWithTheSameAccessorAreOne) {
    GltfFile file = fileWithMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":2}},
        "normalTexture":{"index":1,"texCoord":0},"occlusionTexture":{"index":2,"texCoord":3},
        "emissiveTexture":{"index":2,"texCoord":1}})",
                                     3);
    addTriangle(file);
    for (const float first : {0.0f, 2.0f}) file.addData<float>("VEC2", {first, 0, 1, 0, 0, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":2,"TEXCOORD_2":3,
        "TEXCOORD_3":3},"material":0)");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    const candela::Material& material = imported.scene.materials.at(0);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    const auto firstOf = [&](const std::optional<candela::Texture>& texture) {
        return (texture.value().uvSet == 0 ? mesh.uv0 : mesh.uv1).at(0).x;
    };
    EXPECT_EQ(firstOf(material.baseColorTexture), 2.0f);
    EXPECT_EQ(firstOf(material.normalTexture), 0.0f);
    EXPECT_EQ(firstOf(material.occlusionTexture), 2.0f);
    EXPECT_EQ(firstOf(material.emissionTexture), 0.0f);
}

TEST(UvSets, aMissingOneIsZeroAndNoted) {
    const candela::ImportedScene imported =
        load(fileWithSets(1, R"({"normalTexture":{"index":0,"texCoord":7}})"));
    EXPECT_EQ(imported.scene.meshes.at(0).uv0, std::vector<glm::vec2>(3, glm::vec2(0)));
    EXPECT_TRUE(hasNote(imported, "mesh 0, primitive 0: no TEXCOORD_7, which material 0 reads"));
}

}  // namespace
}  // namespace candela_test
