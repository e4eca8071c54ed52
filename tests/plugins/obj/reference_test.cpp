// The files that OBJ and MTL files name, where they are missing, elsewhere or named in the manner of another
// system.
#include <gtest/gtest.h>

#include <filesystem>

#include "../gltf/image_files.h"
#include "obj_scene.h"

namespace candela_test {
namespace {

namespace fs = std::filesystem;

const std::string faceOfM = squareVertices() + "vt 0 0\nmtllib a.mtl\nusemtl m\nf 1/1 2/1 3/1\n";

std::string png() {
    return textOf(makePng(1, 1, 10, 20, 30, 255));
}

candela::ImportedScene loadMap(const std::string& statement, std::vector<SideFile> files) {
    files.push_back({"a.mtl", "newmtl m\n" + statement + "\n"});
    return loadObj(faceOfM, files);
}

bool hasTexture(const candela::ImportedScene& imported) {
    return imported.scene.materials.at(0).baseColorTexture.has_value();
}

TEST(ObjReference, AMissingTextureIsLeftOut) {
    const auto imported = loadMap("map_Kd lost.png", {});
    EXPECT_FALSE(hasTexture(imported));
    EXPECT_EQ(imported.scene.materials.at(0).baseColor, glm::vec4(1));
    EXPECT_EQ(noteLines(imported),
              Lines{"a.mtl, line 2: map_Kd 'lost.png': No such file or directory: left out"});
}

TEST(ObjReference, WithoutItsMapAValueIsWhatItWasBeforeMaps) {
    const auto imported = loadMap(
        "map_Pr lost.png\nmap_Pm lost.png\nNs 30\nKe 1 1 1\nmap_Ke lost.png\nmap_d lost.png\nnorm lost.png",
        {});
    const candela::Material& material = imported.scene.materials.at(0);
    EXPECT_FLOAT_EQ(material.roughness, 0.5f);
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.emission, glm::vec3(0));
    EXPECT_EQ(material.alphaMode, candela::AlphaMode::opaque);
    EXPECT_EQ(noteLines(imported),
              Lines{"a.mtl, line 7: map_d 'lost.png': No such file or directory: left out"});
}

TEST(ObjReference, OnePartOfACombinedImageMayBeBroken) {
    const std::string cut = png().substr(0, 60);
    const auto mask = loadMap("map_Kd c.png\nmap_d cut.png", {{"c.png", png()}, {"cut.png", cut}});
    EXPECT_TRUE(hasTexture(mask));
    EXPECT_EQ(mask.scene.materials.at(0).alphaMode, candela::AlphaMode::opaque);
    EXPECT_TRUE(hasNote(mask, "a.mtl, line 3: map_d 'cut.png': the PNG file is broken"));
    const auto rough = loadMap("map_Pr cut.png\nmap_Pm c.png\nPr 0.25", {{"c.png", png()}, {"cut.png", cut}});
    EXPECT_EQ(rough.scene.materials.at(0).roughness, 0.25f);
    EXPECT_EQ(rough.scene.materials.at(0).metallic, 1.0f);
    EXPECT_FALSE(hasTexture(loadMap("map_Kd cut.png", {{"cut.png", cut}})));
}

TEST(ObjReference, NothingOutsideTheFolderIsRead) {
    const TemporaryFolder folder;
    folder.write("secret.png", makePng(1, 1, 1, 2, 3, 4));
    folder.write("scene/a.mtl", "newmtl m\nmap_Kd ../secret.png\n");
    const auto imported = loadPath(folder.write("scene/scene.obj", faceOfM));
    EXPECT_FALSE(hasTexture(imported));
    EXPECT_EQ(noteLines(imported),
              Lines{"a.mtl, line 2: map_Kd '../secret.png': it leads out of the scene's folder: left out"});
    folder.write("outside.mtl", "newmtl m\nPm 1\n");
    const auto library =
        loadPath(folder.write("scene/b.obj", "mtllib ../outside.mtl\n" + squareVertices() + "f 1 2 3\n"));
    EXPECT_EQ(noteLines(library),
              Lines{"material file '../outside.mtl': it leads out of the scene's folder: its "
                    "materials are drawn as the default one"});
}

TEST(ObjReference, PathsOfOtherMachinesAreTriedByTheirBareNames) {
    for (const char* path : {"C:\\maps\\wood.png", "C:/maps/wood.png", "C:wood.png", "/srv/wood.png",
                             "..\\..\\wood.png", "\\\\server\\share\\wood.png", "file:///tmp/wood.png",
                             "textures\\wood.png", "\"C:\\my maps\\wood.png\""}) {
        const auto imported = loadMap(std::string("map_Kd ") + path, {{"wood.png", png()}});
        EXPECT_TRUE(hasTexture(imported)) << path;
        EXPECT_TRUE(hasNote(imported, "not at this path: a file of this name in the scene's folder is read"))
            << path;
        const auto missing = loadMap(std::string("map_Kd ") + path, {});
        EXPECT_FALSE(hasTexture(missing)) << path;
        EXPECT_EQ(missing.report.notes.size(), 1u) << path;
    }
    EXPECT_TRUE(hasNote(
        loadMap("map_Kd C:\\maps\\wood.png", {}),
        "map_Kd 'C:\\maps\\wood.png': an absolute path, and the scene's folder has no file of this name"));
}

TEST(ObjReference, PathsThatAreMeantWell) {
    const std::vector<std::pair<const char*, const char*>> cases{{"map_Kd maps\\wood.png", "maps/wood.png"},
                                                                 {"map_Kd ./wood.png", "wood.png"},
                                                                 {"map_Kd \"my wood.png\"", "my wood.png"},
                                                                 {"map_Kd my wood.png", "my wood.png"},
                                                                 {"map_Kd wood - 1.png", "wood - 1.png"},
                                                                 {"map_Kd maps\\wood.png", "maps\\wood.png"},
                                                                 {"map_Kd wood#1.png", "wood#1.png"},
                                                                 {"map_Kd wood.png # planks", "wood.png"},
                                                                 {"map_Kd -1.png", "-1.png"},
                                                                 {"map_Kd my%20wood.png", "my wood.png"},
                                                                 {"map_Kd 100%.png", "100%.png"},
                                                                 {"map_Kd Fl\xE4"
                                                                  "che.png",
                                                                  "Fl\xC3\xA4"
                                                                  "che.png"},

                                                                 {"map_Kd wood.png  ", "wood.png"}};
    for (const auto& [statement, file] : cases) {
        const auto imported = loadMap(statement, {{file, png()}});
        EXPECT_TRUE(hasTexture(imported)) << statement;
        EXPECT_TRUE(imported.report.notes.empty()) << statement;
    }
}

TEST(ObjReference, AFileIsFoundInAnotherCase) {
    const auto imported = loadMap("map_Kd Maps\\Wood.PNG", {{"maps/wood.png", png()}});
    EXPECT_TRUE(hasTexture(imported));
    EXPECT_EQ(imported.report.notes.size(), 1u);
    EXPECT_TRUE(hasNote(imported, "file 'Maps/Wood.PNG'"));
}

TEST(ObjReference, TexturesBesideTheMaterialFileOrTheScene) {
    for (const char* place : {"sub/wood.png", "wood.png"}) {
        const auto imported =
            loadObj(squareVertices() + "vt 0 0\nmtllib sub/a.mtl\nusemtl m\nf 1/1 2/1 3/1\n",
                    {{"sub/a.mtl", "newmtl m\nmap_Kd wood.png\n"}, {place, png()}});
        EXPECT_TRUE(hasTexture(imported)) << place;
        EXPECT_TRUE(imported.report.notes.empty()) << place;
    }
}

TEST(ObjReference, StatementsWithoutAFile) {
    for (const char* statement :
         {"map_Kd .", "map_Kd", "map_Kd ./", "map_Kd -clamp on", "map_Kd \"\"", "map_Kd .\\"}) {
        const auto imported = loadMap(std::string("Kd 0.5 0.5 0.5\n") + statement + "\nPm 0.5", {});
        EXPECT_FALSE(hasTexture(imported)) << statement;
        EXPECT_EQ(imported.scene.materials.at(0).baseColor, glm::vec4(0.5f, 0.5f, 0.5f, 1)) << statement;
        EXPECT_EQ(imported.scene.materials.at(0).metallic, 0.5f) << statement;
        EXPECT_EQ(imported.report.notes.size(), 1u) << statement;
    }
    EXPECT_TRUE(hasNote(loadMap("map_Kd .", {}), "a.mtl, line 2: map_Kd: '.' is no file: left out"));
}

TEST(ObjReference, AFolderAtTheEndOfALineDoesNotTakeTheNextLine) {
    const auto imported = loadMap("map_Kd C:\\maps\\\nPm 0.5", {});
    EXPECT_EQ(imported.scene.materials.at(0).metallic, 0.5f);
    EXPECT_EQ(loadMap("map_Kd -s 2 3 \\\n wood.png", {{"wood.png", png()}})
                  .scene.materials.at(0)
                  .baseColorTexture->scale,
              glm::vec2(2, 3));
}

TEST(ObjReference, OptionsInAnyOrder) {
    for (const char* statement :
         {"map_Kd -s 2 3 -o 0.25 0 0 wood.png", "map_Kd wood.png -o 0.25 0 0 -s 2 3",
          "map_Kd -o 0.25 wood.png -s 2 3 1", "map_Kd -colorspace sRGB -s 2 3 1 -o 0.25 0 0 wood.png",
          "map_Kd -gamma 2.2 -o 0.25 -s 2 3 wood.png", "map_Kd -srgb -o 0.25 -s 2 3 wood.png"}) {
        const auto imported = loadMap(statement, {{"wood.png", png()}});
        ASSERT_TRUE(hasTexture(imported)) << statement;
        EXPECT_EQ(imported.scene.materials.at(0).baseColorTexture->scale, glm::vec2(2, 3)) << statement;
        EXPECT_EQ(imported.scene.materials.at(0).baseColorTexture->offset.x, 0.25f) << statement;
    }
    EXPECT_TRUE(hasTexture(loadMap("map_Kd -srgb my wood.png", {{"my wood.png", png()}})));
    EXPECT_TRUE(hasTexture(loadMap("map_Kd wood.png -new 3", {{"wood.png", png()}})));
    EXPECT_TRUE(hasTexture(loadMap("map_Kd wood -s 2.png", {{"wood -s 2.png", png()}})));
}

TEST(ObjReference, OptionsWithoutAUsableValueAreNotUsed) {
    for (const char* option : {"-s nan", "-o 1e9 0", "-s", "-clamp", "-clamp maybe", "-imfchan q", "-bm x"}) {
        const auto imported = loadMap(std::string("map_Kd ") + option + " wood.png", {{"wood.png", png()}});
        EXPECT_TRUE(hasTexture(imported)) << option;
        EXPECT_TRUE(hasNote(imported, "not used")) << option;
    }
}

TEST(ObjReference, AMissingMaterialFileIsNoted) {
    const auto imported =
        loadObj("mtllib scan.mtl\nusemtl a\n" + squareVertices() + "f 1 2 3\nusemtl b\nf 2 3 4\n");
    EXPECT_EQ(imported.scene.materials.size(), 1u);
    EXPECT_EQ(noteLines(imported),
              Lines{"material file 'scan.mtl': No such file or directory: its materials are drawn "
                    "as the default one"});
}

TEST(ObjReference, AMaterialFileOfTheScenesOwnNameTakesThePlaceOfAMissingOne) {
    const std::vector<SideFile> files{{"scene.mtl", "newmtl m\nPm 1\n"}};
    const auto renamed = loadObj("mtllib old.mtl\nusemtl m\n" + squareVertices() + "f 1 2 3\n", files);
    EXPECT_EQ(renamed.scene.materials.at(0).metallic, 1.0f);
    EXPECT_EQ(noteLines(renamed),
              Lines{"material file 'old.mtl': No such file or directory: 'scene.mtl' is read in its place"});
    const auto unnamed = loadObj("usemtl m\n" + squareVertices() + "f 1 2 3\n", files);
    EXPECT_EQ(unnamed.scene.materials.at(0).metallic, 1.0f);
    EXPECT_EQ(noteLines(unnamed), Lines{"material file 'scene.mtl': read, though no mtllib names it"});
}

TEST(ObjReference, MaterialFilesAsTheyAreNamed) {
    const std::vector<SideFile> files{{"my stones.mtl", "newmtl m\nPm 1\n"},
                                      {"plain.txt", "newmtl m\nPm 1\n"}};
    for (const char* name : {"my stones.mtl", "\"my stones.mtl\"", ".\\my stones.mtl", "C:\\x\\my stones.mtl",
                             "plain.txt", "gone plain.txt", "My Stones.MTL"}) {
        const auto imported =
            loadObj(std::string("mtllib ") + name + "\nusemtl m\n" + squareVertices() + "f 1 2 3\n", files);
        EXPECT_EQ(imported.scene.materials.at(0).metallic, 1.0f) << name;
    }
}

TEST(ObjReference, AMaterialFileThatIsNamedTwiceIsReadOnce) {
    const auto imported =
        loadObj("mtllib a.mtl\nmtllib a.mtl ./a.mtl\nusemtl m\n" + squareVertices() + "f 1 2 3\n",
                {{"a.mtl", "newmtl m\nPm 1\n"}});
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjReference, MtllibWithoutAName) {
    const auto imported = loadObj("mtllib\n" + squareVertices() + "f 1 2 3\n");
    EXPECT_EQ(noteLines(imported), Lines{"mtllib without the name of a file: not used (once, in line 1)"});
}

TEST(ObjReference, AMaterialIsFoundInAnotherCase) {
    const auto imported = loadObj("mtllib a.mtl\nusemtl Wood\n" + squareVertices() + "f 1 2 3\n",
                                  {{"a.mtl", "newmtl wood\nPm 1\n"}});
    EXPECT_EQ(imported.scene.materials.at(0).metallic, 1.0f);
    EXPECT_TRUE(
        hasNote(imported, "material 'Wood': its name in the material file differs in upper and lower case"));
}

}  // namespace
}  // namespace candela_test
