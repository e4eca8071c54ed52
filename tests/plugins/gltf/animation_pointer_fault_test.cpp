// KHR_animation_pointer: what becomes of pointers and values that are wrong.
#include <gtest/gtest.h>

#include "loading.h"
#include "pointer_file.h"

namespace candela_test {
namespace {

TEST(AnimationPointer, valuesOutOfRangeAreClampedWithANote) {
    GltfFile file = fileOfEverything();
    const int times = file.addData<float>("SCALAR", {0, 1});
    animate(file, "/materials/0/extensions/KHR_materials_ior/ior", times,
            file.addData<float>("SCALAR", {0.5f, 2.0f}));
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(imported.scene.animations.at(0).properties.at(0).values, (std::vector<float>{1, 2}));
    EXPECT_TRUE(hasNote(imported, "animation 0, channel 0: values that the property does not have: clamped"));
}

TEST(AnimationPointer, visibilityHasStepsAndBytes) {
    const auto complaints = [](const std::string& interpolation, bool bytes) {
        GltfFile file = fileOfEverything();
        const std::size_t count = interpolation == "CUBICSPLINE" ? 6 : 2;
        const int times = file.addData<float>("SCALAR", {0, 1});
        const int flags = bytes ? file.addData<std::uint8_t>("SCALAR", std::vector<std::uint8_t>(count, 1))
                                : file.addData<float>("SCALAR", std::vector<float>(count, 1.0f));
        animate(file, "/nodes/0/extensions/KHR_node_visibility/visible", times, flags, interpolation);
        return complaintsOf(file);
    };
    EXPECT_EQ(complaints("STEP", true), "");
    EXPECT_NE(complaints("LINEAR", true)
                  .find("animation 0, channel 0: a linear interpolation of what is true or "
                        "false: taken as STEP"),
              std::string::npos);
    EXPECT_NE(complaints("CUBICSPLINE", true)
                  .find("animation 0, channel 0: interpolation CUBICSPLINE, expected STEP: left out"),
              std::string::npos);
    EXPECT_NE(complaints("STEP", false).find("expected SCALAR of UNSIGNED_BYTE: left out"),
              std::string::npos);
}

/// The complaint about a pointer to numbers of `components`.
std::string complaintAbout(const std::string& pointer, std::size_t components = 1,
                           const GltfFile& original = fileOfEverything()) {
    GltfFile file = original;
    animate(file, {pointer, std::vector<float>(components, 0.5f)});
    return complaintsOf(file);
}

TEST(AnimationPointer, othersAreNamedAndLeftOut) {
    const auto expectLeftOut = [](const std::string& pointer, const std::string& reason) {
        const std::string complaint = complaintAbout(pointer);
        EXPECT_NE(
            complaint.find("animation 0, channel 0: pointer '" + pointer + "' " + reason + ": left out"),
            std::string::npos)
            << pointer << " gives: " << complaint;
        EXPECT_EQ(complaint.find('\n'), complaint.rfind('\n')) << "one note: " << complaint;
    };
    for (const char* text : {"", "materials/0/alphaCutoff", "/materials/0/~2"})
        expectLeftOut(text, "is no JSON pointer");
    for (const char* pointer :
         {"/", "/materials/0", "/materials/0/name", "/materials/0/doubleSided", "/materials/00/alphaCutoff",
          "/materials/-1/alphaCutoff", "/materials/{}/alphaCutoff", "/cameras/0/perspective/aspectRatio",
          "/cameras/1/orthographic/xmag", "/materials/0/pbrMetallicRoughness/baseColorFactor/0",
          "/nodes/0/matrix", "/extras/x",
          "/materials/0/normalTexture/extensions/KHR_texture_transform/texCoord",
          "/materials/0/extensions/KHR_texture_transform/offset",
          "/materials/18446744073709551616/alphaCutoff"})
        expectLeftOut(pointer, "leads to nothing that is animated");
    for (const char* pointer :
         {"/materials/1/alphaCutoff", "/nodes/9/translation", "/nodes/9/weights", "/meshes/1/weights",
          "/extensions/KHR_lights_punctual/lights/2/color", "/extensions/KHR_lights_punctual/lights/1/range",
          "/cameras/1/perspective/yfov", "/nodes/1/extensions/KHR_node_visibility/visible"})
        expectLeftOut(pointer, "leads to what the file does not have");
    for (const char* pointer : {"/nodes/1/weights", "/nodes/9/weights/0", "/meshes/7/weights/0"})
        expectLeftOut(pointer, "leads to weights of no morph targets that are drawn");
    for (const char* pointer : {"/nodes/0/weights/2", "/meshes/0/weights/2"})
        expectLeftOut(pointer, "leads to a morph target that does not exist");
}

TEST(AnimationPointer, aPropertyThatTheMaterialLacks) {
    GltfFile plain = triangleFile(R"("material":0)");
    plain.add("materials", "{}");
    for (const char* pointer :
         {"/materials/0/pbrMetallicRoughness/metallicFactor", "/materials/0/normalTexture/scale",
          "/materials/0/extensions/KHR_materials_clearcoat/clearcoatFactor",
          "/materials/0/normalTexture/extensions/KHR_texture_transform/rotation"})
        EXPECT_NE(complaintAbout(pointer, 1, plain).find("leads to what the file does not have"),
                  std::string::npos)
            << pointer;
    EXPECT_EQ(complaintAbout("/materials/0/emissiveFactor", 3, plain), "") << "it has a default";

    GltfFile glossy = triangleFile(R"("material":0)");
    glossy.add("materials", R"({"pbrMetallicRoughness":{},"extensions":
        {"KHR_materials_pbrSpecularGlossiness":{}}})");
    EXPECT_NE(complaintAbout("/materials/0/pbrMetallicRoughness/metallicFactor", 1, glossy)
                  .find("is of a material that KHR_materials_pbrSpecularGlossiness describes"),
              std::string::npos);
}

TEST(AnimationPointer, accessorsOfTheWrongForm) {
    EXPECT_NE(
        complaintAbout("/materials/0/emissiveFactor", 1).find("animation 0, channel 0, output: accessor"),
        std::string::npos);
    EXPECT_NE(complaintAbout("/materials/0/alphaCutoff", 2).find("expected SCALAR"), std::string::npos);
    GltfFile file = fileOfEverything();
    const int times = file.addData<float>("SCALAR", {0, 1});
    animate(file, "/materials/0/alphaCutoff", times, file.addData<float>("SCALAR", {0, 1, 2}));
    EXPECT_NE(complaintsOf(file).find("has 3 elements, expected 2"), std::string::npos);
}

TEST(AnimationPointer, aChannelWithoutItsPointer) {
    const auto complaint = [](const std::string& target) {
        GltfFile file = fileOfEverything();
        file.addData<float>("SCALAR", {0});
        file.add("animations", R"({"samplers":[{"input":4,"output":4}],"channels":[{"sampler":0,"target":)" +
                                   target + "}]}");
        return complaintsOf(file);
    };
    EXPECT_NE(complaint(R"({"path":"pointer"})").find("but no pointer of KHR_animation_pointer"),
              std::string::npos);
    for (const char* extension : {"{}", R"({"pointer":7})", "1"}) {
        const std::string text = complaint(R"({"path":"pointer","extensions":{"KHR_animation_pointer":)" +
                                           std::string(extension) + "}}");
        EXPECT_NE(text.find("animation 0, channel 0"), std::string::npos) << text;
        EXPECT_NE(text.find("left out"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace candela_test
