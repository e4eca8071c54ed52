// Materials as programs write them, where their letter means something else.
#include <gtest/gtest.h>

#include "../gltf/image_files.h"
#include "obj_scene.h"

namespace candela_test {
namespace {

const std::string faceOfM = squareVertices() + "vt 0 0\nmtllib a.mtl\nusemtl m\nf 1/1 2/1 3/1\n";

candela::ImportedScene loadMaterial(const std::string& statements) {
    return loadObj(faceOfM, {{"a.mtl", "newmtl m\n" + statements},
                             {"c.png", textOf(makePng(1, 1, 10, 20, 30, 255))},
                             {"alpha.png", textOf(makePng(1, 1, 10, 20, 30, 77))},
                             {"normals.png", textOf(makePng(1, 1, 128, 128, 255, 255))},
                             {"heights.png", textOf(makePng(1, 1, 200, 200, 200, 255))}});
}

struct Case {
    const char* statements;
    float opacity;
    const char* note;  ///< NULL for none.
};

TEST(ObjExporter, AKdOf0BesideAMapIsWhite) {
    for (const char* map : {"map_Kd c.png\n", "map_Kd lost.png\n", "map_Kd .\n"}) {
        const auto imported = loadMaterial(std::string("Kd 0.00 0.00 0.00\n") + map);
        EXPECT_EQ(imported.scene.materials.at(0).baseColor, glm::vec4(1)) << map;
        EXPECT_TRUE(hasNote(imported, "a.mtl, line 1: newmtl 'm': Kd is 0 beside map_Kd: taken as 1"));
    }
    EXPECT_EQ(loadMaterial("Kd 0 0 0\n").scene.materials.at(0).baseColor, glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(loadMaterial("Kd 0 0 0.5\nmap_Kd c.png\n").scene.materials.at(0).baseColor,
              glm::vec4(0, 0, 0.5f, 1));
}

TEST(ObjExporter, Opacity) {
    constexpr const char *zero = "d is 0, which Tr does not confirm",
                         *one = "Tr is 1 without d: taken as opaque";
    const std::vector<Case> cases{{"", 1.0f, nullptr},
                                  {"d 0\n", 1.0f, zero},
                                  {"Tr 1\n", 1.0f, one},
                                  {"Tr 0\n", 1.0f, nullptr},
                                  {"Tr 0.25\n", 0.75f, nullptr},
                                  {"d 0\nTr 0\n", 1.0f, zero},
                                  {"d 0\nTr 0.25\n", 0.75f, zero},
                                  {"Tr 1\nd 0\n", 0.0f, nullptr},
                                  {"d 1\nTr 1\n", 1.0f, nullptr},
                                  {"d 1\nTr 0\n", 1.0f, nullptr},
                                  {"d 0.5\nTr 1\n", 0.5f, nullptr},
                                  {"d 0\nmap_d alpha.png\n", 1.0f, "d is 0 beside map_d: not used"},
                                  {"Tr 1\nmap_d alpha.png\n", 1.0f, one},
                                  {"d 1.5\n", 1.0f, "a.mtl, line 2: d is above 1: taken as 1"},
                                  {"Tr -0.5\n", 1.0f, "a.mtl, line 2: Tr is below 0: taken as 0"}};
    for (const Case& test : cases) {
        const auto imported = loadMaterial(test.statements);
        EXPECT_EQ(imported.scene.materials.at(0).baseColor.a, test.opacity) << test.statements;
        if (test.note)
            EXPECT_TRUE(hasNote(imported, test.note)) << test.statements;
        else
            EXPECT_TRUE(imported.report.notes.empty()) << test.statements;
    }
}

TEST(ObjExporter, AnExponentBelow0IsRough) {
    const auto imported = loadMaterial("Ns -1.960784\n");
    EXPECT_EQ(imported.scene.materials.at(0).roughness, 1.0f);
    EXPECT_EQ(noteLines(imported), Lines{"a.mtl, line 2: Ns is below 0: taken as 0"});
}

TEST(ObjExporter, ValuesBeyondTheirRangeAreHeld) {
    const auto imported = loadMaterial("Kd 1.0000000000000002 -1 2\nKe -1 1e30 inf\nPr 7\nPm -7\nNs 1e39\n");
    const candela::Material& material = imported.scene.materials.at(0);
    EXPECT_EQ(material.baseColor, glm::vec4(1, 0, 1, 1));
    EXPECT_EQ(material.emission, glm::vec3(0, 1e20f, 1e20f));
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_TRUE(hasNote(imported, "a.mtl, line 2: Kd is above 1: taken as 1"));
    EXPECT_TRUE(hasNote(imported, "a.mtl, line 2: Kd is below 0: taken as 0"));
    EXPECT_TRUE(hasNote(imported, "a.mtl, line 3: Ke is too large: held at the limit"));
}

TEST(ObjExporter, StatementsThatCannotBeReadAreNotUsed) {
    const std::vector<std::pair<const char*, const char*>> cases{
        {"Kd", "Kd: r g b was expected, but the line ends: not used"},
        {"Kd 1 1", "Kd: r g b was expected, but the line ends: not used"},
        {"Kd nan 0 0", "Kd: 'nan' is not a number: not used"},
        {"Ns x", "Ns: 'x' is not a number: not used"},
        {"Pr", "Pr: a number was expected, but the line ends: not used"}};
    for (const auto& [statement, note] : cases) {
        const auto imported = loadMaterial(std::string(statement) + "\nPm 0.5\n");
        EXPECT_EQ(imported.scene.materials.at(0).metallic, 0.5f) << statement;
        EXPECT_EQ(imported.scene.materials.at(0).baseColor, glm::vec4(1)) << statement;
        EXPECT_EQ(noteLines(imported), Lines{std::string("a.mtl, line 2: ") + note});
    }
    const auto early = loadObj(faceOfM, {{"a.mtl", "Kd 1 0 0\nnewmtl m\nKd 0,5 0,25 0,125\n"}});
    EXPECT_EQ(early.scene.materials.at(0).baseColor, glm::vec4(0.5f, 0.25f, 0.125f, 1));
    EXPECT_TRUE(hasNote(early, "a.mtl, line 1: Kd: no newmtl precedes it: not used"));
    EXPECT_TRUE(hasNote(early, "a.mtl, line 3: Kd: a decimal comma, read as a point"));
}

TEST(ObjExporter, WhatAMaterialHasNoPlaceForIsNotNoted) {
    const auto imported = loadMaterial(
        "Ka 1 1 1\nKs 1 1 1\nNi 1.45\nTf 1 1 1\nillum 2\nsharpness 60\nmap_Ka c.png\nmap_Ks c.png\n"
        "Ps 0.0\nPc 0\nPcr 0.03\naniso 0\nanisor 0\n");
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjExporter, AMapOfOpacityThatIsTheColorMeansItsAlpha) {
    const auto opaque = loadMaterial("map_Kd c.png\nmap_d c.png\n");
    EXPECT_EQ(opaque.scene.materials.at(0).alphaMode, candela::AlphaMode::opaque);
    EXPECT_TRUE(opaque.report.notes.empty());
    EXPECT_EQ(loadMaterial("map_Kd alpha.png\nmap_d alpha.png\n").scene.materials.at(0).alphaMode,
              candela::AlphaMode::blend);
}

TEST(ObjExporter, ABumpMapOfNormalsIsANormalMap) {
    for (const char* keyword : {"map_Bump", "map_bump", "bump"}) {
        const auto imported = loadMaterial(std::string(keyword) + " -bm 0.5 normals.png\n");
        EXPECT_TRUE(imported.scene.materials.at(0).normalTexture.has_value()) << keyword;
        EXPECT_EQ(imported.scene.materials.at(0).normalScale, 0.5f);
        EXPECT_TRUE(imported.report.notes.empty());
    }
    const auto heights = loadMaterial("bump heights.png\n");
    EXPECT_FALSE(heights.scene.materials.at(0).normalTexture.has_value());
    EXPECT_EQ(noteLines(heights),
              Lines{"a.mtl, line 2: bump 'heights.png': a height map, which is not drawn: left out"});
    // Of both, the normal map counts.
    EXPECT_TRUE(loadMaterial("bump heights.png\nnorm normals.png\n").report.notes.empty());
}

TEST(ObjExporter, FacesWithoutAMaterialAreDoubleSided) {
    for (const char* use : {"", "usemtl\n", "usemtl gone\n"}) {
        const auto imported = loadObj(squareVertices() + use + "f 1 2 3 4\n");
        const candela::Material& material =
            imported.scene.materials.at(imported.scene.meshes.at(0).submeshes.at(0).material.value());
        EXPECT_TRUE(material.doubleSided) << use;
        EXPECT_EQ(material.baseColor, glm::vec4(1));
        EXPECT_EQ(material.roughness, 1.0f);
        EXPECT_EQ(material.metallic, 0.0f);
    }
}

TEST(ObjExporter, OneDefaultMaterialServesAllFaces) {
    const auto imported = loadObj(squareVertices() + "f 1 2 3\nusemtl a\nf 1 3 4\nusemtl b\nf 2 3 4\n");
    EXPECT_EQ(imported.scene.materials.size(), 1u);
    EXPECT_EQ(imported.scene.meshes.at(0).submeshes.size(), 1u);
    EXPECT_EQ(noteLines(imported),
              Lines{"material 'a' and 1 more: in no material file: the default one is drawn"});
}

}  // namespace
}  // namespace candela_test
