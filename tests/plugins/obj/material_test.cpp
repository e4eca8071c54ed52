#include <gtest/gtest.h>

#include "../gltf/image_files.h"
#include "obj_scene.h"

#include <cstring>

namespace candela_test {
namespace {

const std::string faceOfM = squareVertices() + "vt 0 0\nmtllib a.mtl\nusemtl m\nf 1/1 2/1 3/1\n";

candela::ImportedScene loadMaterial(const std::string& statements, std::vector<SideFile> files = {}) {
    files.push_back({"a.mtl", "newmtl m\n" + statements});
    return loadObj(faceOfM, files);
}

candela::Material material(const std::string& statements) {
    return loadMaterial(statements).scene.materials.at(0);
}

std::string png(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255) {
    return textOf(makePng(1, 1, r, g, b, a));
}

/// One row of grey texels.
std::string greyPng(const Bytes& samples) {
    return textOf(makePng(static_cast<std::uint32_t>(samples.size()), 1, 8, PngColor::grey, samples));
}

std::vector<int> texels(const candela::Image& image) {
    std::vector<int> values;
    for (const auto byte : image.pixels) values.push_back(static_cast<int>(byte));
    return values;
}

const candela::Image& imageOf(const candela::ImportedScene& imported,
                              const std::optional<candela::Texture>& texture) {
    return imported.scene.images.at(texture.value().image);
}

TEST(ObjMaterial, factors) {
    const candela::Material m = material("Kd 0.1 0.2 0.3\nKe 4 5 6\nPr 0.25\nPm 0.75\nNs 10\n");
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
    EXPECT_EQ(m.emission, glm::vec3(4, 5, 6));
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.metallic, 0.75f);
    EXPECT_EQ(m.alphaMode, candela::AlphaMode::opaque);
    EXPECT_TRUE(m.doubleSided);
}

TEST(ObjMaterial, oneNumberIsGrey) {
    EXPECT_EQ(material("Kd 0.5\n").baseColor, glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
}

TEST(ObjMaterial, roughnessFromASpecularExponent) {
    // (2 / (n + 2))^(1/4) by hand; two square roots of single precision.
    EXPECT_FLOAT_EQ(material("Ns 30\n").roughness, 0.5f);
    EXPECT_FLOAT_EQ(material("Ns 0\n").roughness, 1.0f);
    EXPECT_FLOAT_EQ(material("").roughness, 1.0f);
    EXPECT_FLOAT_EQ(material("Ns 510\n").roughness, 0.25f);
}

TEST(ObjMaterial, opacityBlends) {
    for (const char* statement : {"d 0.25\n", "Tr 0.75\n", "Tr 0.1\nd 0.25\n", "d 0.25\nTr 0.1\n"}) {
        const auto imported = loadMaterial(statement);
        const candela::Material& m = imported.scene.materials.at(0);
        EXPECT_EQ(m.baseColor.a, 0.25f) << statement;
        EXPECT_EQ(m.alphaMode, candela::AlphaMode::blend);
        EXPECT_EQ(m.alphaCutoff, 0.5f);
    }
    EXPECT_EQ(material("d 1\n").alphaMode, candela::AlphaMode::opaque);
}

TEST(ObjMaterial, mapsMultiplyTheirFactors) {
    const auto imported = loadMaterial(
        "map_Kd textures\\a b.png\nmap_Ke e.png\nKe 0 0 0\nnorm -bm 0.5 n.png\n",
        {{"textures/a b.png", png(1, 2, 3)}, {"e.png", png(4, 5, 6)}, {"n.png", png(128, 128, 255)}});
    const candela::Material& m = imported.scene.materials.at(0);
    EXPECT_EQ(m.baseColor, glm::vec4(1, 1, 1, 1));
    EXPECT_EQ(m.emission, glm::vec3(1, 1, 1));
    EXPECT_EQ(m.normalScale, 0.5f);
    EXPECT_EQ(imageOf(imported, m.baseColorTexture).name, "textures/a b.png");
    EXPECT_EQ(texels(imageOf(imported, m.baseColorTexture)), (std::vector<int>{1, 2, 3, 255}));
    EXPECT_EQ(texels(imageOf(imported, m.emissionTexture)), (std::vector<int>{4, 5, 6, 255}));
    EXPECT_EQ(texels(imageOf(imported, m.normalTexture)), (std::vector<int>{128, 128, 255, 255}));
}

TEST(ObjMaterial, aBrokenImageIsNotedAndLeftOut) {
    Bytes cut = makePng(4, 4, 1, 2, 3, 4);
    cut.resize(60);
    const auto imported = loadMaterial("map_Kd c.png\n", {{"c.png", textOf(cut)}});
    EXPECT_FALSE(imported.scene.materials.at(0).baseColorTexture);
    EXPECT_TRUE(hasNote(imported, "a.mtl, line 2: map_Kd 'c.png': the PNG file is broken"));
}

TEST(ObjMaterial, roughnessAndMetallicMapsBecomeOneImage) {
    const auto imported = loadMaterial("map_Pr r.png\nmap_Pm m.png\nPm 0.5\n",
                                       {{"r.png", greyPng({10, 20})}, {"m.png", greyPng({30, 40, 50, 60})}});
    const candela::Material& m = imported.scene.materials.at(0);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.metallic, 0.5f);
    const candela::Image& image = imageOf(imported, m.metallicRoughnessTexture);
    EXPECT_EQ(image.width, 4u);
    EXPECT_EQ(texels(image),
              (std::vector<int>{255, 10, 30, 255, 255, 10, 40, 255, 255, 20, 50, 255, 255, 20, 60, 255}));
}

TEST(ObjMaterial, aRoughnessOrMetallicMapAloneKeepsTheOtherFactor) {
    const auto imported = loadMaterial("map_Pr -imfchan b r.png\nPm 0.5\n", {{"r.png", png(1, 2, 3)}});
    EXPECT_EQ(imported.scene.materials.at(0).metallic, 0.5f);
    EXPECT_EQ(texels(imported.scene.images.at(0)), (std::vector<int>{255, 3, 255, 255}));
    const auto metal = loadMaterial("map_Pm m.png\nNs 30\n", {{"m.png", png(7, 7, 7)}});
    EXPECT_FLOAT_EQ(metal.scene.materials.at(0).roughness, 0.5f);
    EXPECT_EQ(texels(metal.scene.images.at(0)), (std::vector<int>{255, 255, 7, 255}));
}

TEST(ObjMaterial, sixteenBitMapsStaySixteenBit) {
    const auto imported = loadMaterial(
        "map_Pr r.png\nmap_Pm m.png\n",
        {{"r.png", textOf(makePng(1, 1, 16, PngColor::grey, {0x12, 0x34}))}, {"m.png", greyPng({0x56})}});
    const candela::Image& image = imported.scene.images.at(0);
    ASSERT_EQ(image.format, candela::PixelFormat::rgba16);
    std::uint16_t samples[4];
    std::memcpy(samples, image.pixels.data(), sizeof samples);
    EXPECT_EQ(samples[1], 0x1234);
    EXPECT_EQ(samples[2], 0x5656);
}

TEST(ObjMaterial, anOpacityMapBecomesAlpha) {
    const auto imported =
        loadMaterial("map_Kd c.png\nmap_d a.png\n", {{"c.png", png(1, 2, 3, 77)}, {"a.png", png(9, 9, 9)}});
    EXPECT_EQ(texels(imported.scene.images.at(0)), (std::vector<int>{1, 2, 3, 9}));
    EXPECT_EQ(imported.scene.materials.at(0).alphaMode, candela::AlphaMode::blend);
}

TEST(ObjMaterial, anOpacityMapWithAnAlphaChannelUsesIt) {
    const auto same = loadMaterial("map_Kd c.png\nmap_d c.png\n", {{"c.png", png(1, 2, 3, 77)}});
    EXPECT_EQ(texels(same.scene.images.at(0)), (std::vector<int>{1, 2, 3, 77}));
    const auto alone = loadMaterial("map_d c.png\n", {{"c.png", png(1, 2, 3, 77)}});
    EXPECT_EQ(texels(alone.scene.images.at(0)), (std::vector<int>{255, 255, 255, 77}));
}

TEST(ObjMaterial, alphaOfAColorMapAloneIsIgnored) {
    const auto imported = loadMaterial("map_Kd c.png\n", {{"c.png", png(1, 2, 3, 77)}});
    EXPECT_EQ(imported.scene.materials.at(0).alphaMode, candela::AlphaMode::opaque);
}

TEST(ObjMaterial, optionsSetTheTextureTransform) {
    const auto imported =
        loadMaterial("map_Kd -clamp on -s 2 3 1 -o 0.25 0.5 c.png\n", {{"c.png", png(1, 2, 3)}});
    const candela::Texture texture = imported.scene.materials.at(0).baseColorTexture.value();
    EXPECT_EQ(texture.wrapS, candela::Wrap::clampToEdge);
    EXPECT_EQ(texture.wrapT, candela::Wrap::clampToEdge);
    EXPECT_EQ(texture.scale, glm::vec2(2, 3));
    // v upwards: 0.5 + 3 v; downwards, with v = 1 - w: 1 - (0.5 + 3 (1 - w)) = -2.5 + 3 w.
    EXPECT_EQ(texture.offset, glm::vec2(0.25f, -2.5f));
}

TEST(ObjMaterial, aFileNameMayBeANumber) {
    const auto imported = loadMaterial("map_Kd -s 2 5\n", {{"5", png(1, 2, 3)}});
    EXPECT_EQ(imported.scene.materials.at(0).baseColorTexture.value().scale, glm::vec2(2, 1));
    EXPECT_EQ(imported.scene.images.at(0).name, "5");
}

TEST(ObjMaterial, optionsThatAreNotDrawnAreNoted) {
    const auto imported =
        loadMaterial("map_Kd -blendu on -mm 0.5 1 -t 1 1 1 -texres 512 -boost 2 -new 3 c.png\n",
                     {{"c.png", png(1, 2, 3)}});
    EXPECT_EQ(noteLines(imported), (Lines{"a.mtl: not drawn: option -mm (once, in line 2)",
                                          "a.mtl: not drawn: option -t (once, in line 2)",
                                          "a.mtl: not known: option -new (once, in line 2)"}));
    EXPECT_EQ(imported.scene.images.size(), 1u);
    EXPECT_TRUE(loadMaterial("map_Kd -mm 0 1 c.png\n", {{"c.png", png(1, 2, 3)}}).report.notes.empty());
}

TEST(ObjMaterial, optionsThatDifferAreNoted) {
    const auto imported =
        loadMaterial("map_Pr -s 2 2 r.png\nmap_Pm -s 3 3 r.png\n", {{"r.png", png(1, 1, 1)}});
    EXPECT_TRUE(
        hasNote(imported, "a.mtl, line 3: map_Pm: its options are not used, but those of a.mtl, line 2"));
}

TEST(ObjMaterial, aSharedImageIsAddedOnce) {
    const auto imported =
        loadObj(squareVertices() + "mtllib a.mtl\nusemtl m\nf 1 2 3\nusemtl n\nf 2 3 4\nusemtl m\nf 1 3 4\n",
                {{"a.mtl",
                  "newmtl n\nmap_Kd c.png\nmap_Pr r.png\nnewmtl unused\n"
                  "map_Kd absent.png\nnewmtl m\nmap_Kd c.png\nmap_Pr r.png\n"},
                 {"c.png", png(1, 2, 3)},
                 {"r.png", png(4, 4, 4)}});
    EXPECT_EQ(imported.scene.images.size(), 2u);
    EXPECT_EQ(imported.scene.materials.size(), 2u);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    ASSERT_EQ(mesh.submeshes.size(), 2u);
    EXPECT_EQ(mesh.submeshes[0].material, 0u);
    EXPECT_EQ(mesh.submeshes[0].indexCount, 6u);
    EXPECT_EQ(mesh.submeshes[1].material, 1u);
    EXPECT_EQ(imported.scene.materials[1].name, "n");
}

TEST(ObjMaterial, severalLibrariesWithSpacesInTheirNames) {
    const auto imported =
        loadObj(squareVertices() + "mtllib my first.mtl sub/b.MTL\nusemtl a 1\nf 1 2 3\nusemtl b\nf 2 3 4\n",
                {{"my first.mtl", "newmtl a 1\nPm 1\n"},
                 {"sub/b.MTL", "newmtl b\nmap_Kd c.png\n"},
                 {"sub/c.png", png(1, 2, 3)}});
    ASSERT_EQ(imported.scene.materials.size(), 2u);
    EXPECT_EQ(imported.scene.materials[0].name, "a 1");
    EXPECT_EQ(imported.scene.materials[1].name, "b");
    EXPECT_EQ(imported.scene.images.at(0).name, "sub/c.png");
}

TEST(ObjMaterial, missingTextureCoordinatesAreZero) {
    const auto imported = loadObj(squareVertices() + "mtllib a.mtl\nusemtl b\nf 1 2 3 4\n",
                                  {{"a.mtl", "newmtl b\nmap_Kd c.png\n"}, {"c.png", png(1, 2, 3)}});
    EXPECT_EQ(imported.scene.meshes.at(0).uv0, std::vector<glm::vec2>(4, glm::vec2(0)));
    EXPECT_TRUE(hasNote(imported, "4 corners have no texture coordinate and take (0, 0)"));
}

TEST(ObjMaterial, statementsThatAreNotDrawnAreNoted) {
    const auto imported = loadMaterial(
        "Ps 1\nPc 1\naniso 1\nmap_Ns c.png\ndisp c.png\nrefl c.png\nd -halo 1\nKd spectral a.rfl\nwhat 3\n");
    for (const char* keyword : {"Ps", "Pc", "aniso", "map_Ns", "disp", "refl", "option -halo of d"})
        EXPECT_TRUE(hasNote(imported, "a.mtl: not drawn: " + std::string(keyword) + " (once")) << keyword;
    EXPECT_TRUE(hasNote(imported, "a.mtl: not used: Kd other than r g b (once, in line 9)"));
    EXPECT_TRUE(hasNote(imported, "a.mtl: not known: what (once, in line 10)"));
    EXPECT_EQ(imported.report.notes.size(), 9u);
}

TEST(ObjMaterial, anUnsupportedImageFormatIsNotedAndOmitted) {
    const auto imported = loadMaterial("map_Kd c.tga\nmap_d c.tga\n", {{"c.tga", "xxxx"}});
    EXPECT_TRUE(hasNote(
        imported,
        "a.mtl, line 2: map_Kd 'c.tga': of no known format, expected PNG, JPEG, WebP or KTX2: left out"));
    EXPECT_TRUE(imported.scene.images.empty());
    EXPECT_FALSE(imported.scene.materials.at(0).baseColorTexture.has_value());
}

TEST(ObjMaterial, theFirstOfTwoDefinitionsIsUsed) {
    const auto imported = loadMaterial("Pm 1\nnewmtl m\nPm 0\n");
    EXPECT_EQ(imported.scene.materials.at(0).metallic, 1.0f);
    EXPECT_TRUE(hasNote(imported, "a.mtl, line 3: newmtl 'm': defined before: left out"));
}

}  // namespace
}  // namespace candela_test
