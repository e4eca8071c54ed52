#pragma once

#include "shading/directional_albedo.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <span>

// The merged form of shaders/shared/shading.h and extended_lobes.h, over float and double.

namespace candela {
namespace {

/// The table of lib/shading/directional_albedo.h at x and y.
template <typename Texel, typename Real>
Texel texelOf(std::span<const float> table, Real x, Real y) {
    constexpr int last = albedoTableSize - 1;
    const int i = std::min(int(x * last), last - 1), j = std::min(int(y * last), last - 1);
    const auto channel = [&](int c) {
        const auto row = [&](int of) {
            const float* texel = table.data() + 2 * (of * albedoTableSize + i) + c;
            return glm::mix(Real(texel[0]), Real(texel[2]), x * last - Real(i));
        };
        return glm::mix(row(j), row(j + 1), y * last - Real(j));
    };
    return {channel(0), channel(1)};
}

#define SHARED_FUNCTION inline
#define precise

/// shaders/shared/shading.h over double.
namespace exact {

using Real = double;
using Real3 = glm::dvec3;
using Scalar = double;
using AlbedoTable = std::span<const float>;
inline Real max(Real a, Real b) {
    return std::max(a, b);
}
inline Real min(Real a, Real b) {
    return std::min(a, b);
}
inline Real sqrt(Real a) {
    return std::sqrt(a);
}
inline Real inversesqrt(Real a) {
    return 1.0 / std::sqrt(a);
}
inline Real fastDivide(Real a, Real b) {
    return a / b;
}
inline Real exp2(Real a) {
    return std::exp2(a);
}
inline Real log2(Real a) {
    return std::log2(a);
}
inline bool anyAbove(Real a) {
    return a > 0;
}
inline Real whereAbove(Real x, Real a, Real b) {
    return x > 0 ? a : b;
}
#include "shared/shading_constants.h"
#include "shared/surface_lobes.h"

#include "shared/shading.h"

#include "shared/extended_lobes.h"

inline AlbedoTexel readAlbedoTable(AlbedoTable table, Real x, Real y) {
    return texelOf<AlbedoTexel, Real>(table, x, y);
}

}  // namespace exact

/// The same over float, as shaders have it.
namespace single {

using Real = float;
using Real3 = glm::vec3;
using Scalar = float;
using AlbedoTable = std::span<const float>;
inline Real max(Real a, Real b) {
    return std::max(a, b);
}
inline Real min(Real a, Real b) {
    return std::min(a, b);
}
inline Real sqrt(Real a) {
    return std::sqrt(a);
}
inline Real inversesqrt(Real a) {
    return 1.0f / std::sqrt(a);
}
inline Real fastDivide(Real a, Real b) {
    return a / b;
}
inline Real exp2(Real a) {
    return std::exp2(a);
}
inline Real log2(Real a) {
    return std::log2(a);
}
inline bool anyAbove(Real a) {
    return a > 0;
}
inline Real whereAbove(Real x, Real a, Real b) {
    return x > 0 ? a : b;
}
#include "shared/shading_constants.h"
#include "shared/surface_lobes.h"

#include "shared/shading.h"

#include "shared/extended_lobes.h"

inline AlbedoTexel readAlbedoTable(AlbedoTable table, Real x, Real y) {
    return texelOf<AlbedoTexel, Real>(table, x, y);
}

}  // namespace single

#undef SHARED_FUNCTION
#undef precise

}  // namespace
}  // namespace candela
