// A scene with a replaced material gives the image of a scene that is uploaded with the new material.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cstring>
#include <string>

namespace candela::test {
namespace {

const FrameRequest inputs{64, 48, lookAt({0.5f, 1.0f, 5}, {0, 0, 0}, 0.8f), BrdfModel::course,
                          Technique::fullscreen};

Texture textureOf(std::uint32_t image) {
    Texture texture;
    texture.image = image;
    return texture;
}

/// The texels of an 8-bit image in 16 bits, with varying low bits.
Image widened(const Image& narrow) {
    Image wide{"wide", narrow.width, narrow.height, PixelFormat::rgba16, {}};
    wide.pixels.resize(2 * narrow.pixels.size());
    for (std::size_t i = 0; i < narrow.pixels.size(); ++i) {
        const auto code =
            static_cast<std::uint16_t>(std::to_integer<unsigned>(narrow.pixels[i]) * 257u ^ (i * 37u & 255u));
        std::memcpy(wide.pixels.data() + 2 * i, &code, 2);
    }
    return wide;
}

/// A quad and a cage of material 0, and a sphere of material 1 without texture coordinates.
Scene scene() {
    Scene scene;
    place(scene, makeQuad(1.0f), Material{}, glm::translate(glm::mat4(1.0f), {-1.2f, 0, 0}));
    Mesh bare = makeSphere(0.5f);
    bare.uv0.clear();
    place(scene, bare, Material{}, glm::translate(glm::mat4(1.0f), {0, 0, -2}));
    placeCage(scene, makeCubeCage(0.9f), Material{}, glm::translate(glm::mat4(1.0f), {1.2f, 0, 0}));
    scene.cages[0].faceMaterials.assign(6, 0u);
    const Image pattern = makeImage(8, 8, [](std::uint32_t x, std::uint32_t y) {
        return glm::u8vec4(30 * x + 20, 25 * y + 40, 200 - 20 * x, (x + y) % 2 == 0 ? 255 : 60);
    });
    scene.images = {pattern, widened(pattern), pattern, widened(pattern), pattern};
    return scene;
}

/// Images 0 and 1 are in use as colour, 2 and 3 as data; 4 is not in use.
Scene sceneOfUsedImages() {
    Scene used = scene();
    Material colors, data;
    colors.baseColorTexture = textureOf(0);
    colors.emissionTexture = textureOf(1);
    colors.emission = glm::vec3(0.1f);
    data.metallicRoughnessTexture = textureOf(2);
    data.normalTexture = textureOf(3);
    place(used, makeQuad(0.3f), colors, glm::translate(glm::mat4(1.0f), {-1, 1.2f, 1}));
    place(used, makeQuad(0.3f), data, glm::translate(glm::mat4(1.0f), {1, 1.2f, 1}));
    return used;
}

struct Change {
    const char* name;
    Material material;
};

std::vector<Change> changes() {
    Material coloured, emissive, doubleSided, unlit;
    coloured.baseColor = {0.8f, 0.3f, 0.1f, 1.0f};
    coloured.roughness = 0.4f;
    coloured.metallic = 0.7f;
    emissive.emission = {0.5f, 0.2f, 3.0f};
    doubleSided.doubleSided = true;
    unlit.unlit = true;
    unlit.baseColor = {0.3f, 0.9f, 0.4f, 1.0f};
    std::vector<Change> result{
        {"coloured", coloured}, {"emissive", emissive}, {"double-sided", doubleSided}, {"unlit", unlit}};
    for (std::uint32_t image = 0; image < 5; ++image) {
        Material color, data, masked;
        color.baseColorTexture = textureOf(image);
        data.metallicRoughnessTexture = textureOf(image);
        data.normalTexture = textureOf(image);
        masked.baseColorTexture = textureOf(image);
        masked.alphaMode = AlphaMode::mask;
        result.push_back({"textured", color});
        result.push_back({"metallic-roughness and normal map", data});
        result.push_back({"masked", masked});
    }
    result.push_back({"original", Material{}});
    return result;
}

class MaterialChangeTest : public DrawingTest {
  protected:
    static GpuScene uploadLit(const Scene& scene) {
        GpuSceneOptions options = subdividing(2);
        options.vertexEvaluator = VertexEvaluator::compute;
        GpuScene uploaded(context(), scene, options);
        uploaded.setLights({&light, 1});
        return uploaded;
    }
    static void expectImagesOfNewScenes(Scene changing) {
        GpuScene changed = uploadLit(changing);
        HdrImage last = drawn(changed, inputs);
        for (const Change& change : changes()) {
            SCOPED_TRACE(change.name);
            changed.setMaterial(0, change.material);
            changing.materials[0] = change.material;
            const HdrImage picture = drawn(changed, inputs);
            EXPECT_EQ(picture.rgba, drawn(uploadLit(changing), inputs).rgba);
            EXPECT_NE(picture.rgba, last.rgba) << "the change shows";
            last = picture;
        }
    }
    static inline const WorldLight light = pointLight({1, 3, 5}, 30.0f, glm::vec3(30.0f));
};

TEST_F(MaterialChangeTest, anyChangeGivesTheImageOfANewScene) {
    expectImagesOfNewScenes(scene());
}

TEST_F(MaterialChangeTest, imagesUsedByOtherMaterialsWithAnotherEncodingDoToo) {
    expectImagesOfNewScenes(sceneOfUsedImages());
}

TEST_F(MaterialChangeTest, surfaceWithoutCoordinatesCanEmit) {
    Scene changing = scene();
    changing.images.clear();
    GpuScene changed = uploadLit(changing);
    drawn(changed, inputs);
    changing.materials[1].emission = {0.0f, 2.0f, 0.0f};
    changed.setMaterial(1, changing.materials[1]);
    EXPECT_EQ(drawn(changed, inputs).rgba, drawn(uploadLit(changing), inputs).rgba);
}

TEST_F(MaterialChangeTest, emissionIsDrawnLastAfterAChange) {
    // A surface in front hides an emissive one, whichever of the two became emissive.
    Material white;
    Scene twoQuads = sceneOf(makeQuad(1.0f), white);
    place(twoQuads, makeQuad(1.0f), white, glm::translate(glm::mat4(1.0f), {0, 0, 1}));
    GpuScene changed = uploadLit(twoQuads);
    twoQuads.materials[0].emission = glm::vec3(4.0f);
    changed.setMaterial(0, twoQuads.materials[0]);
    EXPECT_EQ(drawn(changed, inputs).rgba, drawn(uploadLit(twoQuads), inputs).rgba);
}

TEST_F(MaterialChangeTest, invalidMaterialsAreErrorsAndChangeNothing) {
    GpuScene uploaded = uploadLit(scene());
    const HdrImage before = drawn(uploaded, inputs);
    const auto errorOfEdit = [&](std::uint32_t index, const Material& material) -> std::string {
        try {
            uploaded.setMaterial(index, material);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            return error.what();
        }
        return "";
    };
    Material noImage, tooRough, otherSet;
    noImage.baseColorTexture = textureOf(5);
    tooRough.roughness = 1.5f;
    otherSet.baseColorTexture = textureOf(0);
    otherSet.baseColorTexture->uvSet = 1;
    EXPECT_NE(errorOfEdit(0, noImage).find("image"), std::string::npos);
    EXPECT_NE(errorOfEdit(0, tooRough).find("roughness"), std::string::npos);
    EXPECT_NE(errorOfEdit(0, otherSet).find("coordinates 1"), std::string::npos);
    otherSet.baseColorTexture->uvSet = 0;
    EXPECT_NE(errorOfEdit(1, otherSet).find("coordinates 0"), std::string::npos) << "the sphere has none";
    EXPECT_EQ(drawn(uploaded, inputs).rgba, before.rgba);
}

}  // namespace
}  // namespace candela::test
