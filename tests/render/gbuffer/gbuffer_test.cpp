// Materials and meshes in the G-buffer, each in a small scene with a closed-form expectation.

#include "gbuffer/gbuffer_drawing.h"

#include "render/gbuffer/readback.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace candela::test {
namespace {

TEST_F(GBufferTest, factorsOfPlainMaterials) {
    for (std::uint32_t i = 0; i < 20; ++i) {
        Material material;
        material.baseColor = {hashed(80, i), hashed(81, i), hashed(82, i), 1.0f};
        material.metallic = hashed(83, i);
        material.roughness = 0.04f + 0.96f * hashed(84, i);  // below 0.032 only 0 is stored
        const AovReader reader = surfaces(sceneOf(makeQuad(1.0f), material));
        expectColor(reader.vector("base_color", middle, middle), glm::vec3(material.baseColor));
        EXPECT_NEAR(reader.scalar("metallic", middle, middle), material.metallic, halfCode);
        EXPECT_NEAR(reader.scalar("roughness", middle, middle), material.roughness, halfRoughnessCode);
        EXPECT_EQ(reader.vector("N", middle, middle), glm::vec3(0, 0, 1));
    }
}

TEST_F(GBufferTest, plainAndTexturedProgramsAgree) {
    for (std::uint32_t i = 0; i < 20; ++i) {
        Material material;
        material.baseColor = {hashed(85, i), hashed(86, i), hashed(87, i), 1.0f};
        material.metallic = hashed(88, i);
        material.roughness = hashed(89, i);
        const glm::mat4 rotated =
            glm::rotate(glm::mat4(1.0f), 0.9f * hashed(90, i), glm::vec3(0.6f, 0.8f, 0));
        Material masked = material;  // The mask, which every texel passes, selects the textured program.
        masked.alphaMode = AlphaMode::mask;
        const AovReader plain = surfaces(sceneOf(makeQuad(1.0f), material, rotated));
        const AovReader textured = surfaces(sceneOf(makeQuad(1.0f), masked, rotated));
        expectColor(textured.vector("base_color", middle, middle), plain.vector("base_color", middle, middle),
                    1.01f);
        EXPECT_EQ(textured.scalar("roughness", middle, middle), plain.scalar("roughness", middle, middle));
        EXPECT_NEAR(textured.scalar("metallic", middle, middle), plain.scalar("metallic", middle, middle),
                    2 * halfCode);
        expectNormal(textured.vector("N", middle, middle), plain.vector("N", middle, middle));
        EXPECT_EQ(textured.scalar("Z", middle, middle), plain.scalar("Z", middle, middle));
    }
}

TEST_F(GBufferTest, depthAndPosition) {
    const glm::mat4 tilted = glm::rotate(glm::mat4(1.0f), 0.5f, glm::vec3(0, 1, 0));
    const AovReader reader = surfaces(sceneOf(makeQuad(2.0f), Material{}, tilted));
    const glm::vec3 normal(tilted[2]);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::vec3 ray((2.0f * (float(x) + 0.5f) / size - 1.0f) / 3.0f,
                                (1.0f - 2.0f * (float(y) + 0.5f) / size) / 3.0f, -1.0f);
            const float depth = -glm::dot(normal, glm::vec3(0, 0, 3)) / glm::dot(normal, ray);
            // Depth is interpolated linearly on the screen: a few roundings of numbers about 3.
            ASSERT_NEAR(reader.scalar("Z", x, y), depth, 3e-6f * depth);
            ASSERT_LT(glm::distance(reader.vector("P", x, y), glm::vec3(0, 0, 3) + depth * ray), 1e-5f);
        }
    }
}

TEST_F(GBufferTest, reversedDepthResolvesDistantSurfaces) {
    // At 10 km, 5 cm apart: an ordinary depth buffer of 24 bits would need a near plane of 1 km and more.
    Scene scene;
    Material nearer, farther;
    nearer.baseColor = {1, 0, 0, 1};
    farther.baseColor = {0, 1, 0, 1};
    place(scene, makeQuad(9000.0f), farther, glm::translate(glm::mat4(1.0f), {0, 0, -10000.0f}));
    place(scene, makeQuad(9000.0f), nearer, glm::translate(glm::mat4(1.0f), {0, 0, -9999.95f}));
    const AovReader reader = surfaces(scene);
    for (int i = 0; i < size; ++i) EXPECT_EQ(reader.vector("base_color", i, i), glm::vec3(1, 0, 0));
}

TEST_F(GBufferTest, singleSidedSurfacesAreCulledFromBehind) {
    const CameraView behind = lookAt({0, 0, -3}, {0, 0, 0}, front.verticalFov);
    const Scene scene = sceneOf(makeQuad(1.0f), Material{});
    EXPECT_TRUE(hasSurface(surfaces(scene), middle, middle));
    EXPECT_FALSE(hasSurface(surfaces(scene, behind), middle, middle));
}

TEST_F(GBufferTest, normalsOfDoubleSidedSurfacesFaceTheEye) {
    const CameraView behind = lookAt({0, 0, -3}, {0, 0, 0}, front.verticalFov);
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask}) {
        Material material;
        material.doubleSided = true;
        material.alphaMode = mode;
        const Scene scene = sceneOf(makeQuad(1.0f), material);
        expectNormal(surfaces(scene).vector("N", middle, middle), {0, 0, 1});
        expectNormal(surfaces(scene, behind).vector("N", middle, middle), {0, 0, -1});
    }
}

/// A sphere of 1 m around the origin, drawn under `transform`: every pixel has the outer surface.
void expectOuterSphere(const AovReader& reader, float tolerance) {
    int covered = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (reader.scalar("Z", x, y) <= 0.0f) continue;
            ++covered;
            const glm::vec3 position = reader.vector("P", x, y), normal = reader.vector("N", x, y);
            ASSERT_LT(glm::distance(normal, glm::normalize(position)), tolerance) << x << ", " << y;
            ASSERT_GT(glm::dot(normal, glm::vec3(0, 0, 3) - position), -0.1f) << "the near side";
        }
    }
    EXPECT_GT(covered, size * size / 2);
}

TEST_F(GBufferTest, mirroredInstanceKeepsItsWinding) {
    // Interpolated normals differ from the polyhedron's positions by less than half a segment squared.
    constexpr float facets = 0.02f;
    for (const glm::vec3 scale :
         {glm::vec3(1, 1, 1), glm::vec3(-1, 1, 1), glm::vec3(1, -1, 1), glm::vec3(-1)}) {
        const Scene scene = sceneOf(makeSphere(1.0f, 48, 24), Material{}, glm::scale(glm::mat4(1.0f), scale));
        expectOuterSphere(surfaces(scene), facets);
    }
}

TEST_F(GBufferTest, scaleOfAnyMagnitudeKeepsNormalsAndWinding) {
    for (const float scale : {1.0e-15f, 1.0e-9f, 1.0e6f, 1.0e15f}) {
        for (const float mirror : {1.0f, -1.0f}) {
            const glm::mat4 transform = glm::scale(glm::mat4(1.0f), scale * glm::vec3(mirror, 1, 1));
            expectOuterSphere(surfaces(sceneOf(makeSphere(1.0f / scale, 48, 24), Material{}, transform)),
                              0.02f);
        }
    }
}

TEST_F(GBufferTest, nonUniformScaleTransformsNormalsByTheInverseTranspose) {
    // An ellipsoid: the normal is the gradient of x²/a² + y²/b² + z²/c².
    const glm::vec3 axes(0.9f, 0.4f, 0.7f);
    const AovReader reader =
        surfaces(sceneOf(makeSphere(1.0f, 96, 48), Material{}, glm::scale(glm::mat4(1.0f), axes)));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (!hasSurface(reader, x, y)) continue;
            expectNormal(reader.vector("N", x, y), reader.vector("P", x, y) / (axes * axes), 0.02f);
        }
    }
}

TEST_F(GBufferTest, flattenedInstanceKeepsItsOtherNormals) {
    // Flattened along z, the normal of one corner becomes zero; the others remain.
    const glm::mat4 flat = glm::scale(glm::mat4(1.0f), glm::vec3(1, 1, 0));
    Mesh quad = makeQuad(1.0f);
    quad.normals[1] = {1, 0, 0};
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask}) {
        Material material;
        material.alphaMode = mode;
        const AovReader reader = surfaces(sceneOf(quad, material, flat));
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) expectNormal(reader.vector("N", x, y), {0, 0, 1});
        }
    }
}

TEST_F(GBufferTest, degenerateInstanceIsNotDrawn) {
    Scene scene = sceneOf(makeSphere(0.5f), Material{}, glm::mat4(glm::mat3(0.0f)));
    place(scene, makeQuad(1.0f), Material{});
    expectNormal(surfaces(scene).vector("N", middle, middle), {0, 0, 1});
}

TEST_F(GBufferTest, maskDiscardsBelowItsCutoff) {
    Scene scene;
    // Alpha 0, 127, 128, 255 from the left; 128 / 255 is the cutoff exactly.
    scene.images = {makeImage(4, 1, [](std::uint32_t x, std::uint32_t) {
        constexpr std::uint8_t alpha[] = {0, 127, 128, 255};
        return glm::u8vec4(255, 255, 255, alpha[x]);
    })};
    Material material;
    material.baseColorTexture = nearestOf(0);
    material.alphaMode = AlphaMode::mask;
    material.alphaCutoff = 128.0f / 255.0f;
    place(scene, makeQuad(1.0f), material);
    const AovReader reader = surfaces(scene);
    EXPECT_FALSE(hasSurface(reader, 4, middle));
    EXPECT_FALSE(hasSurface(reader, 12, middle));
    EXPECT_TRUE(hasSurface(reader, 20, middle));
    EXPECT_TRUE(hasSurface(reader, 28, middle));
    scene.materials[0].alphaMode = AlphaMode::opaque;
    EXPECT_TRUE(hasSurface(surfaces(scene), 4, middle)) << "opaque surfaces have no mask";
}

TEST_F(GBufferTest, maskUsesTheAlphaOfFactorAndVertexColour) {
    Material material;
    material.alphaMode = AlphaMode::mask;
    material.baseColor.a = 0.8f;
    Mesh quad = makeQuad(1.0f);
    quad.colors = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};
    const AovReader reader = surfaces(sceneOf(quad, material));
    // Alpha grows from 0 to 0.8 over the picture and passes 0.5 at 0.625 of its width.
    for (int x = 0; x < size; ++x) {
        const float alpha = 0.8f * (float(x) + 0.5f) / size;
        if (std::abs(alpha - 0.5f) > 0.01f) {
            EXPECT_EQ(hasSurface(reader, x, middle), alpha > 0.5f) << x;
        }
    }
}

TEST_F(GBufferTest, unlitIsItsBaseColourWithoutLighting) {
    Material material;
    material.unlit = true;
    material.baseColor = {0.5f, 0.25f, 1.0f, 1.0f};
    material.emission = {7, 7, 7};
    GpuScene scene = upload(
        sceneOf(makeQuad(1.0f), material),
        std::vector{pointLight({0, 0, 1}, 9, glm::vec3(100)), directionalLight({0, 0, -1}, glm::vec3(5))});
    for (const Technique technique : techniques) {
        FrameRequest inputs = frameOf(front);
        inputs.technique = technique;
        const HdrImage picture = drawn(scene, inputs);
        EXPECT_EQ(pixelOf(picture, middle, middle), glm::vec3(0.5f, 0.25f, 1.0f));
        EXPECT_EQ(picture.rgba[3], 1.0f);
    }
    const AovReader reader = aovs(size);
    EXPECT_EQ(reader.vector("N", middle, middle), glm::vec3(0));
    EXPECT_EQ(reader.vector("emission", middle, middle), glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_GT(reader.scalar("Z", middle, middle), 0.0f);
}

TEST_F(GBufferTest, emissionIsFactorTimesDecodedTexture) {
    Scene scene;
    scene.images = {
        makeImage(1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(188, 64, 255, 0); })};
    Material material;
    material.emission = {10.0f, 20.0f, 1.0e20f};
    material.emissionTexture = nearestOf(0);
    place(scene, makeQuad(1.0f), material);
    GpuScene uploaded = upload(scene);
    const glm::vec3 radiance = pixelOf(drawn(uploaded, frameOf(front)), middle, middle);
    const glm::vec3 codes(188, 64, 255), factor(10.0f, 20.0f, 1.0e20f);
    for (int c = 0; c < 3; ++c) {
        // OpenGL asks no accuracy of sRGB decoding; implementations stay within a quarter of a code.
        EXPECT_GT(radiance[c], factor[c] * srgbDecode((codes[c] - 0.25f) / 255.0f));
        EXPECT_LT(radiance[c], factor[c] * srgbDecode((codes[c] + 0.25f) / 255.0f));
    }
    EXPECT_EQ(aovs(size).vector("emission", middle, middle), radiance) << "no light is in the scene";
}

TEST_F(GBufferTest, emissionIsOccludedBySurfacesInFrontOnly) {
    Material emissive, dark;
    emissive.emission = {3, 2, 1};
    const auto at = [](float z) { return glm::translate(glm::mat4(1.0f), {0, 0, z}); };
    const auto emitted = [&](float emissiveAt, float darkAt, bool emissiveFirst) {
        Scene scene;
        if (emissiveFirst) place(scene, makeQuad(0.9f), emissive, at(emissiveAt));
        place(scene, makeQuad(0.9f), dark, at(darkAt));
        if (!emissiveFirst) place(scene, makeQuad(0.9f), emissive, at(emissiveAt));
        return pixelOf(drawn(upload(scene), frameOf(front)), middle, middle);
    };
    for (const bool emissiveFirst : {true, false}) {
        EXPECT_EQ(emitted(0.0f, 0.3f, emissiveFirst), glm::vec3(0)) << "behind";
        EXPECT_EQ(emitted(0.3f, 0.0f, emissiveFirst), glm::vec3(3, 2, 1)) << "before";
    }
}

TEST_F(GBufferTest, emissiveSurfacesOccludeEachOther) {
    Material red, green;
    red.emission = {1, 0, 0};
    green.emission = {0, 1, 0};
    green.doubleSided = true;  // Another state, so that the order of drawing is not that of the scene.
    for (const float z : {-0.3f, 0.3f}) {
        Scene scene = sceneOf(makeQuad(0.9f), red);
        place(scene, makeQuad(0.9f), green, glm::translate(glm::mat4(1.0f), {0, 0, z}));
        EXPECT_EQ(pixelOf(drawn(upload(scene), frameOf(front)), middle, middle),
                  z > 0.0f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    }
}

TEST_F(GBufferTest, coloursOfTheSceneAreConvertedToTheWorkingSpace) {
    Material material;
    material.unlit = true;
    material.baseColor = {0.8f, 0.4f, 0.2f, 1.0f};
    GpuSceneOptions options;
    options.workingFromRec709 = glm::dmat3(0.5, 0.1, 0.0, 0.25, 0.75, 0.5, 0.0, 0.25, 0.5);
    const glm::vec3 expected(options.workingFromRec709 * glm::dvec3(0.8, 0.4, 0.2));
    GpuScene unlit(context(), sceneOf(makeQuad(1.0f), material), options);
    const glm::vec3 radiance = pixelOf(drawn(unlit, frameOf(front)), middle, middle);
    EXPECT_LT(glm::distance(radiance, expected), 1e-6f);
    material.unlit = false;
    material.emission = {0.8f, 0.4f, 0.2f};
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask}) {
        material.alphaMode = mode;
        GpuScene lit(context(), sceneOf(makeQuad(1.0f), material), options);
        render(lit, frameOf(front));
        const AovReader reader = aovs(size);
        expectColor(reader.vector("base_color", middle, middle), expected);
        EXPECT_LT(glm::distance(reader.vector("emission", middle, middle), expected), 1e-6f);
        material.emission = glm::vec3(0.0f);
        GpuScene plain(context(), sceneOf(makeQuad(1.0f), material), options);
        render(plain, frameOf(front));
        expectColor(aovs(size).vector("base_color", middle, middle), expected);
        material.emission = {0.8f, 0.4f, 0.2f};
    }
}

TEST_F(GBufferTest, surfaceWithoutMaterialHasTheDefaultOne) {
    Scene scene = sceneOf(makeQuad(1.0f), Material{});
    scene.meshes[0].submeshes[0].material.reset();
    scene.materials.clear();
    const AovReader reader = surfaces(scene);
    EXPECT_EQ(reader.vector("base_color", middle, middle), glm::vec3(1));
    EXPECT_EQ(reader.scalar("roughness", middle, middle), 1.0f);
    EXPECT_EQ(reader.scalar("metallic", middle, middle), 0.0f);
}

TEST_F(GBufferTest, backgroundIsEmpty) {
    GpuScene scene = upload(Scene{});
    render(scene, frameOf(front));
    const AovReader reader(lastFrame().aovs(Renderer::aovNames()), size);
    for (const std::string& name : Renderer::aovNames()) EXPECT_EQ(reader.scalar(name, 3, 4), 0.0f) << name;
    const HdrImage picture = lastFrame().radiance();
    for (const float value : picture.rgba) ASSERT_EQ(value, 0.0f);
}

TEST_F(GBufferTest, unknownAovIsAnErrorThatListsTheExistingOnes) {
    GpuScene scene = upload(Scene{});
    render(scene, frameOf(front));
    try {
        lastFrame().aovs({"N", "albedo"});
        FAIL() << "no error";
    } catch (const std::exception& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("'albedo'"), std::string::npos) << text;
        for (const std::string& name : Renderer::aovNames())
            EXPECT_NE(text.find(name), std::string::npos) << text;
    }
}

TEST_F(GBufferTest, layoutMayHaveAdditionalWords) {
    context().makeCurrent();
    const GBufferTargets targets(7, 3, {.shadowWord = true, .occlusion = true});
    ASSERT_EQ(targets.layout.size(), 3u);
    constexpr std::array<GLuint, 4> base{1, 2, 0, 0}, further{3, 0, 0, 0};
    constexpr std::array<GLfloat, 4> open{1.0f, 0.0f, 0.0f, 0.0f};
    for (const gl::Framebuffer* framebuffer : {&targets.surfaces, &targets.surfacesAndEmission}) {
        glClearNamedFramebufferuiv(framebuffer->name(), GL_COLOR, layout::SURFACE_OUTPUT, base.data());
        glClearNamedFramebufferuiv(framebuffer->name(), GL_COLOR, layout::SHADOW_OUTPUT, further.data());
        glClearNamedFramebufferfv(framebuffer->name(), GL_COLOR, layout::OCCLUSION_OUTPUT, open.data());
        std::vector<std::uint32_t> words(7 * 3);
        readWords(targets, wholeOf(targets), layout::SHADOW_OUTPUT, words);
        EXPECT_EQ(words, std::vector<std::uint32_t>(7 * 3, 3));
        std::vector<std::uint8_t> bytes(7 * 3);
        readOcclusion(targets, wholeOf(targets), bytes);
        EXPECT_EQ(bytes, std::vector<std::uint8_t>(7 * 3, 255));
        EXPECT_EQ(readSurfaceAt(targets, 6, 2).y, 2u);
    }
    targets.bind();
    GLint bound = 0;
    glActiveTexture(GL_TEXTURE7);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(GLuint(bound), targets.words[1].name());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace
}  // namespace candela::test
