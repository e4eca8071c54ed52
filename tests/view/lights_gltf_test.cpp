// Lights and cameras as a glTF file.

#include "lights_gltf.h"

#include <candela/scene.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <vector>

namespace {

using Json = nlohmann::json;

Json parsed(const std::vector<candela::WorldLight>& lights, const std::vector<SavedCamera>& cameras,
            const glm::dvec3& origin = glm::dvec3(0.0)) {
    return Json::parse(lightsGltf(lights, cameras, origin));
}

TEST(LightsGltf, HasColoursOfAtMostOneAndExactIntensities) {
    for (const glm::vec3& intensity :
         {glm::vec3(0.1f, 0.2f, 0.3f), glm::vec3(1.0f), glm::vec3(3.3e4f, 1e-3f, 0.0f), glm::vec3(0.0f),
          glm::vec3(1e20f), glm::vec3(1e-30f)}) {
        candela::WorldLight light;
        light.intensity = intensity;
        const Json file = parsed({light}, {});
        const Json& json = file["extensions"]["KHR_lights_punctual"]["lights"][0];
        for (int channel = 0; channel < 3; ++channel) {
            const auto color = json["color"][static_cast<std::size_t>(channel)].get<float>();
            EXPECT_LE(color, 1.0f);
            EXPECT_EQ(color * json["intensity"].get<float>(), intensity[channel]);
        }
        EXPECT_FALSE(json.contains("range")) << "none was given";
        EXPECT_FALSE(json.contains("extras"));
    }
}

TEST(LightsGltf, TurnsSpotLightsAlongTheirDirection) {
    for (const glm::vec3& direction : {glm::vec3(0.0f, 0.0f, -1.0f), glm::vec3(0.0f, -1.0f, 0.0f),
                                       glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.6f, 0.0f, 0.8f)}) {
        candela::WorldLight light;
        light.type = candela::LightType::spot;
        light.direction = direction;
        const Json matrix = parsed({light}, {})["nodes"][0]["matrix"];
        glm::mat3 rotation(1.0f);
        for (int i = 0; i < 9; ++i)
            rotation[i / 3][i % 3] = matrix[static_cast<std::size_t>(i / 3 * 4 + i % 3)].get<float>();
        EXPECT_EQ(-rotation[2], direction);
        // Of a rotation; products of unit vectors are rounded to 1e-7.
        EXPECT_NEAR(glm::determinant(rotation), 1.0f, 1e-6f);
    }
}

TEST(LightsGltf, PlacesLightsFarFromTheOriginInFullPrecision) {
    candela::WorldLight light;
    light.position = {0.25f, -1.0f, 0.0f};
    const Json place = parsed({light}, {}, {1e8, 0.0, 5e8})["nodes"][0]["translation"];
    EXPECT_EQ(place, Json({1e8 + 0.25, -1.0, 5e8}));
}

TEST(LightsGltf, HasBothKindsOfCameras) {
    candela::CameraView view;
    view.nearPlane = 0.5f;
    candela::CameraView flat = view;
    flat.orthographicHeight = 3.0f;
    flat.farPlane = 20.0f;
    const Json file = parsed({}, {{"one", view}, {"flat", flat}});
    EXPECT_EQ(file["cameras"][0]["perspective"]["yfov"].get<float>(), view.verticalFov);
    EXPECT_EQ(file["cameras"][0]["perspective"]["znear"], 0.5);
    EXPECT_FALSE(file["cameras"][0]["perspective"].contains("zfar"));
    EXPECT_EQ(file["cameras"][1]["orthographic"]["ymag"], 1.5);
    EXPECT_EQ(file["cameras"][1]["orthographic"]["zfar"], 20.0);
    EXPECT_EQ(file["nodes"][1]["camera"], 1);
}

TEST(LightsGltf, IsAlsoAGlb) {
    const std::string glb = glbOf("{}\n");
    ASSERT_EQ(glb.size(), 24u);
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, glb.data() + at, sizeof value);
        return value;
    };
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(number(4), 2u);
    EXPECT_EQ(number(8), 24u);
    EXPECT_EQ(number(12), 4u);
    EXPECT_EQ(glb.substr(16), "JSON{}\n ");
}

}  // namespace
