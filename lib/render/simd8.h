#pragma once

// Vectors of eight floats for every instruction set, beside those of its own width in simd.h. Included only
// by kernels, as that file is.

#include "render/simd.h"

namespace candela {
namespace {

typedef float Eight __attribute__((vector_size(32)));
typedef std::int32_t EightInts __attribute__((vector_size(32)));

inline Eight load8(const float* from) {
    Eight v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline void store8(float* to, Eight v) {
    __builtin_memcpy(to, &v, sizeof v);
}
inline Eight splat8(float value) {
    return value - Eight{};
}

#if defined(__AVX2__)
inline Eight min8(Eight a, Eight b) {
    return (Eight)_mm256_min_ps((__m256)a, (__m256)b);
}
inline Eight max8(Eight a, Eight b) {
    return (Eight)_mm256_max_ps((__m256)a, (__m256)b);
}
inline std::uint32_t bitsOf(EightInts mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
}
#else
inline Eight min8(Eight a, Eight b) {
    return a < b ? a : b;
}
inline Eight max8(Eight a, Eight b) {
    return a > b ? a : b;
}
inline std::uint32_t bitsOf(EightInts mask) {
    std::uint32_t bits = 0;
    for (int lane = 0; lane < 8; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
    return bits;
}
#endif

inline Eight abs8(Eight a) {
    return max8(a, -a);
}

struct Eight3 {
    Eight x, y, z;
};

inline Eight3 operator-(Eight3 a, Eight3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Eight3 operator+(Eight3 a, Eight3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Eight3 operator*(Eight3 a, Eight b) {
    return {a.x * b, a.y * b, a.z * b};
}
inline Eight dot8(Eight3 a, Eight3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Eight3 cross8(Eight3 a, Eight3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Eight3 splat83(const float* v) {
    return {splat8(v[0]), splat8(v[1]), splat8(v[2])};
}

}  // namespace
}  // namespace candela
