// The G-buffer's lobe words: packing, and what the geometry pass writes of materials with more lobes than
// metallic-roughness.

#include "gbuffer/gbuffer_drawing.h"

#include "gl/state_guard.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/gbuffer_copy.h"
#include "render/gbuffer/geometry_pass.h"
#include "render/gbuffer/readback.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <limits>
#include <numbers>

namespace candela::test {
namespace {

/// Of 8 bits, as a difference of angles: codes are half of 90° / 127.5 apart near the axes and up to twice as
/// far between them.
constexpr float directionError = 0.0124f;

/// Roughnesses are those that have codes of their own.
ExtendedLobes<float> randomLobes(std::uint32_t i, const glm::vec3& normal) {
    const auto unit = [i](std::uint32_t seed) { return hashed(seed, i); };
    const auto color = [&](std::uint32_t seed) {
        return glm::vec3(unit(seed), unit(seed + 1), unit(seed + 2));
    };
    ExtendedLobes<float> lobes;
    lobes.f0 = color(10);
    lobes.f90 = unit(13);
    lobes.anisotropy = unit(14);
    lobes.anisotropyDirection = glm::normalize(glm::cross(normal, color(15) - 0.5f));
    lobes.sheenColor = color(18);
    lobes.sheenRoughness = glm::mix(0.05f, 1.0f, unit(21));
    lobes.clearcoat = unit(22);
    lobes.clearcoatRoughness = glm::mix(0.05f, 1.0f, unit(23));
    lobes.clearcoatNormal = glm::normalize(normal + 0.3f * color(24));
    lobes.transmission = unit(27);
    lobes.diffuseTransmission = unit(28);
    lobes.diffuseTransmissionColor = color(29);
    return lobes;
}

/// `codes`: the tolerance of colours, in codes of the G-buffer.
void expectLobes(const ExtendedLobes<float>& actual, const ExtendedLobes<float>& expected,
                 float codes = 0.51f) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(std::sqrt(actual.f0[c]), std::sqrt(expected.f0[c]), halfCode) << "F0, channel " << c;
    EXPECT_NEAR(actual.f90, expected.f90, halfCode);
    EXPECT_NEAR(actual.anisotropy, expected.anisotropy, halfCode);
    if (expected.anisotropy > 0.0f) {
        // The opposite direction is the same.
        EXPECT_GT(std::abs(glm::dot(actual.anisotropyDirection, expected.anisotropyDirection)),
                  std::cos(directionError));
    }
    expectColor(actual.sheenColor, expected.sheenColor, codes);
    EXPECT_NEAR(actual.sheenRoughness, expected.sheenRoughness, halfRoughnessCode);
    EXPECT_NEAR(actual.clearcoat, expected.clearcoat, halfCode);
    EXPECT_NEAR(actual.clearcoatRoughness, expected.clearcoatRoughness, halfRoughnessCode);
    expectNormal(actual.clearcoatNormal, expected.clearcoatNormal);
    EXPECT_NEAR(actual.transmission, expected.transmission, halfCode);
    EXPECT_NEAR(actual.diffuseTransmission, expected.diffuseTransmission, halfCode);
    expectColor(actual.diffuseTransmissionColor, expected.diffuseTransmissionColor, codes);
}

TEST(LobeWords, packingKeepsRandomLobesWithinHalfACode) {
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const glm::vec3 normal =
            glm::normalize(glm::vec3(hashed(1, i), hashed(2, i), hashed(3, i)) - glm::vec3(0.5f));
        const ExtendedLobes<float> lobes = randomLobes(i, normal);
        const GBufferLobeWords words = packLobeWords(lobes, normal);
        EXPECT_NE(words.lobes[2], 0u) << "which would be a pixel without lobes";
        SCOPED_TRACE(i);
        expectLobes(unpackLobeWords(words, normal), lobes);
    }
}

TEST(LobeWords, usualReflectancesAreExact) {
    ExtendedLobes<float> lobes;
    for (const float f0 : {0.0f, 0.04f, 1.0f}) {
        lobes.f0 = glm::vec3(f0);
        EXPECT_NEAR(unpackLobeWords(packLobeWords(lobes, {0, 0, 1}), {0, 0, 1}).f0.x, f0, 1e-8f);
    }
}

/// What the middle pixel of a quad of one material holds.
class LobeDrawingTest : public GBufferTest {
  protected:
    struct Pixel {
        GBufferTexel surface;
        GBufferLobeWords words;
    };
    static Pixel drawn(const Scene& scene, const CameraView& view = front) {
        GpuScene uploaded = upload(scene);
        context().makeCurrent();
        const gl::StateGuard guard(*context().state().binding, "a test");
        GpuScene::State& state = uploaded.state();
        state.update();
        const Frustum frustum(view, 1.0f);
        const layout::FrameUniforms uniforms =
            frameUniforms(view, size, size, glm::dmat3(1.0), state.lights.counts());
        gl::Buffer buffer("frame", gl::BufferUsage::dynamic);
        buffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
        glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, buffer.name());
        const GBufferTargets targets(size, size, {.lobes = true});
        DrawSelection draws;
        state.cull(frustum, draws);
        GeometryPass().render({state, draws, targets, LoadOp::clear, SurfaceSet::all});
        GBufferCopy copy;
        copy.reset(targets);
        const std::size_t at = static_cast<std::size_t>(middle * size + middle);
        Pixel pixel;
        pixel.surface = {copy.surfaces()[2 * at], copy.surfaces()[2 * at + 1]};
        std::copy_n(&copy.lobeWords()[4 * at], 4, pixel.words.lobes.begin());
        pixel.words.diffuseTransmission = copy.diffuseTransmission()[at];
        return pixel;
    }
    static Scene quadOf(const Material& material, const glm::mat4& transform = glm::mat4(1.0f)) {
        Scene scene;
        place(scene, makeQuad(1.0f), material, transform);
        return scene;
    }
    static ExtendedLobes<float> lobesOf(const Scene& scene, const CameraView& view = front) {
        const Pixel pixel = drawn(scene, view);
        return unpackLobeWords(pixel.words, unpackNormal(pixel.surface.y));
    }
};

TEST_F(LobeDrawingTest, plainMaterialHasNone) {
    const Pixel pixel = drawn(quadOf(Material{}));
    EXPECT_EQ(pixel.words.lobes, (std::array<std::uint32_t, 4>{}));
    EXPECT_EQ(pixel.words.diffuseTransmission, 0u);
    Material emissive;
    emissive.emission = glm::vec3(1.0f);
    EXPECT_EQ(drawn(quadOf(emissive)).words.lobes[2], 0u);
}

Material allFactors() {
    Material material;
    material.baseColor = {0.8f, 0.4f, 0.2f, 1.0f};
    material.metallic = 0.25f;
    material.ior = 1.8f;
    material.specular.factor = 0.75f;
    material.specular.color = {0.9f, 0.6f, 0.3f};
    material.clearcoat.factor = 0.7f;
    material.clearcoat.roughness = 0.3f;
    material.sheen.color = {0.2f, 0.5f, 0.7f};
    material.sheen.roughness = 0.45f;
    material.anisotropy.strength = 0.6f;
    material.anisotropy.rotation = 0.4f;
    material.transmission.factor = 0.35f;
    material.diffuseTransmission.factor = 0.15f;
    material.diffuseTransmission.color = {0.1f, 0.6f, 0.9f};
    return material;
}

ExtendedLobes<float> expectedOf(const Material& material) {
    ExtendedLobes<float> lobes;
    const float root = (material.ior - 1.0f) / (material.ior + 1.0f);
    const glm::vec3 dielectric =
        glm::min(root * root * material.specular.color, 1.0f) * material.specular.factor;
    lobes.f0 = glm::mix(dielectric, glm::vec3(material.baseColor), material.metallic);
    lobes.f90 = glm::mix(material.specular.factor, 1.0f, material.metallic);
    lobes.anisotropy = material.anisotropy.strength;
    // The quad's tangent is +X and its bitangent, against growing v, +Y.
    lobes.anisotropyDirection = {std::cos(material.anisotropy.rotation),
                                 std::sin(material.anisotropy.rotation), 0.0f};
    lobes.sheenColor = material.sheen.color;
    lobes.sheenRoughness = material.sheen.roughness;
    lobes.clearcoat = material.clearcoat.factor;
    lobes.clearcoatRoughness = material.clearcoat.roughness;
    lobes.transmission = material.transmission.factor;
    lobes.diffuseTransmission = material.diffuseTransmission.factor;
    lobes.diffuseTransmissionColor = material.diffuseTransmission.color;
    return lobes;
}

TEST_F(LobeDrawingTest, factorsAreWritten) {
    expectLobes(lobesOf(quadOf(allFactors())), expectedOf(allFactors()));
}

TEST_F(LobeDrawingTest, infiniteIndexOfRefractionReflectsTheSpecularColor) {
    Material material;
    material.ior = std::numeric_limits<float>::infinity();
    material.specular.color = {0.9f, 0.6f, 0.3f};
    const glm::vec3 f0 = lobesOf(quadOf(material)).f0;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(std::sqrt(f0[c]), std::sqrt(material.specular.color[c]), halfCode);
}

/// Each texture has one texel of this code in the channel that is read, and another one in the others.
TEST_F(LobeDrawingTest, texturesMultiplyTheirChannels) {
    constexpr std::uint8_t code = 102, other = 200;  // 0.4
    const float share = 0.4f;
    Material material = allFactors();
    Scene scene;
    const auto texelIn = [&](int channel) {
        scene.images.push_back(makeImage(1, 1, [&](std::uint32_t, std::uint32_t) {
            glm::u8vec4 texel(other);
            texel[channel] = code;
            return texel;
        }));
        return nearestOf(static_cast<std::uint32_t>(scene.images.size() - 1));
    };
    const auto gray = [&] {
        scene.images.push_back(makeImage(
            1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(code, code, code, other); }));
        return nearestOf(static_cast<std::uint32_t>(scene.images.size() - 1));
    };
    material.specular.texture = texelIn(3);
    material.specular.colorTexture = gray();
    material.clearcoat.texture = texelIn(0);
    material.clearcoat.roughnessTexture = texelIn(1);
    material.sheen.colorTexture = gray();
    material.sheen.roughnessTexture = texelIn(3);
    material.transmission.texture = texelIn(0);
    material.diffuseTransmission.texture = texelIn(3);
    material.diffuseTransmission.colorTexture = gray();
    place(scene, makeQuad(1.0f), material);

    Material expected = allFactors();
    const float linear = srgbDecode(share);
    expected.specular.factor *= share;
    expected.specular.color *= linear;
    expected.clearcoat.factor *= share;
    expected.clearcoat.roughness *= share;
    expected.sheen.color *= linear;
    expected.sheen.roughness *= share;
    expected.transmission.factor *= share;
    expected.diffuseTransmission.factor *= share;
    expected.diffuseTransmission.color *= linear;
    // A device's own sampler may decode sRGB with an error of about a code.
    expectLobes(lobesOf(scene), expectedOf(expected), context().isSoftware() ? 0.51f : 1.5f);
}

TEST_F(LobeDrawingTest, anisotropyTextureTurnsItsDirection) {
    Material material;
    material.anisotropy.strength = 0.8f;
    material.anisotropy.rotation = 0.3f;
    Scene scene;
    // The direction (0, 1) and the strength 0.4.
    scene.images = {
        makeImage(1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(128, 255, 102, 255); })};
    material.anisotropy.texture = nearestOf(0);
    place(scene, makeQuad(1.0f), material);
    const ExtendedLobes<float> lobes = lobesOf(scene);
    EXPECT_NEAR(lobes.anisotropy, 0.32f, halfCode);
    const float angle = 0.3f + std::numbers::pi_v<float> / 2.0f;
    // And half a code of the texture.
    EXPECT_GT(
        std::abs(glm::dot(lobes.anisotropyDirection, glm::vec3(std::cos(angle), std::sin(angle), 0.0f))),
        std::cos(directionError + 0.004f));
}

TEST_F(LobeDrawingTest, anisotropyFollowsTheInstance) {
    Material material;
    material.anisotropy.strength = 1.0f;
    const glm::mat4 rotated = glm::rotate(glm::mat4(1.0f), 0.7f, glm::normalize(glm::vec3(1, 2, -1)));
    const glm::vec3 direction = lobesOf(quadOf(material, rotated)).anisotropyDirection;
    EXPECT_GT(std::abs(glm::dot(direction, glm::mat3(rotated) * glm::vec3(1, 0, 0))),
              std::cos(directionError));
}

TEST_F(LobeDrawingTest, clearcoatHasTheNormalOfTheMeshOrItsOwn) {
    Scene scene;
    scene.images = {
        makeImage(1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(200, 90, 220, 255); })};
    Material material;
    material.doubleSided = true;
    material.clearcoat.factor = 1.0f;
    material.normalTexture = nearestOf(0);
    place(scene, makeQuad(1.0f), material);
    expectNormal(lobesOf(scene).clearcoatNormal, {0, 0, 1});
    const CameraView behind = lookAt({0, 0, -3}, {0, 0, 0}, front.verticalFov);
    expectNormal(lobesOf(scene, behind).clearcoatNormal, {0, 0, -1});
    scene.materials[0].normalTexture.reset();
    scene.materials[0].clearcoat.normalTexture = nearestOf(0);
    scene.materials[0].clearcoat.normalScale = 0.5f;
    const glm::vec3 mapped = (glm::vec3(200, 90, 220) / 127.5f - 1.0f) * glm::vec3(0.5f, 0.5f, 1.0f);
    expectNormal(lobesOf(scene).clearcoatNormal, mapped, 2e-3f);
    expectNormal(lobesOf(scene, behind).clearcoatNormal, -mapped, 2e-3f);
}

TEST_F(LobeDrawingTest, filmIsFoldedIntoTheReflectance) {
    Material material;
    material.baseColor = {0.9f, 0.6f, 0.3f, 1.0f};
    material.metallic = 1.0f;
    material.iridescence.factor = 1.0f;
    material.iridescence.ior = 1.4f;
    material.iridescence.maxThickness = 450.0f;
    const glm::dvec3 expected = iridescentF0(1.0, glm::dvec3(glm::vec3(material.baseColor)), 1.4, 450.0);
    const glm::vec3 f0 = lobesOf(quadOf(material)).f0;
    // The middle of the picture is seen along the normal, to a degree.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(std::sqrt(f0[c]), std::sqrt(expected[c]), halfCode + 0.002f);
}

TEST_F(LobeDrawingTest, materialMayGainAndLoseLobes) {
    GpuScene scene = upload(quadOf(Material{}));
    const HdrImage plain = DrawingTest::drawn(scene, frameOf(front));
    scene.setMaterial(0, allFactors());
    DrawingTest::drawn(scene, frameOf(front));
    scene.setMaterial(0, Material{});
    EXPECT_EQ(DrawingTest::drawn(scene, frameOf(front)).rgba, plain.rgba);
}

}  // namespace
}  // namespace candela::test
