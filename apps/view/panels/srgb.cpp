#include "panels/srgb.h"

#include <algorithm>
#include <cmath>

namespace {

float encoded(float linear) {
    const float value = std::clamp(linear, 0.0f, 1.0f);
    return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
}

float decoded(float code) {
    return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

glm::vec3 srgbFromLinear(const glm::vec3& linear) {
    return {encoded(linear.r), encoded(linear.g), encoded(linear.b)};
}

glm::vec3 linearFromSrgb(const glm::vec3& codes) {
    return {decoded(codes.r), decoded(codes.g), decoded(codes.b)};
}
