#pragma once

// shaders/lib/brdf.glsl and shaders/lib/lights.glsl over vectors of pixels: the same arithmetic, line by
// line. Included only by tile_kernel_code.h.

#include "render/lighting/tiled/simd.h"
#include "render/lighting/tiled/tile_kernel.h"

namespace candela {
namespace {

enum class Model { course = 0, gltf = 1 };

constexpr float pi = 3.14159265358979f;
constexpr float minAlpha = 1.0e-3f;
constexpr float minNDotV = 1.0e-4f;
constexpr float maxInverseSquare = 1.0e6f;

struct Surface {
    Vec3 position, normal, baseColor;
    Floats metallic, roughness;
};

struct ShadingPoint {
    Vec3 position, normal, toEye;
    Floats nDotV, alpha2, lobe, maskingA, maskingB;
    Vec3 f0, oneMinusF0, diffuse, compensation;
};

inline Floats directionalAlbedo(const TileFrame& frame, Floats nDotV, Floats alpha) {
    const int last = frame.albedoTableSize - 1;
    const Floats x = nDotV * (1.0f + alpha) / (nDotV + alpha) * static_cast<float>(last);
    const Floats y = (alpha - minAlpha) / (1.0f - minAlpha) * static_cast<float>(last);
    Floats albedo;
    for (int lane = 0; lane < laneCount; ++lane) {
        const int column = x[lane] < static_cast<float>(last - 1) ? static_cast<int>(x[lane]) : last - 1;
        const int row = y[lane] < static_cast<float>(last - 1) ? static_cast<int>(y[lane]) : last - 1;
        const float* cell = frame.albedoTable + row * frame.albedoTableSize + column;
        const float* above = cell + frame.albedoTableSize;
        const float shareX = x[lane] - static_cast<float>(column), shareY = y[lane] - static_cast<float>(row);
        const float low = cell[0] + (cell[1] - cell[0]) * shareX,
                    high = above[0] + (above[1] - above[0]) * shareX;
        albedo[lane] = low + (high - low) * shareY;
    }
    return albedo;
}

template <Model model>
inline ShadingPoint shadingPoint(const TileFrame& frame, const Surface& surface) {
    ShadingPoint point;
    point.position = surface.position;
    point.normal = surface.normal;
    const Vec3 way = splat3(frame.eye) - surface.position;
    point.toEye = way * rsqrt(dot(way, way));
    point.nDotV = dot(point.normal, point.toEye);
    const Floats alpha = max(surface.roughness * surface.roughness, splat(minAlpha));
    const Floats nDotV = max(point.nDotV, splat(minNDotV));
    point.alpha2 = alpha * alpha;
    const Floats dielectric = 0.04f * (1.0f - surface.metallic);
    point.f0 = surface.baseColor * surface.metallic + Vec3{dielectric, dielectric, dielectric};
    point.oneMinusF0 = Vec3{1.0f - point.f0.x, 1.0f - point.f0.y, 1.0f - point.f0.z};
    point.diffuse = surface.baseColor * ((1.0f - surface.metallic) * (1.0f / pi));
    if constexpr (model == Model::course) {
        const Floats k = (surface.roughness + 1.0f) * (surface.roughness + 1.0f) * 0.125f;
        point.maskingA = 1.0f - k;
        point.maskingB = k;
        point.lobe = point.alpha2 / (4.0f * pi * (nDotV * (1.0f - k) + k));
        point.compensation = {splat(1.0f), splat(1.0f), splat(1.0f)};
    } else {
        point.maskingA = nDotV;
        point.maskingB = squareRoot(nDotV * nDotV * (1.0f - point.alpha2) + point.alpha2);
        point.lobe = point.alpha2 * (1.0f / (2.0f * pi));
        const Floats albedo = directionalAlbedo(frame, nDotV, alpha);
        const Floats missing = (1.0f - albedo) / albedo;
        point.compensation = {1.0f + point.f0.x * missing, 1.0f + point.f0.y * missing,
                              1.0f + point.f0.z * missing};
    }
    return point;
}

/// f(l, v), to be multiplied by nDotL = max(0, nDotRawL).
template <Model model>
inline Vec3 reflectance(const ShadingPoint& point, Vec3 l, Floats nDotRawL, Floats nDotL) {
    const Vec3 t = l + point.toEye;
    const Floats nDotT = nDotRawL + point.nDotV;
    const Vec3 tangential = t - point.normal * nDotT;
    const Floats tangential2 = dot(tangential, tangential);
    const Floats nDotT2 = nDotT * nDotT;
    const Floats t2 = tangential2 + nDotT2;
    const Floats q = max(tangential2 + point.alpha2 * nDotT2, splat(1.0e-15f));
    Floats masking;
    if constexpr (model == Model::course) {
        masking = nDotL * point.maskingA + point.maskingB;
    } else {
        masking = nDotL * point.maskingB +
                  point.maskingA * squareRoot(nDotL * nDotL * (1.0f - point.alpha2) + point.alpha2);
    }
    const Floats specular = point.lobe * t2 * t2 * reciprocal(q * q * masking);
    const Floats grazing = max(1.0f - 0.5f * squareRoot(max(t2, splat(1.0e-30f))), splat(0.0f));
    const Floats grazing2 = grazing * grazing;
    const Floats grazing5 = grazing2 * grazing2 * grazing;
    const Vec3 fresnel = point.f0 + point.oneMinusF0 * grazing5;
    if constexpr (model == Model::course) {
        // diffuse (1 - F) + F specular, gathered by F.
        const Vec3 lobe{specular - point.diffuse.x, specular - point.diffuse.y, specular - point.diffuse.z};
        return point.diffuse + fresnel * lobe;
    } else {
        const Vec3 lobe = point.compensation * specular;
        return point.diffuse + fresnel * (lobe - point.diffuse);
    }
}

/// Radiance by a light of eight floats (position, 1 / range², intensity, nothing), times the spot factor of
/// `cone` unless that is null.
template <Model model>
inline Vec3 localLight(const ShadingPoint& point, const float* record, const float* cone) {
    const Vec3 d = splat3(record) - point.position;
    const Floats d2 = dot(d, d);
    const Floats relative2 = d2 * record[3];
    const Floats window = max(1.0f - relative2 * relative2, splat(0.0f));
    const Floats inverse = rsqrt(max(d2, splat(1.0e-24f)));
    const Vec3 l = d * inverse;
    const Floats nDotRawL = dot(point.normal, l);
    Floats scale = window * min(inverse * inverse, splat(maxInverseSquare));
    if (cone != nullptr) {
        const Floats ramp = min(max(cone[3] - dot(l, splat3(cone)), splat(0.0f)), splat(1.0f));
        scale = scale * ramp * ramp;
    }
    const Floats nDotL = max(nDotRawL, splat(0.0f));
    return reflectance<model>(point, l, nDotRawL, nDotL) * (splat3(record + 4) * (scale * nDotL));
}

template <Model model>
inline Vec3 directionalLight(const ShadingPoint& point, const float* record) {
    const Vec3 l = splat3(record);
    const Floats nDotRawL = dot(point.normal, l);
    const Floats nDotL = max(nDotRawL, splat(0.0f));
    return reflectance<model>(point, l, nDotRawL, nDotL) * (splat3(record + 4) * nDotL);
}

}  // namespace
}  // namespace candela
