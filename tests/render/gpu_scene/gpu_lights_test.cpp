// The records of lights: what each holds, their order, when they are uploaded, and the memory that they take.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "render/gpu_scene/gpu_lights.h"
#include "render/layout.h"
#include "render/sampling/sample_sequence.h"

#include <candela/threads.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace candela::test {
namespace {

const RangeRule rule{Bounds{glm::vec3(-1.0f), glm::vec3(1.0f)}, 0.01};

/// A light whose kind and values follow from its number: of four, two points, a spot and a directional light.
WorldLight lightOf(std::uint32_t i) {
    constexpr LightType types[] = {LightType::point, LightType::spot, LightType::point,
                                   LightType::directional};
    const auto value = static_cast<float>(i);
    WorldLight light;
    light.type = types[i % 4];
    light.position = {value, 2.0f, -value};
    light.range = i % 5 == 0 ? 0.0f : 1.0f + static_cast<float>(i % 7);
    light.direction = glm::normalize(glm::vec3(1.0f, static_cast<float>(i % 3), 0.5f));
    light.intensity = {1.0f, static_cast<float>(i % 11), 3.0f};
    light.outerConeAngle = 0.5f;
    light.castsShadow = i % 3 != 0;
    light.radius = i % 6 == 0 ? 0.25f : 0.0f;
    return light;
}

std::vector<WorldLight> mixedLights(std::uint32_t count) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < count; ++i) lights.push_back(lightOf(i));
    return lights;
}

/// The numbers of the lights in the order of their records.
std::vector<std::uint32_t> recordOrder(const std::vector<WorldLight>& lights) {
    std::vector<std::uint32_t> order;
    for (const LightType type : {LightType::point, LightType::spot, LightType::directional})
        for (std::uint32_t i = 0; i < lights.size(); ++i)
            if (lights[i].type == type) order.push_back(i);
    return order;
}

std::vector<glm::vec4> onDevice(const GpuLights& lights) {
    std::vector<glm::vec4> texels(lights.recordData().size());
    glGetNamedBufferSubData(lights.records().buffer(), 0,
                            static_cast<GLsizeiptr>(texels.size() * sizeof(glm::vec4)), texels.data());
    return texels;
}

std::vector<glm::vec4> inMemory(const GpuLights& lights) {
    return {lights.recordData().begin(), lights.recordData().end()};
}

class GpuLightsTest : public DrawingTest {
  protected:
    static void SetUpTestSuite() {
        DrawingTest::SetUpTestSuite();
        context().makeCurrent();
    }
};

// More lights than several threads convert at a time, so that kinds and lists continue across chunks.
TEST_F(GpuLightsTest, recordsHoldTheLightsOfEachKindInOrder) {
    const std::vector<WorldLight> lights = mixedLights(40'003);
    GpuLights records(glm::dmat3(1.0), LightUpload::whenBound);
    records.set(lights, rule);
    const std::vector<std::uint32_t> order = recordOrder(lights);
    EXPECT_EQ(records.counts().points, 20'002);
    EXPECT_EQ(records.counts().spots, 10'001);
    EXPECT_EQ(records.counts().directionals, 10'000);
    EXPECT_EQ(records.counts().shadowed, 26'668);
    EXPECT_EQ(records.report().rangesAssigned, 6'001u) << "points and spots whose number is a multiple of 5";
    ASSERT_EQ(records.recordData().size(), lights.size() * layout::LIGHT_TEXELS);
    for (std::size_t record = 0; record < order.size(); ++record) {
        const WorldLight& light = lights[order[record]];
        const glm::vec4* texels = records.recordData().data() + record * layout::LIGHT_TEXELS;
        ASSERT_EQ(texels[1], glm::vec4(light.intensity, light.castsShadow ? 1.0f : 0.0f)) << order[record];
        if (light.type == LightType::directional) {
            ASSERT_EQ(texels[0], glm::vec4(-light.direction, 0.0f)) << order[record];
            continue;
        }
        const float range = records.reaches().range[record];
        if (light.range > 0.0f)
            ASSERT_EQ(range, light.range) << order[record];
        else
            ASSERT_GT(range, 0.0f) << order[record];
        ASSERT_EQ(texels[0], glm::vec4(light.position, 1.0f / (range * range))) << order[record];
        ASSERT_EQ(records.reaches().position(record), light.position) << order[record];
    }
}

TEST_F(GpuLightsTest, lightsWithARadiusMoveWithTheSample) {
    const std::vector<WorldLight> lights = mixedLights(20'000);
    GpuLights records(glm::dmat3(1.0), LightUpload::whenBound);
    records.set(lights, rule);
    records.setSample(5);
    const std::vector<std::uint32_t> order = recordOrder(lights);
    for (std::size_t record = 0; record < records.reaches().size(); ++record) {
        const WorldLight& light = lights[order[record]];
        const glm::vec3 expected = light.position + light.radius * glm::vec3(lightPoint(5, order[record]));
        ASSERT_EQ(records.reaches().position(record), expected) << order[record];
    }
}

TEST_F(GpuLightsTest, theFirstFaultyLightIsNamed) {
    std::vector<WorldLight> lights = mixedLights(30'000);
    lights[29'000].range = -1.0f;
    lights[20'001].radius = -1.0f;
    GpuLights records(glm::dmat3(1.0), LightUpload::whenBound);
    records.set(std::span(lights).first(10), rule);
    expectRefused([&] { records.set(lights, rule); }, "light 20001: its radius");
    EXPECT_EQ(records.report().lights, 10u) << "nothing is changed";
}

TEST_F(GpuLightsTest, theDeviceHasWhatWasEditedBeforeItIsAsked) {
    for (const LightUpload when : {LightUpload::atOnce, LightUpload::whenBound}) {
        std::vector<WorldLight> lights = mixedLights(1000);
        GpuLights records(glm::dmat3(1.0), when);
        records.set(lights, rule);
        EXPECT_EQ(onDevice(records), inMemory(records));
        // Two edits of which only the second is followed by a look at the device, and one of more records
        // than are worth sorting.
        for (const std::uint32_t moved : {1u, 2u, 600u}) {
            for (std::uint32_t i = 0; i < moved; ++i) {
                lights[i].position.y += 1.0f;
                records.move(i, lights[i]);
            }
            const std::size_t uploaded = records.upload();
            EXPECT_EQ(uploaded, moved < 600 ? moved : 1000u);
            if (moved == 1) continue;
            EXPECT_EQ(onDevice(records), inMemory(records)) << moved << " moved";
        }
        EXPECT_EQ(records.upload(), 0u) << "nothing has changed";
        records.set(mixedLights(3000), rule);
        EXPECT_EQ(onDevice(records), inMemory(records)) << "after more lights";
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// A value of /proc/self/status in bytes: "VmRSS:" is what the process has, "VmHWM:" the most it has had.
std::size_t memoryOf(const std::string& key) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(key)) return std::strtoull(line.c_str() + key.size(), nullptr, 10) * 1024;
    return 0;
}

// The records take 32 bytes, and what culling reads 16, of the 60 bytes of a light. The rest of what is
// allowed is for the lists of those in view.
TEST_F(GpuLightsTest, aMillionLightsTakeLessThanOneAndAHalfCopies) {
    if (!context().isSoftware()) GTEST_SKIP() << "the driver's own copies count too";
    Scene scene;
    GpuScene uploaded(context(), scene);
    render(uploaded, {64, 48, lookAt({0, 0, 6}, {0, 0, 0}, 0.8f), BrdfModel::course, Technique::tiles});
    std::vector<WorldLight> lights(1'000'000);
    for (std::size_t i = 0; i < lights.size(); ++i)
        lights[i].position = {static_cast<float>(i % 1000), static_cast<float>(i / 1000), 0.0f};
    for (WorldLight& light : lights) light.range = 0.3f;
    // Makes the most so far what it is now.
    if (!(std::ofstream("/proc/self/clear_refs") << 5 << std::flush))
        GTEST_SKIP() << "the system does not tell";
    const std::size_t before = memoryOf("VmRSS:");
    for (int frame = 0; frame < 2; ++frame) {
        uploaded.setLights(lights);
        render(uploaded, {64, 48, lookAt({0, 0, 6}, {0, 0, 0}, 0.8f), BrdfModel::course, Technique::tiles});
    }
    const auto more = static_cast<double>(memoryOf("VmHWM:") - before);
    EXPECT_LE(more / static_cast<double>(lights.size() * sizeof(WorldLight)), 1.5);
}

#endif

}  // namespace
}  // namespace candela::test
