// What the host accepts and refuses of an environment.
#include "expect_error.h"
#include "host_calls.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>

namespace candela {
namespace {

constexpr std::array<float, 32> texels{1, 2, 3, 1, 4, 5, 6, 1};

candela_environment environment() {
    candela_environment environment{};
    environment.struct_size = sizeof environment;
    environment.name = "hall";
    environment.width = 4;
    environment.height = 2;
    environment.pixels = texels.data();
    environment.pixels_size = sizeof texels;
    environment.rotation[3] = 1.0f;
    environment.intensity = 0.5f;
    return environment;
}

void set(const candela_host& host, const candela_environment& source) {
    host.set_environment(host.self, &source);
}

TEST(HostEnvironment, TakesEveryMember) {
    const Scene plain = importedScene([](const candela_host& host) { set(host, environment()); });
    ASSERT_TRUE(plain.environment);
    EXPECT_EQ(plain.environment->picture.name, "hall");
    EXPECT_EQ(plain.environment->picture.width, 4u);
    EXPECT_EQ(plain.environment->picture.height, 2u);
    EXPECT_EQ(plain.environment->picture.pixels.size(), sizeof texels);
    EXPECT_EQ(std::memcmp(plain.environment->picture.pixels.data(), texels.data(), sizeof texels), 0);
    EXPECT_EQ(plain.environment->rotation, glm::quat(1, 0, 0, 0));
    EXPECT_EQ(plain.environment->intensity, 0.5f);
    EXPECT_TRUE(plain.environment->isBackground);
    EXPECT_FALSE(plain.environment->occlusionDistance);
    EXPECT_NO_THROW(validate(plain));

    const Scene other = importedScene([](const candela_host& host) {
        set(host, modified(environment(), [](candela_environment& e) {
                e.rotation[1] = 1.0f;
                e.rotation[3] = 0.0f;
                e.is_hidden = 1;
                e.occlusion_distance = 2.5f;
            }));
    });
    EXPECT_EQ(other.environment->rotation, glm::quat(0, 0, 1, 0));
    EXPECT_FALSE(other.environment->isBackground);
    EXPECT_EQ(other.environment->occlusionDistance, 2.5f);
}

TEST(HostEnvironment, RefusesWhatIsWrong) {
    const auto expectRefused = [](const std::function<void(candela_environment&)>& modify,
                                  const std::string& text) {
        const auto addAll = [&](const candela_host& host) { set(host, modified(environment(), modify)); };
        EXPECT_EQ(expectError([&] { importedScene(addAll); }, ErrorKind::badInput, ""), "test: " + text);
    };
    expectRefused([](auto& e) { e.struct_size = 64; },
                  "set_environment: struct_size is 64, but version 1.5 has 72 bytes");
    expectRefused([](auto& e) { e.width = 0; },
                  "environment 'hall': width is 0, but 1 to 32768 was expected");
    expectRefused([](auto& e) { e.pixels_size = 16; },
                  "environment 'hall': pixels_size is 16, but 4 × 2 texels of 16 bytes make 128");
    expectRefused([](auto& e) { e.pixels = nullptr; }, "environment 'hall': pixels is NULL");
    static std::array<float, 32> broken{};
    broken[5] = -1.0f;
    expectRefused([](auto& e) { e.pixels = broken.data(); },
                  "environment 'hall': the texel in row 0, column 1 holds -1, but 0 or more was expected");
    expectRefused([](auto& e) { e.rotation[3] = 0.5f; },
                  "environment 'hall': rotation has the length 0.5, but a unit quaternion was expected");
    expectRefused([](auto& e) { e.intensity = -1.0f; },
                  "environment 'hall': intensity is -1, but 0 or more was expected");
    expectRefused([](auto& e) { e.is_hidden = 2; },
                  "environment 'hall': is_hidden is 2, but 0 or 1 was expected");
    expectRefused([](auto& e) { e.occlusion_distance = NAN; },
                  "environment 'hall': occlusion_distance is nan, but a finite number was expected");
    const auto twice = [](const candela_host& host) {
        set(host, environment());
        set(host, environment());
    };
    EXPECT_EQ(expectError([&] { importedScene(twice); }, ErrorKind::badInput, ""),
              "test: set_environment: the scene has an environment already");
    EXPECT_EQ(
        expectError(
            [] { importedScene([](const candela_host& host) { host.set_environment(host.self, nullptr); }); },
            ErrorKind::badInput, ""),
        "test: set_environment: the struct is NULL");
}

}  // namespace
}  // namespace candela
