#pragma once

// Radiance to code values on the CPU: exposure, the steps of a display transform and the dither of
// shaders/display.frag. Each render/kernels_*.cpp includes this once, with CANDELA_DISPLAY_KERNEL naming the
// table it defines; see render/lighting/tiled/tile_kernel_code.h.

#include "render/display/display_kernel.h"

#include "color/curve_segments.h"
#include "render/simd.h"

namespace candela {
namespace {

typedef std::uint32_t Words __attribute__((vector_size(4 * laneCount)));

/// Colours that pass through all steps together.
constexpr int displayRun = 256;

struct alignas(64) DisplayColors {
    float red[displayRun], green[displayRun], blue[displayRun];

    Vec3 lanes(int first) const { return {load(red + first), load(green + first), load(blue + first)}; }
    void set(int first, Vec3 color) {
        store(red + first, color.x), store(green + first, color.y), store(blue + first, color.z);
    }
};

/// NaN becomes 0: see color/display_transform.h.
inline Floats clampFinite(Floats value, float low, float high) {
    const Ints isNumber = value == value;
    return select(isNumber, min(max(value, low), high), Floats{});
}

inline void loadColors(const float* rgba, int count, float scale, DisplayColors& colors) {
    int i = 0;
    for (; i + 4 <= count; i += 4) {
        Four a = loadFour(rgba + 4 * i), b = loadFour(rgba + 4 * i + 4), c = loadFour(rgba + 4 * i + 8),
             d = loadFour(rgba + 4 * i + 12);
        transpose(a, b, c, d);
        __builtin_memcpy(colors.red + i, &a, sizeof a);
        __builtin_memcpy(colors.green + i, &b, sizeof b);
        __builtin_memcpy(colors.blue + i, &c, sizeof c);
    }
    for (; i < count; ++i)
        colors.red[i] = rgba[4 * i], colors.green[i] = rgba[4 * i + 1], colors.blue[i] = rgba[4 * i + 2];
    constexpr float maxRadiance = 65504.0f;
    for (i = 0; i < count; i += laneCount) {
        const Vec3 color = colors.lanes(i) * splat(scale);
        colors.set(i, {clampFinite(color.x, -maxRadiance, maxRadiance),
                       clampFinite(color.y, -maxRadiance, maxRadiance),
                       clampFinite(color.z, -maxRadiance, maxRadiance)});
    }
}

// ---- Steps

/// As `CurveTable::at`.
inline Floats curveAt(const float* segments, Floats x) {
    Ints bits = (Ints)(x + curveStart);
    bits = bits < curveStartBits ? Ints{} + curveStartBits : bits;
    bits = bits > curveLastBits ? Ints{} + curveLastBits : bits;
    Floats value, slope;
    lookUpPairs(segments, (bits - curveStartBits) >> curveSegmentBits, value, slope);
    return value + __builtin_convertvector(bits & curveSegmentMask, Floats) * slope;
}

inline Vec3 applyMatrix(const DisplayStep& step, Vec3 color) {
    const auto row = [&](const float* m) { return m[0] * color.x + m[1] * color.y + m[2] * color.z + m[3]; };
    return {row(step.matrix[0]), row(step.matrix[1]), row(step.matrix[2])};
}

inline Vec3 applyCurves(const DisplayStep& step, Vec3 color) {
    return {curveAt(step.curves[0], color.x), curveAt(step.curves[1], color.y),
            curveAt(step.curves[2], color.z)};
}

/// As `candelaGlowAndRed` of color/aces_steps.cpp, which says where it comes from.
inline Vec3 glowAndRed(Vec3 ap0) {
    const Floats r = ap0.x, g = ap0.y, b = ap0.z;
    const Vec3 apart{g - r, b - g, r - b};
    const Floats chroma = sqrt(max(0.5f * dot(apart, apart), 1.0e-30f));
    const Floats maximum = max(r, max(g, b));
    const Floats range = max(maximum, 1e-10f) - max(min(r, min(g, b)), 1e-10f);

    const Floats x = 5.0f * (range / max(maximum, 1e-2f)) - 2.0f;
    const Floats t = max(1.0f - 0.5f * abs(x), 0.0f);
    const Floats shape = select(x < 0.0f, 0.5f * t * t, 1.0f - 0.5f * t * t);
    const Floats brightness = (r + g + b + 1.75f * chroma) * (1.0f / 3.0f);
    const Floats glow = 1.0f + 0.05f * shape * max(0.08f / max(brightness, 0.16f / 3.0f) - 0.5f, 0.0f);

    constexpr float widest = 0.66817864f;
    const Floats across = 2.0f * r - g - b;
    const Floats side = 1.7320508f * (g - b);
    const Floats h = select(across > 0.0f, min(abs(side) / (across + 2.0f * chroma), widest), splat(widest));
    const Floats u = h * h;
    const Floats hue = h * (3.3952436f + u * (-1.1272871f + u * (0.62583859f + u * -0.26444672f)));
    const Floats outer = max(2.0f - hue, 0.0f), inner = max(1.0f - hue, 0.0f);
    const Floats weight = 0.25f * outer * outer * outer - inner * inner * inner;

    const Vec3 glowing = ap0 * glow;
    const Floats saturation = glow * range / max(maximum * glow, 1e-2f);
    return {glowing.x + 0.18f * weight * saturation * (0.03f - glowing.x), glowing.y, glowing.z};
}

/// As `candelaDarkToDim` there.
inline Vec3 darkToDim(const DisplayStep& step, Vec3 ap1) {
    return ap1 * curveAt(step.curves[0], 0.27222872f * ap1.x + 0.67408177f * ap1.y + 0.05368952f * ap1.z);
}

template <typename Function>
inline void forColors(DisplayColors& colors, int count, const Function& function) {
    for (int i = 0; i < count; i += laneCount) colors.set(i, function(colors.lanes(i)));
}

inline void applyStep(const DisplayStep& step, DisplayColors& colors, int count) {
    switch (step.kind) {
        case DisplayStep::Kind::matrix:
            return forColors(colors, count, [&](Vec3 color) { return applyMatrix(step, color); });
        case DisplayStep::Kind::clamp:
            return forColors(colors, count, [&](Vec3 color) {
                return Vec3{min(max(color.x, step.low), step.high), min(max(color.y, step.low), step.high),
                            min(max(color.z, step.low), step.high)};
            });
        case DisplayStep::Kind::curves:
            return forColors(colors, count, [&](Vec3 color) { return applyCurves(step, color); });
        case DisplayStep::Kind::glowAndRed:
            return forColors(colors, count, [&](Vec3 color) { return glowAndRed(color); });
        case DisplayStep::Kind::darkToDim:
            return forColors(colors, count, [&](Vec3 color) { return darkToDim(step, color); });
        case DisplayStep::Kind::other:
            step.apply(step.processor, colors.red, colors.green, colors.blue,
                       static_cast<std::size_t>(count));
    }
}

// ---- Codes

/// As `pixelNoise` of display.frag.
inline Floats pixelNoise(Words x, std::uint32_t y) {
    Words h = x * 1664525u + (y * 1664525u + 1013904223u) * 747796405u;
    h = (h ^ h >> 16) * 2246822519u;
    h = (h ^ h >> 13) * 3266489917u;
    return __builtin_convertvector((Ints)((h ^ h >> 16) >> 8), Floats) * (1.0f / 16777216.0f);
}

inline Words codeOf(Floats value, Floats dither) {
    const Floats code = clampFinite(clampFinite(value, 0.0f, 1.0f) + dither, 0.0f, 1.0f);
    return (Words) __builtin_convertvector(code * 255.0f + 0.5f, Ints);
}

inline void storeCodes(const DisplayColors& colors, std::uint32_t left, std::uint32_t y, int count,
                       std::uint32_t* codes) {
    std::uint32_t run[displayRun];
    Words x;
    for (int lane = 0; lane < laneCount; ++lane) x[lane] = left + static_cast<std::uint32_t>(lane);
    for (int i = 0; i < count; i += laneCount, x += laneCount) {
        const Floats noise = pixelNoise(x, y) - 0.5f;
        const Floats dither = min(max(noise, -7.0f / 16.0f), 7.0f / 16.0f) * (1.0f / 255.0f);
        const Vec3 color = colors.lanes(i);
        const Words packed = codeOf(color.x, dither) | codeOf(color.y, dither) << 8 |
                             codeOf(color.z, dither) << 16 | 0xff000000u;
        __builtin_memcpy(run + i, &packed, sizeof packed);
    }
    __builtin_memcpy(codes, run, static_cast<std::size_t>(count) * sizeof *codes);
}

void display(const DisplayJob& job, int first, int end) {
    DisplayColors colors = {};
    for (int y = first; y < end; ++y) {
        const float* row = job.radiance + 4 * static_cast<std::int64_t>(y) * job.width;
        std::uint32_t* codes = job.codes + y * job.rowStep;
        for (int x = 0; x < job.width; x += displayRun) {
            const int count = job.width - x < displayRun ? job.width - x : displayRun;
            loadColors(row + 4 * static_cast<std::int64_t>(x), count, job.scale, colors);
            for (std::size_t i = 0; i < job.stepCount; ++i) applyStep(job.steps[i], colors, count);
            storeCodes(colors, job.left + static_cast<std::uint32_t>(x),
                       job.bottom + static_cast<std::uint32_t>(y), count, codes + x);
        }
    }
}

}  // namespace

extern const DisplayKernel CANDELA_DISPLAY_KERNEL;
const DisplayKernel CANDELA_DISPLAY_KERNEL{CANDELA_KERNEL_NAME, display};

}  // namespace candela
