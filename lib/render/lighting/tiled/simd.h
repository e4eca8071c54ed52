#pragma once

// Vectors of floats as wide as the instruction set this file is compiled for. Included only by
// tile_kernel_code.h, which is compiled once for each instruction set: everything here has internal linkage,
// so that no two variants of a function can meet in the linker.

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace candela {
namespace {

#if defined(__AVX512F__)
constexpr int laneCount = 16;
#elif defined(__AVX2__)
constexpr int laneCount = 8;
#else
constexpr int laneCount = 4;
#endif

typedef float Floats __attribute__((vector_size(4 * laneCount)));
typedef std::int32_t Ints __attribute__((vector_size(4 * laneCount)));

inline Floats load(const float* from) {
    Floats v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

inline void store(float* to, Floats v) {
    __builtin_memcpy(to, &v, sizeof v);
}

inline Floats splat(float value) {
    return value - Floats{};
}

inline Floats select(Ints mask, Floats a, Floats b) {
    return mask ? a : b;
}

#if defined(__AVX512F__)

inline Floats max(Floats a, Floats b) {
    return (Floats)_mm512_max_ps((__m512)a, (__m512)b);
}
inline Floats min(Floats a, Floats b) {
    return (Floats)_mm512_min_ps((__m512)a, (__m512)b);
}
inline Floats roughRsqrt(Floats a) {
    return (Floats)_mm512_rsqrt14_ps((__m512)a);
}
inline Floats roughReciprocal(Floats a) {
    return (Floats)_mm512_rcp14_ps((__m512)a);
}

#elif defined(__AVX2__)

inline Floats max(Floats a, Floats b) {
    return (Floats)_mm256_max_ps((__m256)a, (__m256)b);
}
inline Floats min(Floats a, Floats b) {
    return (Floats)_mm256_min_ps((__m256)a, (__m256)b);
}
inline Floats roughRsqrt(Floats a) {
    return (Floats)_mm256_rsqrt_ps((__m256)a);
}
inline Floats roughReciprocal(Floats a) {
    return (Floats)_mm256_rcp_ps((__m256)a);
}

#else

inline Floats max(Floats a, Floats b) {
    return a > b ? a : b;
}
inline Floats min(Floats a, Floats b) {
    return a < b ? a : b;
}

#endif

#if defined(__AVX2__)

// The hardware's 12 or 14 bits, and one step of Newton's method in the form that rounds least: all but the
// last bit of a float. For numbers over 1e-30.

inline Floats rsqrt(Floats a) {
    const Floats r = roughRsqrt(a);
    const Floats remainder = 1.0f - (a * r) * r;
    return r + (0.5f * r) * remainder;
}

inline Floats reciprocal(Floats a) {
    const Floats r = roughReciprocal(a);
    const Floats remainder = 1.0f - a * r;
    return r + r * remainder;
}

#else

inline Floats rsqrt(Floats a) {
    Floats r;
    for (int lane = 0; lane < laneCount; ++lane) r[lane] = 1.0f / __builtin_sqrtf(a[lane]);
    return r;
}

inline Floats reciprocal(Floats a) {
    return 1.0f / a;
}

#endif

/// The square root of a number that is over 1e-30.
inline Floats squareRoot(Floats a) {
    return a * rsqrt(a);
}

/// The value as it is: keeps the compiler from fusing the product `a` into a sum that follows.
inline Floats rounded(Floats a) {
#if defined(__AVX2__)
    __asm__("" : "+v"(a));
#endif
    return a;
}

inline Floats absolute(Floats a) {
    return max(a, -a);
}

/// Four lanes: a row of a block, or the channels of a pixel.
typedef float Four __attribute__((vector_size(16)));

inline Four fourOf(Floats v, int first) {
    float lanes[laneCount];
    store(lanes, v);
    Four four;
    __builtin_memcpy(&four, lanes + first, sizeof four);
    return four;
}

/// The least of all lanes.
inline float lowest(Floats v) {
    Four least = fourOf(v, 0);
    for (int first = 4; first < laneCount; first += 4) {
        const Four next = fourOf(v, first);
        least = least < next ? least : next;
    }
    const float a = least[0] < least[1] ? least[0] : least[1], b = least[2] < least[3] ? least[2] : least[3];
    return a < b ? a : b;
}

/// table[index] in each lane.
inline Floats lookUp(const float* table, Ints index) {
#if defined(__AVX512F__)
    return (Floats)_mm512_i32gather_ps((__m512i)index, table, 4);
#elif defined(__AVX2__)
    return (Floats)_mm256_i32gather_ps(table, (__m256i)index, 4);
#else
    Floats values;
    for (int lane = 0; lane < laneCount; ++lane) values[lane] = table[index[lane]];
    return values;
#endif
}

struct Vec3 {
    Floats x, y, z;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec3 operator*(Vec3 a, Floats b) {
    return {a.x * b, a.y * b, a.z * b};
}
inline Floats dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 splat3(const float* v) {
    return {splat(v[0]), splat(v[1]), splat(v[2])};
}

}  // namespace
}  // namespace candela
