#pragma once

#include <cmath>

namespace candela {

/// The sRGB curve: code value from linear light, both 0 to 1. Source: IEC 61966-2-1.
inline float srgbEncode(float linear) {
    return linear < 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Linear light from code value.
inline float srgbDecode(float encoded) {
    return encoded < 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace candela
