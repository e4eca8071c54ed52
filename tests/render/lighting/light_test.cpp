// Lights in images against closed forms, and the light report of GpuScene.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace candela::test {
namespace {

constexpr int size = 33, middle = size / 2;
constexpr float pi = std::numbers::pi_v<float>;
/// Some forty roundings of single precision.
constexpr float rounding = 3.0e-6f;

/// Looks down the Z axis from 3 m on the square of 2 m; the middle pixel looks along the axis.
CameraView front() {
    return lookAt({0, 0, 3}, {0, 0, 0}, 2.0f * std::atan(1.0f / 3.0f));
}

Material white(float roughness = 1.0f) {
    Material material;
    material.roughness = roughness;
    return material;
}

/// The diffuse part of a white dielectric of roughness 1 at normal incidence, times pi.
const float diffusePart = 1.0f - float(specularAlbedo(BrdfModel::course, glm::dvec3(0.04), 1.0, 1.0).x);
/// f(n, n) of it, with a lobe of 0.04 / (4 pi) for D = 1 / pi.
const float normalIncidence = (diffusePart + 0.01f) / pi;

class LightTest : public DrawingTest {
  protected:
    static HdrImage lit(const Scene& scene, const std::vector<WorldLight>& lights, Technique technique,
                        BrdfModel model = BrdfModel::course) {
        return drawn(upload(scene, lights), {size, size, front(), model, technique});
    }
    static float middleOf(const HdrImage& picture) { return pixelOf(picture, middle, middle).g; }
};

TEST_F(LightTest, inverseSquareAndWindowOnTheAxis) {
    const Scene scene = sceneOf(makeQuad(1.0f), white());
    for (const Technique technique : techniques) {
        for (const float distance : {0.002f, 0.1f, 1.0f, 2.0f, 7.0f, 9.9f}) {
            constexpr float range = 10.0f, candela = 12.0f;
            const float window = 1.0f - std::pow(distance / range, 4.0f);
            const float expected = normalIncidence * candela / (distance * distance) * window;
            const auto picture =
                lit(scene, {pointLight({0, 0, distance}, range, glm::vec3(candela))}, technique);
            // The surface, 3 m away, is known to 3.6e-7 m: twice that over the distance is the error of the
            // inverse square. The window cancels near its end: a rounding of 1 there is 25 of the remainder.
            const float tolerance = rounding / window + 2.0f * 3.6e-7f / distance;
            EXPECT_NEAR(middleOf(picture), expected, tolerance * expected) << distance;
        }
    }
}

TEST_F(LightTest, unitIsTheRadianceOfAWhiteLambertSurfaceAtOneMetre) {
    // The punctual intensity pi candela gives radiance 1 but for the specular part.
    const auto picture = lit(sceneOf(makeQuad(1.0f), white()), {pointLight({0, 0, 1}, 1e6f, glm::vec3(pi))},
                             Technique::fullscreen);
    EXPECT_NEAR(middleOf(picture), diffusePart + 0.01f, 1e-5f);
}

TEST_F(LightTest, modelsAtNormalIncidence) {
    for (const float metallic : {0.0f, 1.0f}) {
        Material material = white();
        material.metallic = metallic;
        const float f0 = metallic > 0.0f ? 1.0f : 0.04f;
        const float lobe = 1.0f / (4.0f * pi);
        const auto diffuse = [&](BrdfModel model) {
            return (1.0f - float(specularAlbedo(model, glm::dvec3(f0), 1.0, 1.0).x)) * (1.0f - metallic) / pi;
        };
        const float albedo = float(directionalAlbedo(BrdfModel::gltf, 1.0, 1.0));
        const float gain = 1.0f + f0 * (1.0f - albedo) / albedo;
        for (const Technique technique : techniques) {
            const std::vector<WorldLight> light{pointLight({0, 0, 1}, 1e6f, glm::vec3(1))};
            const Scene scene = sceneOf(makeQuad(1.0f), material);
            EXPECT_NEAR(middleOf(lit(scene, light, technique)), diffuse(BrdfModel::course) + f0 * lobe,
                        1e-5f);
            EXPECT_NEAR(middleOf(lit(scene, light, technique, BrdfModel::gltf)),
                        diffuse(BrdfModel::gltf) + f0 * lobe * gain, 1e-5f);
        }
    }
}

TEST_F(LightTest, atTheRangeAndBeyondIsExactlyBlack) {
    const Scene scene = sceneOf(makeQuad(1.0f), white());
    for (const Technique technique : techniques) {
        for (const float distance : {2.00001f, 2.1f, 5.0f})
            EXPECT_EQ(middleOf(lit(scene, {pointLight({0, 0, distance}, 2.0f, glm::vec3(1e6f))}, technique)),
                      0.0f);
        EXPECT_GT(middleOf(lit(scene, {pointLight({0, 0, 1.99f}, 2.0f, glm::vec3(1e6f))}, technique)), 0.0f);
    }
}

TEST_F(LightTest, spotIsAPointLightTimesItsRamp) {
    const Scene scene = sceneOf(makeQuad(1.0f), white());
    const glm::vec3 position(0.2f, -0.1f, 1.0f), target(-0.1f, 0.2f, 0.0f);
    constexpr float inner = 0.2f, outer = 0.6f;
    const WorldLight spot = spotLight(position, target, 5.0f, glm::vec3(4), inner, outer);
    for (const Technique technique : techniques) {
        const HdrImage point = lit(scene, {pointLight(position, 5.0f, glm::vec3(4))}, technique);
        GpuScene uploaded = upload(scene, std::vector{spot});
        const HdrImage cone = drawn(uploaded, {size, size, front(), BrdfModel::course, technique});
        const AovReader reader = aovs(size);
        int dark = 0, full = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const float cosine =
                    glm::dot(glm::normalize(reader.vector("P", x, y) - position), spot.direction);
                const float ramp = (cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
                const float factor = ramp <= 0.0f ? 0.0f : std::min(ramp, 1.0f) * std::min(ramp, 1.0f);
                const float without = pixelOf(point, x, y).g, actual = pixelOf(cone, x, y).g;
                // The ramp's slope, 1 / (cos inner - cos outer), magnifies the cosine's rounding sixfold.
                ASSERT_NEAR(actual, without * factor, 1.0e-5f * without) << x << ", " << y;
                dark += ramp < -1e-5f && actual == 0.0f;
                full += ramp > 1.0f;
            }
        }
        EXPECT_GT(dark, 100);
        EXPECT_GT(full, 20);
    }
}

TEST_F(LightTest, directionalLightIsTheSameEverywhereAndComesFromItsDirection) {
    // Far more than the picture's size: no inverse square, no range.
    const Scene nearer = sceneOf(makeQuad(1.0f), white());
    for (const Technique technique : techniques) {
        const WorldLight sun = directionalLight({0, 0, -1}, glm::vec3(3));
        EXPECT_NEAR(middleOf(lit(nearer, {sun}, technique)), 3.0f * normalIncidence, rounding);
        WorldLight elsewhere = sun;
        elsewhere.position = {1e6f, 0, -1e6f};
        elsewhere.range = 0.001f;
        EXPECT_EQ(middleOf(lit(nearer, {elsewhere}, technique)), middleOf(lit(nearer, {sun}, technique)));
        EXPECT_EQ(middleOf(lit(nearer, {directionalLight({0, 0, 1}, glm::vec3(3))}, technique)), 0.0f)
            << "from behind";
    }
}

TEST_F(LightTest, lightsAddUp) {
    const Scene scene = sceneOf(makeQuad(1.0f), white(0.4f));
    const std::vector<WorldLight> lights{pointLight({0.5f, 0, 1}, 4, {1, 0.2f, 0}),
                                         spotLight({0, 0.5f, 1}, {0, 0, 0}, 4, {0, 1, 2}, 0.1f, 0.9f),
                                         directionalLight({0.2f, 0, -1}, {0.1f, 0.3f, 0.2f})};
    for (const Technique technique : techniques) {
        const HdrImage all = lit(scene, lights, technique);
        std::vector<float> sum(all.rgba.size(), 0.0f);
        for (const WorldLight& light : lights) {
            const HdrImage one = lit(scene, {light}, technique);
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one.rgba[i];
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            if (i % 4 == 3) continue;
            ASSERT_NEAR(all.rgba[i], sum[i], rounding * sum[i]);
        }
    }
}

TEST_F(LightTest, coloursAreConvertedToTheWorkingSpace) {
    GpuSceneOptions options;
    options.workingFromRec709 = glm::dmat3(0.5, 0.0, 0.25, 0.25, 1.0, 0.5, 0.0, 0.0, 2.0);
    const glm::vec3 intensity(0.9f, 0.5f, 0.1f), working(options.workingFromRec709 * glm::dvec3(intensity));
    for (const bool directional : {false, true}) {
        // The surface is white in the working space, so that only the light is converted.
        Scene scene = sceneOf(makeQuad(1.0f), white());
        scene.materials[0].baseColor = glm::vec4(1.0f);
        GpuScene uploaded(context(), scene, options);
        const WorldLight light =
            directional ? directionalLight({0, 0, -1}, intensity) : pointLight({0, 0, 1}, 1e6f, intensity);
        uploaded.setLights(std::vector{light});
        const glm::vec3 pixel = pixelOf(
            drawn(uploaded, {size, size, front(), BrdfModel::course, Technique::fullscreen}), middle, middle);
        const glm::vec3 base = aovs(size).vector("base_color", middle, middle);
        for (int c = 0; c < 3; ++c) {
            const float f = (diffusePart * base[c] + 0.01f) / pi;
            EXPECT_NEAR(pixel[c], f * working[c], 1e-5f) << c;
        }
    }
}

std::string errorOf(GpuScene& scene, const WorldLight& bad) {
    std::vector<WorldLight> lights(3, pointLight({0, 0, 1}, 1.0f, glm::vec3(1)));
    lights[2] = bad;
    try {
        scene.setLights(lights);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        return error.what();
    }
    return "no error";
}

TEST_F(LightTest, badNumbersNameTheLight) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    GpuScene scene = upload(sceneOf(makeQuad(1.0f), white()));
    const WorldLight good = spotLight({0, 0, 1}, {0, 0, 0}, 1.0f, glm::vec3(1), 0.1f, 0.5f);
    struct Case {
        const char* word;
        std::function<void(WorldLight&)> change;
    };
    const std::vector<Case> cases{
        {"position", [](WorldLight& l) { l.position.x = nan; }},
        {"position", [](WorldLight& l) { l.position.z = -inf; }},
        {"intensity", [](WorldLight& l) { l.intensity.y = nan; }},
        {"intensity", [](WorldLight& l) { l.intensity.y = -0.1f; }},
        {"intensity", [](WorldLight& l) { l.intensity.x = 1.1e20f; }},
        {"range", [](WorldLight& l) { l.range = -1.0f; }},
        {"range", [](WorldLight& l) { l.range = nan; }},
        {"range", [](WorldLight& l) { l.range = inf; }},
        {"radius", [](WorldLight& l) { l.radius = -0.1f; }},
        {"radius", [](WorldLight& l) { l.radius = nan; }},
        {"radius", [](WorldLight& l) { l.radius = inf; }},
        {"direction", [](WorldLight& l) { l.direction = glm::vec3(0); }},
        {"direction",
         [](WorldLight& l) {
             l.direction = {0, 0, nan};
         }},
        {"direction",
         [](WorldLight& l) {
             l.direction = {0, 0, 2};
         }},
        {"cone", [](WorldLight& l) { l.innerConeAngle = 0.5f; }},
        {"cone", [](WorldLight& l) { l.innerConeAngle = -0.1f; }},
        {"cone", [](WorldLight& l) { l.outerConeAngle = 1.6f; }},
        {"cone", [](WorldLight& l) { l.outerConeAngle = nan; }},
    };
    for (const Case& one : cases) {
        WorldLight bad = good;
        one.change(bad);
        const std::string text = errorOf(scene, bad);
        EXPECT_NE(text.find("light 2: its " + std::string(one.word)), std::string::npos) << text;
    }
    EXPECT_EQ(errorOf(scene, good), "no error");
}

TEST_F(LightTest, invalidLightsKeepTheOldOnes) {
    GpuScene scene =
        upload(sceneOf(makeQuad(1.0f), white()), std::vector{pointLight({0, 0, 1}, 9, glm::vec3(1))});
    const FrameRequest inputs{size, size, front(), BrdfModel::course, Technique::volumes};
    const std::vector<float> before = drawn(scene, inputs).rgba;
    WorldLight bad = pointLight({0, 0, 1}, -3.0f, glm::vec3(1));
    EXPECT_NE(errorOf(scene, bad), "no error");
    EXPECT_EQ(drawn(scene, inputs).rgba, before);
    EXPECT_EQ(scene.lightReport().lights, 1u);
}

/// A quad with a node that has a point light, and its image.
class MovingTest : public DrawingTest {
  protected:
    static Scene sceneWithLightOnANode(const glm::vec3& at) {
        Scene scene = sceneOf(makeQuad(1.0f), white(0.5f));
        Node node;
        node.transform = Transform{.translation = at};
        scene.nodes.push_back(node);
        Light light;
        light.range = 5.0f;
        light.intensity = 3.0f;
        light.node = 1;
        scene.lights.push_back(light);
        return scene;
    }
    static std::vector<float> imageOf(GpuScene& scene) {
        return drawn(scene, {size, size, front(), BrdfModel::course, Technique::volumes}).rgba;
    }
    static std::vector<float> imageOf(GpuScene&& scene) { return imageOf(scene); }
    static std::vector<float> imageOf(const Scene& scene) { return imageOf(GpuScene(context(), scene)); }
};

TEST_F(MovingTest, setTransformMovesLightsAndMeshes) {
    GpuScene scene(context(), sceneWithLightOnANode({0, 0, 1}));
    const std::vector<float> before = imageOf(scene);
    EXPECT_EQ(before, imageOf(sceneWithLightOnANode({0, 0, 1})));
    scene.setTransform(1, glm::translate(glm::mat4(1.0f), {0.5f, 0.2f, 0.7f}));
    EXPECT_NE(imageOf(scene), before);
    EXPECT_EQ(imageOf(scene), imageOf(sceneWithLightOnANode({0.5f, 0.2f, 0.7f})));
    const glm::mat4 rotated = glm::rotate(glm::mat4(1.0f), 0.4f, glm::vec3(0, 1, 0));
    scene.setTransform(0, rotated);
    Scene expected = sceneWithLightOnANode({0.5f, 0.2f, 0.7f});
    expected.nodes[0].transform = rotated;
    EXPECT_EQ(imageOf(scene), imageOf(expected));
}

TEST_F(MovingTest, setTransformMovesChildren) {
    Scene description = sceneWithLightOnANode({0, 0, 1});
    description.nodes[1].parent = 0;
    GpuScene scene(context(), description);
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), {0.3f, 0.2f, -0.5f});
    scene.setTransform(0, moved);
    description.nodes[0].transform = moved;
    EXPECT_EQ(imageOf(scene), imageOf(description));
    EXPECT_NE(imageOf(scene), imageOf(sceneWithLightOnANode({0, 0, 1})));
}

TEST_F(MovingTest, setTimePosesAnimatedNodes) {
    Scene description = sceneWithLightOnANode({0, 0, 1});
    AnimationChannel channel{
        1, AnimationPath::translation, Interpolation::linear, {0, 2}, {0, 0, 1, 1, 0, 1}};
    description.animations.push_back({"slide", {channel}});
    GpuScene scene(context(), description);
    const std::vector<float> start = imageOf(scene);
    scene.setTime(1.0);
    EXPECT_EQ(imageOf(scene), imageOf(sceneWithLightOnANode({0.5f, 0, 1})));
    scene.setTime(0.0);
    EXPECT_EQ(imageOf(scene), start);
}

TEST_F(MovingTest, setLightsReplacesThoseOfTheScenePermanently) {
    GpuScene scene(context(), sceneWithLightOnANode({0, 0, 1}));
    const WorldLight other = pointLight({0.2f, 0.2f, 0.5f}, 2.0f, {0, 1, 2});
    scene.setLights(std::vector{other});
    const std::vector<float> replaced = imageOf(scene);
    EXPECT_EQ(replaced, imageOf(upload(sceneOf(makeQuad(1.0f), white(0.5f)), std::vector{other})));
    scene.setTransform(1, glm::translate(glm::mat4(1.0f), {0.5f, 0.2f, 0.7f}));
    EXPECT_EQ(imageOf(scene), replaced);
    scene.setLights({});
    const std::vector<float> dark = imageOf(scene);
    for (std::size_t i = 0; i < dark.size(); ++i) {
        if (i % 4 == 3) continue;
        ASSERT_EQ(dark[i], 0.0f);
    }
}

TEST_F(MovingTest, lightsGrowAndShrinkInNumber) {
    GpuScene scene = upload(sceneOf(makeQuad(1.0f), white(0.5f)));
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        lights.push_back(
            pointLight({2 * hashed(1, i) - 1, 2 * hashed(2, i) - 1, 0.2f}, 0.4f, glm::vec3(0.01f)));
        if (i % 2 == 0)
            lights.back() = spotLight(lights.back().position, {0, 0, -1}, 0.4f, glm::vec3(0.01f), 0, 0.7f);
    }
    for (const std::size_t count : {10u, 5000u, 3u, 700u}) {
        const std::vector<WorldLight> some(lights.begin(), lights.begin() + std::ptrdiff_t(count));
        scene.setLights(some);
        EXPECT_EQ(imageOf(scene), imageOf(upload(sceneOf(makeQuad(1.0f), white(0.5f)), some))) << count;
    }
}

}  // namespace
}  // namespace candela::test
