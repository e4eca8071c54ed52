#pragma once

#include "support/drawing_test.h"
#include "support/procedural_scene.h"
#include "support/shadow_reference.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace candela::test {

class ShadowTest : public DrawingTest {
  protected:
    static constexpr int width = 96, height = 54;

    void SetUp() override {
        if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    }

    struct Tally {
        int lit = 0, blocked = 0, grazing = 0;
    };

    static HdrImage drawnWith(GpuScene& uploaded, const CameraView& view, Shadows shadows) {
        FrameRequest request{width, height, view};
        request.shadows = shadows;
        return drawn(uploaded, request);
    }

    /// Draws each light alone, with and without shadows, and compares every pixel that it lights without with
    /// the visibility of the light past all triangles.
    static Tally compare(const Scene& scene, const std::vector<Triangle>& triangles,
                         const std::vector<WorldLight>& lights, const CameraView& view) {
        GpuScene uploaded(context(), scene);
        return compare(uploaded, triangles, lights, view);
    }

    static Tally compare(GpuScene& uploaded, const std::vector<Triangle>& triangles,
                         const std::vector<WorldLight>& lights, const CameraView& view) {
        Tally tally;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            uploaded.setLights(std::span(lights).subspan(i, 1));
            const HdrImage without = drawnWith(uploaded, view, Shadows::off);
            const HdrImage with = drawnWith(uploaded, view, Shadows::on);
            const AovReader aovs(lastFrame().aovs({"P", "N"}), width);
            compareLight(lights[i], triangles, view, {without, with, aovs}, tally);
            if (HasFailure()) {
                ADD_FAILURE() << "light " << i;
                break;
            }
        }
        return tally;
    }

  private:
    struct Pictures {
        const HdrImage &without, &with;
        const AovReader& aovs;
    };

    static void compareLight(const WorldLight& light, const std::vector<Triangle>& triangles,
                             const CameraView& view, const Pictures& pictures, Tally& tally) {
        const glm::dvec3 eye(view.worldFromCamera[3]);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const glm::vec3 full = pixelOf(pictures.without, x, y), own = pixelOf(pictures.with, x, y);
                if (full == glm::vec3(0.0f)) {
                    ASSERT_EQ(own, full);
                    continue;
                }
                const glm::dvec3 position(pictures.aovs.vector("P", x, y));
                const glm::dvec3 from = light.type == LightType::directional
                                            ? position - 1000.0 * glm::dvec3(light.direction)
                                            : glm::dvec3(light.position);
                const Visibility expected =
                    visibilityOf(triangles, {from, position, eye, marginAt(position, view, height)});
                const bool isLit = own != glm::vec3(0.0f);
                if (isLit) {
                    ASSERT_EQ(own, full) << x << ", " << y;
                }
                tally.lit += isLit;
                tally.blocked += !isLit;
                tally.grazing += expected == Visibility::grazing;
                if (expected == Visibility::grazing) continue;
                ASSERT_EQ(isLit, expected == Visibility::clear)
                    << "pixel " << x << ", " << y << " at " << position.x << ", " << position.y << ", "
                    << position.z;
            }
        }
    }
};

inline Material grey() {
    Material material;
    material.baseColor = {0.5f, 0.5f, 0.5f, 1.0f};
    return material;
}

inline glm::mat4 at(const glm::vec3& position, float scale = 1.0f) {
    return glm::scale(glm::translate(glm::mat4(1.0f), position), glm::vec3(scale));
}

/// An axis-aligned box of flat faces.
inline Mesh makeBox(const glm::vec3& half) {
    Mesh box;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(box.positions.size());
            glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1.0f;
            for (const auto& [a, b] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
                box.positions.push_back(half * (normal + a * u + b * v));
                box.normals.push_back(normal);
            }
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) box.indices.push_back(first + i);
        }
    }
    return box;
}

/// A floor, boxes and rotated boxes on and above it.
inline Scene boxesOnAFloor() {
    Scene scene = sceneOf(makeBox({8.0f, 0.1f, 8.0f}), grey(), at({0, -0.1f, 0}));
    for (std::uint32_t i = 0; i < 14; ++i) {
        const glm::vec3 place(6.0f * hashed(1, i) - 3.0f, 0.2f + 1.2f * hashed(2, i),
                              6.0f * hashed(3, i) - 3.0f);
        const glm::vec3 half(0.1f + 0.4f * hashed(4, i), 0.1f + 0.3f * hashed(5, i),
                             0.05f + 0.3f * hashed(6, i));
        candela::test::place(scene, makeBox(half), grey(),
                             glm::rotate(at(place), 6.0f * hashed(7, i), hashedDirection(8, i)));
    }
    return scene;
}

inline std::vector<WorldLight> scatteredLights(std::uint32_t count, std::uint32_t seed) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 position(8.0f * hashed(seed, i) - 4.0f, 0.1f + 3.0f * hashed(seed + 1, i),
                                 8.0f * hashed(seed + 2, i) - 4.0f);
        lights.push_back(pointLight(position, 20.0f, glm::vec3(10.0f)));
    }
    return lights;
}

}  // namespace candela::test
