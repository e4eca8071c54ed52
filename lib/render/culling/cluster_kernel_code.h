#pragma once

// The kernel that computes the bounds of clusters, included by that of the triangle filter.

#include "render/culling/triangle_filter_kernel.h"

#include "render/simd.h"

namespace candela {
namespace {

namespace clusters {

constexpr int doubleCount = laneCount / 2, size = layout::CLUSTER_TRIANGLES;
constexpr double maxDouble = 1.7976931348623157e308;

// In double precision, where neither products nor differences of positions lose what the tests rely on.
typedef double Doubles __attribute__((vector_size(8 * doubleCount)));
typedef std::int64_t Longs __attribute__((vector_size(8 * doubleCount)));

struct Vector {
    Doubles x, y, z;
};

inline Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Doubles dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Doubles smaller(Doubles a, Doubles b) {
    return a < b ? a : b;
}
inline Doubles larger(Doubles a, Doubles b) {
    return a > b ? a : b;
}
inline Doubles squareRoot(Doubles a) {
#if defined(__AVX512F__)
    return (Doubles)_mm512_sqrt_pd((__m512d)a);
#elif defined(__AVX2__)
    return (Doubles)_mm256_sqrt_pd((__m256d)a);
#else
    for (int lane = 0; lane < doubleCount; ++lane) a[lane] = __builtin_sqrt(a[lane]);
    return a;
#endif
}

/// The corners of the triangles of a cluster, or their normals.
struct Vectors {
    alignas(64) double x[size], y[size], z[size];

    Vector at(int first) const { return {from(x + first), from(y + first), from(z + first)}; }
    void set(int first, const Vector& vector) {
        __builtin_memcpy(x + first, &vector.x, sizeof vector.x);
        __builtin_memcpy(y + first, &vector.y, sizeof vector.y);
        __builtin_memcpy(z + first, &vector.z, sizeof vector.z);
    }

  private:
    static Doubles from(const double* numbers) {
        Doubles vector;
        __builtin_memcpy(&vector, numbers, sizeof vector);
        return vector;
    }
};

/// A cluster: `count` triangles, and behind them copies of the first corner up to a whole vector of
/// triangles, which add nothing to its bounds.
struct Triangles {
    Vectors corners[3];
    int count = 0, padded = 0;
};

inline void gather(const BoundClusters& job, const std::uint32_t* indices, int count, Triangles& triangles) {
    triangles.count = count;
    triangles.padded = (count + doubleCount - 1) / doubleCount * doubleCount;
    for (int i = 0; i < triangles.padded; ++i) {
        for (int k = 0; k < 3; ++k) {
            const float* from = job.positions + 3 * std::size_t{indices[i < count ? 3 * i + k : 0]};
            triangles.corners[k].x[i] = double{from[0]};
            triangles.corners[k].y[i] = double{from[1]};
            triangles.corners[k].z[i] = double{from[2]};
        }
    }
}

/// The smallest sphere around the middle of the points' box.
inline void boundPoints(const Triangles& triangles, layout::TriangleCluster& cluster) {
    Vector low = triangles.corners[0].at(0), high = low;
    for (const Vectors& corners : triangles.corners) {
        for (int i = 0; i < triangles.padded; i += doubleCount) {
            const Vector point = corners.at(i);
            low = {smaller(low.x, point.x), smaller(low.y, point.y), smaller(low.z, point.z)};
            high = {larger(high.x, point.x), larger(high.y, point.y), larger(high.z, point.z)};
        }
    }
    const auto middle = [](Doubles lowest, Doubles highest) {
        double from = lowest[0], to = highest[0];
        for (int lane = 1; lane < doubleCount; ++lane) {
            from = lowest[lane] < from ? lowest[lane] : from;
            to = highest[lane] > to ? highest[lane] : to;
        }
        return static_cast<float>(from + 0.5 * (to - from));
    };
    cluster.center[0] = middle(low.x, high.x);
    cluster.center[1] = middle(low.y, high.y);
    cluster.center[2] = middle(low.z, high.z);
    const Vector center{double{cluster.center[0]} - Doubles{}, double{cluster.center[1]} - Doubles{},
                        double{cluster.center[2]} - Doubles{}};
    Doubles farthest2{};
    for (const Vectors& corners : triangles.corners) {
        for (int i = 0; i < triangles.padded; i += doubleCount) {
            const Vector way = corners.at(i) - center;
            farthest2 = larger(farthest2, dot(way, way));
        }
    }
    double radius2 = 0.0;
    for (int lane = 0; lane < doubleCount; ++lane)
        radius2 = farthest2[lane] > radius2 ? farthest2[lane] : radius2;
    // A little more, for what the tests round.
    cluster.radius = static_cast<float>(__builtin_sqrt(radius2) * 1.0001);
}

/// The normals of triangles, or zero where two corners are one: such a triangle covers nothing, however it is
/// rounded. `altitude` becomes the least of it and theirs.
inline Vector normalsAt(const Triangles& triangles, int first, Doubles& altitude) {
    const Vector a = triangles.corners[0].at(first), b = triangles.corners[1].at(first),
                 c = triangles.corners[2].at(first);
    const Vector ab = b - a, ac = c - a, bc = c - b;
    const Doubles ab2 = dot(ab, ab), ac2 = dot(ac, ac), bc2 = dot(bc, bc);
    const Longs covers = smaller(ab2, smaller(ac2, bc2)) > 0.0;
    const Vector doubled = cross(ab, ac);
    const Doubles area = squareRoot(dot(doubled, doubled));
    const Doubles own = area / squareRoot(larger(ab2, larger(ac2, bc2)));
    altitude = smaller(altitude, covers ? own : maxDouble - Doubles{});
    // Of a triangle without an area, any direction.
    const Longs isFlat = covers & ~(area > 0.0);
    const Doubles scale = covers & (area > 0.0) ? 1.0 / area : Doubles{};
    return {doubled.x * scale, doubled.y * scale, isFlat ? 1.0 - Doubles{} : doubled.z * scale};
}

inline double sumOf(Doubles vector) {
    double sum = 0.0;
    for (int lane = 0; lane < doubleCount; ++lane) sum += vector[lane];
    return sum;
}
inline double leastOf(Doubles vector) {
    double number = vector[0];
    for (int lane = 1; lane < doubleCount; ++lane) number = vector[lane] < number ? vector[lane] : number;
    return number;
}

inline void boundNormals(const Triangles& triangles, layout::TriangleCluster& cluster) {
    Vectors normals;
    Vector sum{};
    Doubles altitude = maxDouble - Doubles{};
    for (int i = 0; i < triangles.padded; i += doubleCount) {
        const Vector normal = normalsAt(triangles, i, altitude);
        normals.set(i, normal);
        sum = {sum.x + normal.x, sum.y + normal.y, sum.z + normal.z};
    }
    const double x = sumOf(sum.x), y = sumOf(sum.y), z = sumOf(sum.z);
    const double length = __builtin_sqrt(x * x + y * y + z * z);
    if (length == 0.0) return;
    cluster.axis[0] = static_cast<float>(x / length);
    cluster.axis[1] = static_cast<float>(y / length);
    cluster.axis[2] = static_cast<float>(z / length);
    const Vector axis{double{cluster.axis[0]} - Doubles{}, double{cluster.axis[1]} - Doubles{},
                      double{cluster.axis[2]} - Doubles{}};
    Doubles cosine = 1.0 - Doubles{};
    for (int i = 0; i < triangles.padded; i += doubleCount) {
        const Vector normal = normals.at(i);
        const Longs covers = dot(normal, normal) > 0.0;
        cosine = smaller(cosine, covers ? dot(normal, axis) : 1.0 - Doubles{});
    }
    // A little less, for what the axis and the tests round.
    const auto narrowest = static_cast<float>(leastOf(cosine) - 1.0e-5);
    cluster.cosine = narrowest > 0.0f ? narrowest : 0.0f;
    cluster.altitude = static_cast<float>(0.9999 * leastOf(altitude));
}

}  // namespace clusters

void boundClusters(const BoundClusters& job) {
    clusters::Triangles triangles;
    layout::TriangleCluster* cluster = job.clusters;
    for (std::uint32_t first = 0; first < job.count; first += clusters::size, ++cluster) {
        const std::uint32_t left = job.count - first;
        const int count = left < clusters::size ? static_cast<int>(left) : clusters::size;
        clusters::gather(job, job.indices + 3 * std::size_t{first}, count, triangles);
        *cluster = {};
        clusters::boundPoints(triangles, *cluster);
        clusters::boundNormals(triangles, *cluster);
    }
}

}  // namespace
}  // namespace candela
