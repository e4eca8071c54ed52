// EXT_lights_image_based.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

/// A file whose cube faces are 4 × 4 texels; `png(face)` makes them.
template <typename Png>
GltfFile fileWithLight(const Png& png, const std::string& more = "") {
    GltfFile file = triangleFile();
    std::string faces;
    for (int face = 0; face < 6; ++face) {
        const int view = file.addView(png(face));
        const int image =
            file.add("images", R"({"mimeType":"image/png","bufferView":)" + std::to_string(view) + "}");
        faces += (face == 0 ? "" : ",") + std::to_string(image);
    }
    file.set(
        "extensions",
        R"({"EXT_lights_image_based":{"lights":[{"name":"hall","specularImageSize":4,"irradianceCoefficients":[],"specularImages":[[)" +
            faces + "]]" + more + "}]}}");
    file.set("scene", "0");
    file.add("scenes", R"({"nodes":[0],"extensions":{"EXT_lights_image_based":{"light":0}}})");
    return file;
}

constexpr std::array<std::array<std::uint8_t, 3>, 6> faceColors{
    {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}, {0, 255, 255}, {255, 0, 255}}};

Bytes coloredFace(int face) {
    const auto& color = faceColors[static_cast<std::size_t>(face)];
    return makePng(4, 4, color[0], color[1], color[2], 255);
}

/// The texel along a direction.
glm::vec3 along(const candela::Image& picture, const glm::dvec3& d) {
    const double column = picture.width * (0.5 + std::atan2(d.x, -d.z) / (2.0 * std::numbers::pi));
    const double row = picture.height * std::acos(d.y / glm::length(d)) / std::numbers::pi;
    const std::size_t x = std::min(static_cast<std::size_t>(column), std::size_t{picture.width - 1});
    const std::size_t y = std::min(static_cast<std::size_t>(row), std::size_t{picture.height - 1});
    glm::vec3 color;
    std::memcpy(&color, picture.pixels.data() + (y * picture.width + x) * 16, sizeof color);
    return color;
}

TEST(ImageBasedLight, itsFacesLieAlongTheAxes) {
    const candela::ImportedScene imported = load(fileWithLight(coloredFace));
    EXPECT_TRUE(imported.report.notes.empty());
    ASSERT_TRUE(imported.scene.environment);
    const candela::Image& picture = imported.scene.environment->picture;
    EXPECT_EQ(picture.name, "hall");
    EXPECT_EQ(picture.width, 16u);
    EXPECT_EQ(picture.height, 8u);
    EXPECT_TRUE(imported.scene.environment->isBackground);
    const std::array<glm::dvec3, 6> axes{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    for (std::size_t face = 0; face < 6; ++face) {
        const auto& color = faceColors[face];
        EXPECT_EQ(along(picture, axes[face]), glm::vec3(color[0], color[1], color[2]) / 255.0f) << face;
    }
    EXPECT_TRUE(imported.scene.images.empty()) << "no material reads them";
}

TEST(ImageBasedLight, itsFacesAreSeenFromWithin) {
    // The upper left quarter of each face is bright.
    const candela::ImportedScene imported = load(fileWithLight([](int) {
        constexpr std::uint32_t size = 16;
        Bytes samples;
        for (std::uint32_t i = 0; i < size * size; ++i)
            samples.push_back(i % size < size / 2 && i / size < size / 2 ? 255 : 0);
        return makePng(size, size, 8, PngColor::grey, samples);
    }));
    const candela::Image& picture = imported.scene.environment->picture;
    // To the left of who looks along the axis with +Y up; for +Y and -Y, with +Z or -Z at the lower edge.
    const std::array<glm::dvec3, 6> corners{
        {{1, 0.5, -0.5}, {-1, 0.5, 0.5}, {0.5, 1, -0.5}, {0.5, -1, 0.5}, {0.5, 0.5, 1}, {-0.5, 0.5, -1}}};
    for (std::size_t face = 0; face < 6; ++face) {
        const int axis = static_cast<int>(face / 2), across = (axis + 1) % 3, upward = (axis + 2) % 3;
        for (const glm::dvec2& sign :
             {glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1)}) {
            glm::dvec3 direction = corners[face];
            direction[across] *= sign.x;
            direction[upward] *= sign.y;
            EXPECT_EQ(along(picture, direction).r, sign == glm::dvec2(1, 1) ? 1.0f : 0.0f)
                << face << " " << sign.x << " " << sign.y;
        }
    }
}

TEST(ImageBasedLight, alphaDividesTheColours) {
    const candela::ImportedScene imported = load(fileWithLight(
        [](int) { return makePng(4, 4, 255, 255, 255, 51); }, R"(,"intensity":3,"rotation":[0,2,0,0])"));
    ASSERT_TRUE(imported.scene.environment);
    EXPECT_NEAR(along(imported.scene.environment->picture, {0, 0, 1}).g, 5.0f, 1e-5f);
    EXPECT_EQ(imported.scene.environment->intensity, 3.0f);
    EXPECT_EQ(imported.scene.environment->rotation, glm::quat(0, 0, 1, 0));
}

TEST(ImageBasedLight, ofAnotherSceneIsNotUsed) {
    GltfFile file = fileWithLight(coloredFace);
    file.add("scenes", R"({"nodes":[0]})");
    file.set("scene", "1");
    EXPECT_FALSE(load(file).scene.environment);
}

TEST(ImageBasedLight, whatIsBrokenIsLeftOutOrRepairedWithANote) {
    const auto expectNote = [](const GltfFile& file, const char* text) {
        const candela::ImportedScene imported = load(file);
        EXPECT_TRUE(hasNote(imported, text)) << complaintsOf(file);
        EXPECT_EQ(imported.report.notes.size(), 1u);
        return imported.scene.environment.has_value();
    };
    EXPECT_TRUE(expectNote(fileWithLight(coloredFace, R"(,"intensity":-1)"),
                           "image-based light 0 'hall': \"intensity\" must be 0 to 1e17: 1 is used"));
    EXPECT_TRUE(expectNote(fileWithLight(coloredFace, R"(,"rotation":[0,0,0,0])"),
                           "image-based light 0 'hall': \"rotation\" is no quaternion: it is not rotated"));
    EXPECT_FALSE(
        expectNote(fileWithLight(coloredFace, R"(,"specularImages":[[0,1,2,3,4]])"),
                   "image-based light 0 'hall': \"specularImages\" must begin with an array of 6 images"));
    EXPECT_FALSE(
        expectNote(fileWithLight(coloredFace, R"(,"specularImages":[[0,1,2,3,4,9]])"),
                   "image-based light 0 'hall': \"specularImages\" names an image that does not exist"));
    EXPECT_FALSE(expectNote(
        fileWithLight([](int face) { return makePng(face == 5 ? 2 : 4, face == 5 ? 2 : 4, 1, 2, 3, 255); }),
        "image-based light 0 'hall': its images differ in size"));
    EXPECT_FALSE(expectNote(fileWithLight([](int) {
                                return Bytes{1, 2, 3};
                            }),
                            "image-based light 0 'hall': "));
    GltfFile file = triangleFile();
    file.add("scenes", R"({"nodes":[0],"extensions":{"EXT_lights_image_based":{"light":0}}})");
    EXPECT_FALSE(
        expectNote(file, "scene 0, EXT_lights_image_based: \"light\" names a light that does not exist"));
}

}  // namespace
}  // namespace candela_test
