#pragma once

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace candela::test {

inline constexpr int size = 33, middle = size / 2;
/// Half a code of 255, and roundings.
inline constexpr float halfCode = 0.5f / 255.0f + 1.0e-6f;
/// The widest of the codes of roughness is that at 1: four times the step of the fourth root, 2.28e-3.
inline constexpr float halfRoughnessCode = 4.6e-3f;
/// The largest error of a packed normal (packing_test), as the length of a difference of unit vectors.
inline constexpr float normalError = 1.04e-3f;

/// Looks along -Z from 3 m at the square of 2 m around the origin, so that it fills the picture.
inline const CameraView front = lookAt({0, 0, 3}, {0, 0, 0}, 2.0f * std::atan(1.0f / 3.0f));

inline FrameRequest frameOf(const CameraView& view, int width = size, int height = size) {
    return {width, height, view, BrdfModel::course, Technique::fullscreen};
}

inline float srgbDecode(float code) {
    return code < 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

inline float srgbEncode(float linear) {
    return linear < 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Compares colours in codes of the G-buffer.
inline void expectColor(const glm::vec3& actual, const glm::vec3& expected, float codes = 0.51f) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(255.0f * srgbEncode(actual[c]), 255.0f * srgbEncode(expected[c]), codes)
            << "channel " << c;
    }
}

inline void expectNormal(const glm::vec3& actual, const glm::vec3& expected, float tolerance = normalError) {
    EXPECT_LT(glm::distance(actual, glm::normalize(expected)), tolerance)
        << "(" << actual.x << ", " << actual.y << ", " << actual.z << ")";
}

inline Texture nearestOf(std::uint32_t image) {
    Texture texture;
    texture.image = image;
    texture.minFilter = texture.magFilter = Filter::nearest;
    return texture;
}

class GBufferTest : public DrawingTest {
  protected:
    static AovReader surfaces(const Scene& scene, const CameraView& view = front, int width = size,
                              int height = size) {
        GpuScene uploaded = upload(scene);
        render(uploaded, frameOf(view, width, height));
        return aovs(width);
    }
    static bool hasSurface(const AovReader& reader, int x, int y) { return reader.scalar("Z", x, y) > 0.0f; }
};

}  // namespace candela::test
