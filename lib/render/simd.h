#pragma once

// Vectors of floats as wide as the instruction set this file is compiled for, with the names that GLSL has
// for their functions. Included only by kernels, which are compiled once for each instruction set:
// everything here has internal linkage, so that the linker never merges two variants of a function.

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
inline Floats approximateInversesqrt(Floats a) {
    return (Floats)_mm512_rsqrt14_ps((__m512)a);
}
inline Floats approximateReciprocal(Floats a) {
    return (Floats)_mm512_rcp14_ps((__m512)a);
}

#elif defined(__AVX2__)

inline Floats max(Floats a, Floats b) {
    return (Floats)_mm256_max_ps((__m256)a, (__m256)b);
}
inline Floats min(Floats a, Floats b) {
    return (Floats)_mm256_min_ps((__m256)a, (__m256)b);
}
inline Floats approximateInversesqrt(Floats a) {
    return (Floats)_mm256_rsqrt_ps((__m256)a);
}
inline Floats approximateReciprocal(Floats a) {
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

// The hardware's 12 or 14 bits and one step of Newton's method, in the form with the smallest rounding error:
// all but the last bit of a float. For numbers over 1e-30.

inline Floats inversesqrt(Floats a) {
    const Floats r = approximateInversesqrt(a);
    const Floats remainder = 1.0f - (a * r) * r;
    return r + (0.5f * r) * remainder;
}

inline Floats reciprocal(Floats a) {
    const Floats r = approximateReciprocal(a);
    const Floats remainder = 1.0f - a * r;
    return r + r * remainder;
}

#else

inline Floats inversesqrt(Floats a) {
    Floats r;
    for (int lane = 0; lane < laneCount; ++lane) r[lane] = 1.0f / __builtin_sqrtf(a[lane]);
    return r;
}

inline Floats reciprocal(Floats a) {
    return 1.0f / a;
}

#endif

inline Floats max(Floats a, float b) {
    return max(a, splat(b));
}
inline Floats min(Floats a, float b) {
    return min(a, splat(b));
}

/// Of a number over 1e-30.
inline Floats sqrt(Floats a) {
    return a * inversesqrt(a);
}

/// `a` itself: keeps the compiler from fusing the product `a` into a sum that follows.
inline Floats rounded(Floats a) {
#if defined(__AVX2__)
    __asm__("" : "+v"(a));
#endif
    return a;
}

inline Floats abs(Floats a) {
    return max(a, -a);
}

/// Of a normal number over 0; off by less than 1e-6.
inline Floats log2(Floats a) {
    const Ints bits = (Ints)a;
    const Floats exponent = __builtin_convertvector((bits >> 23) - 127, Floats);
    const Floats mantissa = (Floats)((bits & 0x007fffff) | 0x3f800000);
    // ln((1 + t) / (1 - t)) / 2 = t + t³ / 3 + t⁵ / 5 + ...
    const Floats t = (mantissa - 1.0f) / (mantissa + 1.0f), t2 = t * t;
    const Floats series =
        1.0f + t2 * (1.0f / 3.0f + t2 * (1.0f / 5.0f + t2 * (1.0f / 7.0f + t2 * (1.0f / 9.0f))));
    constexpr float twoOverLn2 = 2.88539008f;
    return exponent + twoOverLn2 * t * series;
}

/// For -126 to 126; off by less than 1e-6 of it.
inline Floats exp2(Floats a) {
    const Floats shifted = a + 128.5f;  // Over 0, so that truncation rounds to the nearest.
    const Ints whole = __builtin_convertvector(shifted, Ints) - 128;
    const Floats x = 0.693147181f * (a - __builtin_convertvector(whole, Floats));
    const Floats series =
        1.0f + x * (1.0f + x * (0.5f + x * (1.0f / 6.0f +
                                            x * (1.0f / 24.0f + x * (1.0f / 120.0f + x * (1.0f / 720.0f))))));
    return series * (Floats)((whole + 127) << 23);
}

/// Four lanes: a row of a block, or the channels of a pixel.
typedef float Four __attribute__((vector_size(16)));

inline Four loadFour(const float* from) {
    Four v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

inline void transpose(Four& a, Four& b, Four& c, Four& d) {
    const Four ab0 = __builtin_shufflevector(a, b, 0, 4, 1, 5),
               ab1 = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Four cd0 = __builtin_shufflevector(c, d, 0, 4, 1, 5),
               cd1 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
    c = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
    d = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
}

/// The lanes of `parts`, one after the other. In registers: a vector is not loaded soon after its parts were
/// stored.
inline Floats joined(const Four (&parts)[laneCount / 4]) {
#if defined(__AVX512F__)
    __m512 v = _mm512_castps128_ps512((__m128)parts[0]);
    v = _mm512_insertf32x4(v, (__m128)parts[1], 1);
    v = _mm512_insertf32x4(v, (__m128)parts[2], 2);
    return (Floats)_mm512_insertf32x4(v, (__m128)parts[3], 3);
#elif defined(__AVX2__)
    return (Floats)_mm256_insertf128_ps(_mm256_castps128_ps256((__m128)parts[0]), (__m128)parts[1], 1);
#else
    return parts[0];
#endif
}

inline Four fourOf(Floats v, int first) {
    float lanes[laneCount];
    store(lanes, v);
    Four four;
    __builtin_memcpy(&four, lanes + first, sizeof four);
    return four;
}

/// The minimum of all lanes.
inline float minOfLanes(Floats v) {
#if defined(__AVX512F__)
    return _mm512_reduce_min_ps((__m512)v);
#else
    Four lowest = fourOf(v, 0);
    for (int first = 4; first < laneCount; first += 4) {
        const Four next = fourOf(v, first);
        lowest = lowest < next ? lowest : next;
    }
    const float a = lowest[0] < lowest[1] ? lowest[0] : lowest[1];
    const float b = lowest[2] < lowest[3] ? lowest[2] : lowest[3];
    return a < b ? a : b;
#endif
}

/// A bit for each lane whose mask is set, the first lane lowest.
inline std::uint32_t laneBits(Ints mask) {
#if defined(__AVX512F__)
    return _mm512_movepi32_mask((__m512i)mask);
#elif defined(__AVX2__)
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < laneCount; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
    return bits;
#endif
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

/// table[2 index] and table[2 index + 1] in each lane. The time of a gather depends on the number of its
/// elements, not on their size. Where no lane differs, as in a background, there is none.
inline void lookUpPairs(const float* table, Ints index, Floats& first, Floats& second) {
    if (laneBits(index != index[0]) == 0) {
        first = splat(table[2 * index[0]]);
        second = splat(table[2 * index[0] + 1]);
        return;
    }
#if defined(__AVX512F__)
    const auto pairs = [table](__m256i lanes) {
        return (__m512)_mm512_i32gather_pd(lanes, table, 2 * sizeof(float));
    };
    const __m512 low = pairs(_mm512_castsi512_si256((__m512i)index)),
                 high = pairs(_mm512_extracti64x4_epi64((__m512i)index, 1));
    first = __builtin_shufflevector((Floats)low, (Floats)high, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24,
                                    26, 28, 30);
    second = __builtin_shufflevector((Floats)low, (Floats)high, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25,
                                     27, 29, 31);
#elif defined(__AVX2__)
    const auto pairs = [table](__m128i lanes) {
        return (__m256)_mm256_i32gather_pd(reinterpret_cast<const double*>(table), lanes, 2 * sizeof(float));
    };
    const __m256 low = pairs(_mm256_castsi256_si128((__m256i)index)),
                 high = pairs(_mm256_extracti128_si256((__m256i)index, 1));
    first = __builtin_shufflevector((Floats)low, (Floats)high, 0, 2, 4, 6, 8, 10, 12, 14);
    second = __builtin_shufflevector((Floats)low, (Floats)high, 1, 3, 5, 7, 9, 11, 13, 15);
#else
    for (int lane = 0; lane < laneCount; ++lane) {
        first[lane] = table[2 * index[lane]];
        second[lane] = table[2 * index[lane] + 1];
    }
#endif
}

/// Four numbers at each pointer: the first ones of all lanes, the second ones, ...
inline void loadRecords(const float* const (&from)[laneCount], Floats& a, Floats& b, Floats& c, Floats& d) {
#if defined(__AVX2__)
    // Rows of 128 bits, each with the numbers of the lane that has the same place among four.
    Floats rows[4];
    for (int row = 0; row < 4; ++row) {
#if defined(__AVX512F__)
        __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(from[row]));
        v = _mm512_insertf32x4(v, _mm_loadu_ps(from[row + 4]), 1);
        v = _mm512_insertf32x4(v, _mm_loadu_ps(from[row + 8]), 2);
        rows[row] = (Floats)_mm512_insertf32x4(v, _mm_loadu_ps(from[row + 12]), 3);
#else
        const __m256 low = _mm256_castps128_ps256(_mm_loadu_ps(from[row]));
        rows[row] = (Floats)_mm256_insertf128_ps(low, _mm_loadu_ps(from[row + 4]), 1);
#endif
    }
    const auto pairs = [](Floats u, Floats v, Floats& low, Floats& high) {
#if defined(__AVX512F__)
        low = (Floats)_mm512_unpacklo_ps((__m512)u, (__m512)v);
        high = (Floats)_mm512_unpackhi_ps((__m512)u, (__m512)v);
#else
        low = (Floats)_mm256_unpacklo_ps((__m256)u, (__m256)v);
        high = (Floats)_mm256_unpackhi_ps((__m256)u, (__m256)v);
#endif
    };
    Floats ac, bd, acHigh, bdHigh;
    pairs(rows[0], rows[2], ac, acHigh);
    pairs(rows[1], rows[3], bd, bdHigh);
    pairs(ac, bd, a, b);
    pairs(acHigh, bdHigh, c, d);
#else
    a = loadFour(from[0]);
    b = loadFour(from[1]);
    c = loadFour(from[2]);
    d = loadFour(from[3]);
    transpose(a, b, c, d);
#endif
}

struct Vec3 {
    Floats x, y, z;

    Vec3() = default;
    Vec3(Floats first, Floats second, Floats third) : x(first), y(second), z(third) {}
    explicit Vec3(Floats all) : x(all), y(all), z(all) {}
    explicit Vec3(float all) : Vec3(splat(all)) {}
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
/// Three numbers, the same in all lanes.
inline Vec3 splat3(const float* v) {
    return {splat(v[0]), splat(v[1]), splat(v[2])};
}

}  // namespace
}  // namespace candela
