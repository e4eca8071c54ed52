// Anisotropic metal under environments, against the integral of its lobe over the sky in double precision.

#include "shading/extended_brdf.h"
#include "support/drawing_test.h"
#include "support/lobe_pixels.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <vector>

namespace candela::test {
namespace {

constexpr int width = 96, height = 64;
constexpr std::array roughnesses{0.25f, 0.4f, 0.6f, 0.8f};
constexpr std::array strengths{0.3f, 0.6f, 1.0f};
const CameraView front = lookAt({0, 0, 9}, {0, 0, 0}, 0.7f);

Mesh sphereWithTangents() {
    Mesh mesh = makeSphere(0.9f, 64, 32);
    for (const glm::vec3& n : mesh.normals) {
        const glm::vec3 along(n.z, 0.0f, -n.x);
        const bool isPole = glm::length(along) < 1e-3f;
        mesh.tangents.emplace_back(isPole ? glm::vec3(1, 0, 0) : glm::normalize(along), 1.0f);
    }
    return mesh;
}

glm::vec2 centerOf(std::size_t roughness, std::size_t strength) {
    return {2.2f * (static_cast<float>(roughness) - 1.5f), 2.0f * (static_cast<float>(strength) - 1.0f)};
}

/// A column of metal spheres for each roughness, a row for each strength.
Scene sphereGrid() {
    Scene scene;
    for (std::size_t column = 0; column < roughnesses.size(); ++column) {
        for (std::size_t row = 0; row < strengths.size(); ++row) {
            Material material;
            material.baseColor = {0.9f, 0.7f, 0.4f, 1.0f};
            material.metallic = 1.0f;
            material.roughness = roughnesses[column];
            material.anisotropy.strength = strengths[row];
            material.anisotropy.rotation = 0.5f;
            place(scene, sphereWithTangents(), material,
                  glm::translate(glm::mat4(1.0f), glm::vec3(centerOf(column, row), 0.0f)));
        }
    }
    return scene;
}

struct Errors {
    double sum = 0.0, largest = 0.0;
    int count = 0;

    void add(double error) { sum += error, largest = std::max(largest, error), ++count; }
    double mean() const { return sum / std::max(count, 1); }
};

class AnisotropicEnvironmentTest : public DrawingTest {
  protected:
    /// One a strength.
    using RowErrors = std::array<Errors, strengths.size()>;

    /// Relative to the integral plus 5 % of the mean radiance of the sky.
    static RowErrors errorsUnder(const NamedSky& sky, BrdfModel model) {
        Scene scene = sphereGrid();
        scene.environment = Environment{.picture = sky.picture};
        GpuScene uploaded = upload(scene);
        const LobePixels lobes(context(), uploaded, front, width, height);
        FrameRequest request{width, height, front, model, Technique::tiles};
        request.specularAntialiasing = false;
        render(uploaded, request);
        const AovReader aovs(
            lastFrame().aovs({"N", "P", "base_color", "metallic", "roughness", "environment", "Z"}), width);
        const std::vector<SkyTexel> texels = texelsOf(sky.picture);
        double mean = 0.0;
        for (const SkyTexel& texel : texels)
            mean += texel.radiance.g * texel.solidAngle / (4.0 * std::numbers::pi);
        RowErrors errors;
        for (int y = 1; y < height; y += 3) {
            for (int x = 1; x < width; x += 3) {
                const auto extended = lobes.at(x, y, aovs.vector("N", x, y));
                if (!extended) continue;
                SurfacePoint surface;
                surface.position = aovs.vector("P", x, y);
                surface.normal = glm::normalize(glm::dvec3(aovs.vector("N", x, y)));
                surface.lobes = {glm::dvec3(aovs.vector("base_color", x, y)), aovs.scalar("metallic", x, y),
                                 aovs.scalar("roughness", x, y)};
                surface.extended = extended;
                const glm::dvec3 v = glm::normalize(glm::dvec3(front.eye()) - surface.position);
                const auto reflectionOf = extendedReflectionTowards(model, surface, v);
                glm::dvec3 expected(0.0);
                for (const SkyTexel& texel : texels) {
                    if (glm::dot(texel.direction, surface.normal) <= 0.0) continue;
                    expected += texel.radiance * texel.solidAngle * reflectionOf(texel.direction);
                }
                const glm::dvec3 actual(aovs.vector("environment", x, y));
                const double error = std::abs(actual.g - expected.g) / (expected.g + 0.05 * mean);
                const auto row = static_cast<std::size_t>(
                    std::clamp(static_cast<int>(std::lround(surface.position.y / 2.0 + 1.0)), 0, 2));
                errors[row].add(error);
            }
        }
        return errors;
    }
};

TEST_F(AnisotropicEnvironmentTest, isThatOfIntegration) {
    // The means that docs/environment.md states, with a fifth more: one a sky.
    constexpr std::array bounds{0.036, 0.26, 0.28, 0.075, 0.65};
    const std::vector<NamedSky> all = skies(256);
    ASSERT_EQ(all.size(), bounds.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const NamedSky& sky = all[i];
        for (const BrdfModel model : models) {
            const RowErrors errors = errorsUnder(sky, model);
            std::printf("%-12s %-7s", sky.name.c_str(), toString(model));
            for (std::size_t row = 0; row < errors.size(); ++row) {
                std::printf(" | strength %.1f: mean %.3f max %.2f", static_cast<double>(strengths[row]),
                            errors[row].mean(), errors[row].largest);
                EXPECT_GT(errors[row].count, 50);
                EXPECT_LT(errors[row].mean(), bounds[i]) << sky.name << ", strength " << strengths[row];
            }
            std::printf("\n");
        }
    }
}

}  // namespace
}  // namespace candela::test
