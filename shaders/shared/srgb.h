// The sRGB curve, IEC 61966-2-1, read by C++ and GLSL both: code value from linear light and back, both 0 to 1.

SHARED_FUNCTION float srgbEncode(float linear) {
    return linear < 0.0031308f ? linear * 12.92f : 1.055f * pow(linear, 1.0f / 2.4f) - 0.055f;
}

SHARED_FUNCTION float srgbDecode(float encoded) {
    return encoded < 0.04045f ? encoded / 12.92f : pow((encoded + 0.055f) / 1.055f, 2.4f);
}
