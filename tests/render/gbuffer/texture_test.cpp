// Textures in the G-buffer: normal maps, coordinates, formats, mipmaps; and vertex colours.

#include "gbuffer/gbuffer_drawing.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cstring>
#include <functional>
#include <numbers>

namespace candela::test {
namespace {

class TextureTest : public GBufferTest {};

/// A quad with one normal-map texel.
Scene bumpy(const glm::u8vec3& code, float scale, const glm::mat4& transform = glm::mat4(1.0f)) {
    Scene scene;
    scene.images = {makeImage(1, 1, [&](std::uint32_t, std::uint32_t) { return glm::u8vec4(code, 255); })};
    Material material;
    material.normalTexture = nearestOf(0);
    material.normalScale = scale;
    material.doubleSided = true;
    place(scene, makeQuad(1.0f), material, transform);
    return scene;
}

TEST_F(TextureTest, normalMapIsInTheTangentFrame) {
    const auto decoded = [](const glm::u8vec3& code) { return glm::vec3(code) / 127.5f - 1.0f; };
    for (const glm::u8vec3 code :
         {glm::u8vec3(200, 128, 220), glm::u8vec3(128, 210, 200), glm::u8vec3(40, 90, 180)}) {
        for (const float scale : {1.0f, 0.5f, 2.0f}) {
            // The quad's tangent is +X and its bitangent, against growing v, +Y.
            const glm::vec3 expected = decoded(code) * glm::vec3(scale, scale, 1.0f);
            expectNormal(surfaces(bumpy(code, scale)).vector("N", middle, middle), expected, 2e-3f);
            const glm::mat4 rotated = glm::rotate(glm::mat4(1.0f), 0.7f, glm::normalize(glm::vec3(1, 2, -1)));
            expectNormal(surfaces(bumpy(code, scale, rotated)).vector("N", middle, middle),
                         glm::mat3(rotated) * expected, 2e-3f);
        }
    }
}

TEST_F(TextureTest, normalMapOfTheBackFaceIsThatOfTheFrontNegated) {
    const CameraView behind = lookAt({0, 0, -3}, {0, 0, 0}, front.verticalFov);
    const Scene scene = bumpy({200, 90, 220}, 1.0f);
    expectNormal(surfaces(scene, behind).vector("N", middle, middle),
                 -surfaces(scene).vector("N", middle, middle), 2e-3f);
}

TEST_F(TextureTest, normalMapOfAMirroredInstanceIsMirrored) {
    for (const glm::vec3 mirror : {glm::vec3(-1, 1, 1), glm::vec3(1, -1, 1)}) {
        const glm::u8vec3 code(210, 170, 200);
        const glm::vec3 plain = surfaces(bumpy(code, 1.0f)).vector("N", middle, middle);
        const Scene mirrored = bumpy(code, 1.0f, glm::scale(glm::mat4(1.0f), mirror));
        expectNormal(surfaces(mirrored).vector("N", middle, middle), mirror * plain, 2e-3f);
    }
}

TEST_F(TextureTest, surfaceWithoutTangentsKeepsItsNormalUnderANormalMap) {
    Scene scene = bumpy({200, 90, 220}, 1.0f);
    scene.meshes[0].tangents.clear();
    expectNormal(surfaces(scene).vector("N", middle, middle), {0, 0, 1});
}

/// 4 × 4 texels, each of a colour of its own.
Image tiles() {
    return makeImage(4, 4, [](std::uint32_t x, std::uint32_t y) {
        return glm::u8vec4(40 + 60 * x, 40 + 60 * y, 128, 255);
    });
}

glm::vec3 tileAt(float u, float v) {
    const auto cell = [](float t) { return int(std::floor((t - std::floor(t)) * 4.0f)); };
    return {srgbDecode(float(40 + 60 * cell(u)) / 255.0f), srgbDecode(float(40 + 60 * cell(v)) / 255.0f),
            srgbDecode(128.0f / 255.0f)};
}

bool nearTileEdge(float t) {
    return std::abs(4.0f * t - std::round(4.0f * t)) < 0.02f;
}

TEST_F(TextureTest, textureCoordinatesRunFromTheUpperLeft) {
    Scene scene;
    scene.images = {tiles()};
    Material material;
    material.baseColorTexture = nearestOf(0);
    place(scene, makeQuad(1.0f), material);
    const AovReader reader = surfaces(scene);
    expectColor(reader.vector("base_color", 2, 2), tileAt(0.1f, 0.1f));
    expectColor(reader.vector("base_color", 30, 2), tileAt(0.9f, 0.1f));
    expectColor(reader.vector("base_color", 2, 30), tileAt(0.1f, 0.9f));
}

void expectTransformed(const AovReader& reader, const std::function<glm::vec2(glm::vec2)>& transform) {
    int compared = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::vec2 uv = transform(glm::vec2(float(x) + 0.5f, float(y) + 0.5f) / float(size));
            if (nearTileEdge(uv.x) || nearTileEdge(uv.y)) continue;
            ++compared;
            expectColor(reader.vector("base_color", x, y), tileAt(uv.x, uv.y));
        }
    }
    EXPECT_GT(compared, size * size / 2);
}

TEST_F(TextureTest, textureTransform) {
    Scene scene;
    scene.images = {tiles()};
    Material material;
    material.baseColorTexture = nearestOf(0);
    Texture& texture = *material.baseColorTexture;
    texture.offset = {0.3f, -0.2f};
    texture.rotation = 0.6f;
    texture.scale = {1.5f, 0.7f};
    place(scene, makeQuad(1.0f), material);
    // Counter-clockwise as one sees it, where v runs down: (u, v) to (c u + s v, -s u + c v).
    const float c = std::cos(0.6f), s = std::sin(0.6f);
    expectTransformed(surfaces(scene), [&](glm::vec2 uv) {
        uv *= glm::vec2(1.5f, 0.7f);
        return glm::vec2(c * uv.x + s * uv.y + 0.3f, -s * uv.x + c * uv.y - 0.2f);
    });
}

TEST_F(TextureTest, textureTransformOfTheSpecificationsExample) {
    // KHR_texture_transform's own example: "only the lower left quadrant of the source image, rotated
    // clockwise 90 degrees".
    Scene scene;
    scene.images = {tiles()};
    Material material;
    material.baseColorTexture = nearestOf(0);
    material.baseColorTexture->offset = {0.0f, 1.0f};
    material.baseColorTexture->rotation = std::numbers::pi_v<float> / 2.0f;
    material.baseColorTexture->scale = {0.5f, 0.5f};
    place(scene, makeQuad(1.0f), material);
    const AovReader reader = surfaces(scene);
    // The image's upper left shows the quadrant's lower left, its upper right the quadrant's upper left.
    expectColor(reader.vector("base_color", 2, 2), tileAt(0.1f, 0.9f));
    expectColor(reader.vector("base_color", 30, 2), tileAt(0.1f, 0.6f));
    expectColor(reader.vector("base_color", 2, 30), tileAt(0.4f, 0.9f));
}

TEST_F(TextureTest, secondSetOfCoordinates) {
    Scene scene;
    scene.images = {tiles()};
    Material material;
    material.baseColorTexture = nearestOf(0);
    material.baseColorTexture->uvSet = 1;
    Mesh quad = makeQuad(1.0f);
    for (const glm::vec2& uv : quad.uv0) quad.uv1.emplace_back(0.5f * uv.y, 0.25f + 0.5f * uv.x);
    place(scene, quad, material);
    expectTransformed(surfaces(scene),
                      [](glm::vec2 uv) { return glm::vec2(0.5f * uv.y, 0.25f + 0.5f * uv.x); });
}

TEST_F(TextureTest, wrapModes) {
    Scene scene;
    scene.images = {tiles()};
    Material material;
    material.baseColorTexture = nearestOf(0);
    material.baseColorTexture->scale = {3.0f, 3.0f};
    material.baseColorTexture->offset = {-1.0f, -1.0f};
    material.baseColorTexture->wrapS = Wrap::clampToEdge;
    material.baseColorTexture->wrapT = Wrap::mirroredRepeat;
    place(scene, makeQuad(1.0f), material);
    expectTransformed(surfaces(scene), [](glm::vec2 uv) {
        uv = 3.0f * uv - 1.0f;
        const float mirrored = uv.y < 0.0f ? -uv.y : uv.y > 1.0f ? 2.0f - uv.y : uv.y;
        return glm::vec2(glm::clamp(uv.x, 0.05f, 0.95f), mirrored);
    });
}

TEST_F(TextureTest, metallicRoughnessTextureGivesBlueAndGreen) {
    Scene scene;
    scene.images = {
        makeImage(1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(255, 102, 204, 0); })};
    Material material;
    material.metallic = 0.5f;
    material.roughness = 0.75f;
    material.metallicRoughnessTexture = nearestOf(0);
    place(scene, makeQuad(1.0f), material);
    const AovReader reader = surfaces(scene);
    EXPECT_NEAR(reader.scalar("roughness", middle, middle), 0.75f * 0.4f, halfRoughnessCode);
    EXPECT_NEAR(reader.scalar("metallic", middle, middle), 0.5f * 0.8f, halfCode);
}

TEST_F(TextureTest, pixelFormatsOfOneColourAgree) {
    for (const PixelFormat format : {PixelFormat::rgba8, PixelFormat::rgba16, PixelFormat::rgba32f}) {
        Image image{"one", 1, 1, format, std::vector<std::byte>(texelSize(format))};
        const std::array<std::uint8_t, 4> codes8{200, 100, 30, 255};
        const std::array<std::uint16_t, 4> codes16{200 * 257, 100 * 257, 30 * 257, 65535};
        std::array<float, 4> floats{};
        for (std::size_t i = 0; i < 4; ++i) floats[i] = srgbDecode(float(codes8[i]) / 255.0f);
        const void* bytes = format == PixelFormat::rgba8    ? static_cast<const void*>(codes8.data())
                            : format == PixelFormat::rgba16 ? static_cast<const void*>(codes16.data())
                                                            : static_cast<const void*>(floats.data());
        std::memcpy(image.pixels.data(), bytes, image.pixels.size());
        Scene scene;
        scene.images = {image};
        Material material;
        material.baseColorTexture = nearestOf(0);
        place(scene, makeQuad(1.0f), material);
        expectColor(surfaces(scene).vector("base_color", middle, middle),
                    glm::vec3(floats[0], floats[1], floats[2]));
    }
}

TEST_F(TextureTest, vertexColoursMultiplyAndInterpolateLinearly) {
    Material material;
    material.baseColor = {0.5f, 1.0f, 1.0f, 1.0f};
    Mesh quad = makeQuad(1.0f);
    quad.colors = {{0, 0, 1, 1}, {1, 0, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}};
    const AovReader reader = surfaces(sceneOf(quad, material));
    for (const int x : {1, 9, 16, 31}) {
        for (const int y : {1, 9, 16, 31}) {
            const float u = (float(x) + 0.5f) / size, v = 1.0f - (float(y) + 0.5f) / size;
            expectColor(reader.vector("base_color", x, y), {0.5f * u, v, 1.0f});
        }
    }
}

TEST_F(TextureTest, minifiedTexturesShowTheMean) {
    Scene scene;
    scene.images = {makeImage(256, 256, [](std::uint32_t x, std::uint32_t y) {
        const std::uint8_t code = (x + y) % 2 == 0 ? 255 : 0;
        return glm::u8vec4(code, code, code, 255);
    })};
    Material material;
    material.baseColorTexture = Texture{};
    material.metallicRoughnessTexture = Texture{};
    place(scene, makeQuad(1.0f), material);
    const AovReader reader = surfaces(scene);
    for (const int at : {5, 16, 27}) {
        // The mean of linear numbers; 8-bit mipmaps round at each of 8 levels.
        EXPECT_NEAR(reader.scalar("roughness", at, at), 0.5f, 0.02f);
        // The mean of light, not of codes, which would be 0.21.
        EXPECT_NEAR(reader.vector("base_color", at, at).g, 0.5f, 0.03f);
    }
    scene.materials[0].baseColorTexture->minFilter = Filter::nearest;
    const AovReader unfiltered = surfaces(scene);
    const float value = unfiltered.vector("base_color", middle, middle).g;
    EXPECT_TRUE(value < 0.01f || value > 0.99f) << "without mipmaps a texel is black or white";
}

}  // namespace
}  // namespace candela::test
