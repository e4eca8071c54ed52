#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace candela::test {

/// Pixels to send through a display transform, RGBA: the colours on which the GPU and the CPU are compared.
class Ramps {
  public:
    /// Ramps from 0 to 1 in grey and the six saturated hues, as fine as 8-bit codes.
    Ramps& unitRange() {
        constexpr std::array<std::array<float, 3>, 7> hues{
            {{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
        for (const auto& hue : hues)
            for (int i = 0; i < 256; ++i) add(float(i) / 255.0f, hue);
        return *this;
    }

    /// From 2^-20 to 2^15.5 in quarter stops, grey and tinted.
    Ramps& wideRange() {
        constexpr std::array<std::array<float, 3>, 4> tints{
            {{1, 1, 1}, {1, 0.5f, 0.1f}, {0.05f, 1, 0.3f}, {0.2f, 0.02f, 1}}};
        for (const auto& tint : tints)
            for (int i = -80; i <= 62; ++i) add(std::exp2(float(i) / 4.0f), tint);
        return *this;
    }

    /// Colours outside the working space's gamut: one or more channels below zero, from -2^-10 to -2^10.
    Ramps& negative() {
        constexpr std::array<std::array<float, 3>, 5> tints{
            {{-1, -1, -1}, {-1, 1, 1}, {1, -0.1f, 0.5f}, {0.2f, 1, -0.3f}, {-1, 0, 0}}};
        for (const auto& tint : tints)
            for (int i = -20; i <= 20; ++i) add(std::exp2(float(i) / 2.0f), tint);
        return *this;
    }

    /// NaN, infinities and the ends of the float range, in one channel and in all, beside ordinary ones.
    Ramps& nonFinite() {
        using Limits = std::numeric_limits<float>;
        for (const float value :
             {Limits::quiet_NaN(), -Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
              Limits::max(), Limits::lowest(), Limits::min(), -0.0f}) {
            push(value, value, value);
            push(value, 0.18f, 0.5f);
            push(0.18f, value, 2.0f);
            push(0.5f, 0.18f, value);
        }
        return *this;
    }

    /// Hashed colours, each channel log-uniform over 2^-8 to 2^6: hues that no ramp contains.
    Ramps& scattered(int count) {
        std::uint32_t state = 1;
        const auto next = [&state] {
            state = state * 1664525u + 1013904223u;
            return std::exp2(-8.0f + 14.0f * float(state >> 8) / float(1 << 24));
        };
        for (int i = 0; i < count; ++i) {
            const float red = next(), green = next(), blue = next();
            push(red, green, blue);
        }
        return *this;
    }

    static std::vector<float> all() {
        return Ramps().unitRange().wideRange().negative().nonFinite().scattered(2048).rgba();
    }

    const std::vector<float>& rgba() const { return rgba_; }

  private:
    void add(float scale, const std::array<float, 3>& tint) {
        push(scale * tint[0], scale * tint[1], scale * tint[2]);
    }
    void push(float red, float green, float blue) { rgba_.insert(rgba_.end(), {red, green, blue, 1.0f}); }

    std::vector<float> rgba_;
};

}  // namespace candela::test
