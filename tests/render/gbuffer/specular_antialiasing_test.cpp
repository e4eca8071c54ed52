// Roughness that is widened by the screen-space variation of the shading normal.

#include "gbuffer/gbuffer_drawing.h"

#include <candela/gbuffer.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <vector>

namespace candela::test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

Material metal(float roughness) {
    Material material;
    material.metallic = 1.0f;
    material.roughness = roughness;
    return material;
}

class SpecularAntialiasingTest : public GBufferTest {
  protected:
    static AovReader drawnSurfaces(const Scene& scene, bool antialiasing, int side = size) {
        GpuScene uploaded = upload(scene);
        FrameRequest request = frameOf(front, side, side);
        request.specularAntialiasing = antialiasing;
        render(uploaded, request);
        return aovs(side);
    }
};

TEST_F(SpecularAntialiasingTest, flatSurfacesKeepTheirRoughness) {
    for (std::uint32_t i = 0; i < 8; ++i) {
        Material masked = metal(0.2f * hashed(100, i));
        masked.alphaMode = i % 2 == 0 ? AlphaMode::mask : AlphaMode::opaque;  // textured and plain programs
        const glm::mat4 tilted = glm::rotate(glm::mat4(1.0f), 0.3f + 0.2f * float(i), {0.6f, 0.8f, 0.0f});
        const Scene scene = sceneOf(makeQuad(1.0f), masked, tilted);
        const AovReader on = drawnSurfaces(scene, true), off = drawnSurfaces(scene, false);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(on.scalar("roughness", x, y), off.scalar("roughness", x, y)) << x << ", " << y;
    }
}

TEST_F(SpecularAntialiasingTest, offKeepsTheRoughnessOfCurvedSurfaces) {
    const AovReader reader = drawnSurfaces(sceneOf(makeSphere(0.9f), metal(0.5f)), false);
    const float packed = unpackSurface(packSurface({.lobes = {.roughness = 0.5f}})).lobes.roughness;
    EXPECT_EQ(reader.scalar("roughness", middle, middle), packed);
    EXPECT_EQ(reader.scalar("roughness", middle + 7, middle - 5), packed);
}

/// A square whose normals spread as those of a sphere would: the same derivatives all over its triangles.
Mesh spreadSquare(float spread) {
    Mesh mesh = makeQuad(1.0f);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        mesh.normals[i] = glm::normalize(glm::vec3(spread * glm::vec2(mesh.positions[i]), 1.0f));
    return mesh;
}

// Derivatives are differences within blocks of 2 × 2 pixels, which the picture's normals give.
TEST_F(SpecularAntialiasingTest, curvedSurfacesAreWidenedByTheirNormals) {
    constexpr int side = 16;
    for (const float roughness : {0.0f, 0.2f, 0.6f}) {
        const AovReader reader = drawnSurfaces(sceneOf(spreadSquare(0.8f), metal(roughness)), true, side);
        for (int y = 0; y < side; y += 2) {
            for (int x = 0; x < side; x += 2) {
                const auto normal = [&](int dx, int dy) {
                    return glm::dvec3(reader.vector("N", x + dx, y + dy));
                };
                // The block's lower left pixel takes the differences to the right and up.
                const glm::dvec3 across = normal(1, 1) - normal(0, 1), up = normal(0, 0) - normal(0, 1);
                const double variance = glm::dot(across, across) + glm::dot(up, up);
                const double alpha = std::max(double(roughness) * roughness, minAlpha);
                const double expected = std::pow(alpha * alpha + variance / pi, 0.25);
                // Half a step of the packed roughness is 0.5 to 1.1 %, and normals are known to 0.0005 of
                // differences of 0.06, by the fourth root.
                EXPECT_NEAR(reader.scalar("roughness", x, y + 1) / expected, 1.0, 0.02) << x << ", " << y;
            }
        }
    }
}

// The code of a widened roughness is that of an approximate root, which may lie below the code of the
// roughness.
TEST_F(SpecularAntialiasingTest, noRoughnessBecomesLess) {
    constexpr int side = 16;
    for (int step = 1; step <= 40; ++step) {
        // By 4e-4 and 4e-3 of alpha²: less than half a step of the code.
        const float roughness = 0.025f * static_cast<float>(step), alpha = roughness * roughness;
        for (const float spread : {1.2f * side * alpha * 0.01f, 4.0f * side * alpha * 0.01f}) {
            const Scene scene = sceneOf(spreadSquare(spread), metal(roughness));
            const AovReader on = drawnSurfaces(scene, true, side), off = drawnSurfaces(scene, false, side);
            for (int i = 0; i < side * side; ++i)
                ASSERT_GE(on.scalar("roughness", i % side, i / side),
                          off.scalar("roughness", i % side, i / side))
                    << roughness << ", " << spread;
        }
    }
}

/// A square of 2 m with bumps: as many sine waves along each side, whose slope is at most `slope`.
Mesh bumpySquare(int waves, float slope) {
    constexpr int pointsPerWave = 10;
    const int points = waves * pointsPerWave + 1;
    Mesh mesh;
    for (int row = 0; row < points; ++row) {
        for (int column = 0; column < points; ++column) {
            const glm::vec2 uv = glm::vec2(column, row) / float(points - 1);
            const glm::vec2 phase = uv * (2.0f * pi * float(waves));
            const float frequency = pi * float(waves), height = slope / frequency;
            mesh.positions.emplace_back(2.0f * uv - 1.0f, height * std::sin(phase.x) * std::sin(phase.y));
            mesh.normals.push_back(
                glm::normalize(glm::vec3(-slope * std::cos(phase.x) * std::sin(phase.y),
                                         -slope * std::sin(phase.x) * std::cos(phase.y), 1.0f)));
        }
    }
    for (int row = 0; row + 1 < points; ++row) {
        for (int column = 0; column + 1 < points; ++column) {
            const auto at = [&](int dx, int dy) { return std::uint32_t((row + dy) * points + column + dx); };
            mesh.indices.insert(mesh.indices.end(),
                                {at(0, 0), at(1, 0), at(0, 1), at(0, 1), at(1, 0), at(1, 1)});
        }
    }
    return mesh;
}

/// The camera of a frame of a slow move past the square, 3 m away.
CameraView movingView(int frame) {
    const float x = 0.011f * float(frame);
    return lookAt({x, 0.004f * float(frame), 3.0f}, {x, 0.0f, 0.0f}, 0.55f);
}

std::vector<float> greenOf(const HdrImage& picture) {
    std::vector<float> green;
    for (std::size_t i = 1; i < picture.rgba.size(); i += 4) green.push_back(picture.rgba[i]);
    return green;
}

// A bumpy metal whose bumps are 2.5 pixels apart, in motion: single frames against frames of 1,024 samples a
// pixel with the exact roughness. The numbers are those of docs/lighting.md.
TEST_F(SpecularAntialiasingTest, aBumpyMetalInMotionSparklesLess) {
    constexpr int side = 48, frames = 6;
    constexpr int samplesAcross = 32;  // 1,024 samples a pixel
    GpuScene scene = upload(sceneOf(bumpySquare(24, 0.35f), metal(0.15f)),
                            std::vector{pointLight({1.5f, 2.0f, 3.0f}, 1.0e3f, glm::vec3(30.0f)),
                                        pointLight({-2.0f, 0.5f, 3.0f}, 1.0e3f, glm::vec3(30.0f))});
    const auto picture = [&](const CameraView& view, int pixels, bool antialiasing) {
        FrameRequest request{pixels, pixels, view, BrdfModel::gltf, Technique::tiles};
        request.specularAntialiasing = antialiasing;
        return greenOf(drawn(scene, request));
    };
    const auto reference = [&](const CameraView& view) {
        const std::vector<float> fine = picture(view, side * samplesAcross, false);
        std::vector<double> sum(std::size_t(side) * side);
        for (int y = 0; y < side * samplesAcross; ++y)
            for (int x = 0; x < side * samplesAcross; ++x)
                sum[std::size_t(y / samplesAcross * side + x / samplesAcross)] +=
                    fine[std::size_t(y * side * samplesAcross + x)] / double(samplesAcross * samplesAcross);
        return sum;
    };
    double mean = 0.0;
    std::array<double, 2> variance{}, flicker{};
    std::array<std::vector<float>, 2> last;
    for (int frame = 0; frame < frames; ++frame) {
        const CameraView view = movingView(frame);
        const std::vector<double> expected = reference(view);
        for (const double value : expected) mean += value / (double(expected.size()) * frames);
        for (std::size_t on = 0; on < 2; ++on) {
            const std::vector<float> single = picture(view, side, on == 1);
            for (std::size_t k = 0; k < single.size(); ++k) {
                variance[on] += (single[k] - expected[k]) * (single[k] - expected[k]);
                if (!last[on].empty()) flicker[on] += (single[k] - last[on][k]) * (single[k] - last[on][k]);
            }
            last[on] = single;
        }
    }
    const double values = double(side) * side;
    for (std::size_t on = 0; on < 2; ++on)
        std::printf("%s: error of a frame %.2f, change from frame to frame %.2f, relative to the mean\n",
                    on == 1 ? "on" : "off", std::sqrt(variance[on] / (values * frames)) / mean,
                    std::sqrt(flicker[on] / (values * (frames - 1))) / mean);
    EXPECT_LT(variance[1], 0.25 * variance[0]);
    EXPECT_LT(flicker[1], 0.25 * flicker[0]);
}

}  // namespace
}  // namespace candela::test
