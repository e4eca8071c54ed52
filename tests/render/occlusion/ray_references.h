#pragma once

#include "occlusion/occlusion_scenes.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace candela::test {

struct WorldTriangle {
    glm::dvec3 corner[3];
};

inline std::vector<WorldTriangle> worldTriangles(const TestScene& scene) {
    std::vector<WorldTriangle> triangles;
    for (const OcclusionInstance& instance : scene.instances) {
        if (!instance.castsShadow) continue;
        const OcclusionMesh& mesh = scene.meshes[instance.mesh];
        const glm::dmat4 world(instance.worldFromLocal);
        for (const glm::uvec3& corners : mesh.triangles) {
            WorldTriangle triangle;
            for (int i = 0; i < 3; ++i)
                triangle.corner[i] = glm::dvec3(world * glm::dvec4(mesh.positions[corners[i]], 1.0));
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

inline bool meets(const WorldTriangle& triangle, const Ray& ray) {
    const glm::dvec3 from(ray.from), way(ray.way);
    const glm::dvec3 a = triangle.corner[0] - from, b = triangle.corner[1] - from,
                     c = triangle.corner[2] - from;
    const double u = glm::dot(way, glm::cross(c, b)), v = glm::dot(way, glm::cross(a, c)),
                 w = glm::dot(way, glm::cross(b, a)), area = u + v + w;
    if ((std::min({u, v, w}) < 0.0 && std::max({u, v, w}) > 0.0) || area == 0.0) return false;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double t = glm::dot(a, normal) / glm::dot(way, normal);
    return t > ray.tMin && t < ray.tMax;
}

/// Of the lines through two segments: the distance between the segments. Ericson, "Real-time collision
/// detection", 5.1.9.
inline double segmentDistance(glm::dvec3 p, glm::dvec3 pq, glm::dvec3 r, glm::dvec3 rs) {
    const glm::dvec3 between = p - r;
    const double a = glm::dot(pq, pq), e = glm::dot(rs, rs), f = glm::dot(rs, between),
                 c = glm::dot(pq, between), b = glm::dot(pq, rs), d = a * e - b * b;
    double s = d > 0.0 ? std::clamp((b * f - c * e) / d, 0.0, 1.0) : 0.0;
    double t = e > 0.0 ? (b * s + f) / e : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0.0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
    return glm::length(p + s * pq - (r + t * rs));
}

/// Single precision at 24 m resolves 2e-6 m; a ray in the space of a mesh has some five roundings.
inline constexpr double grazing = 1.0e-5;

/// Does the ray pass within `grazing` of an edge, or does it start or end that close to a triangle?
inline bool grazes(const std::vector<WorldTriangle>& triangles, const Ray& ray) {
    const glm::dvec3 from = glm::dvec3(ray.from) + double(ray.tMin) * glm::dvec3(ray.way);
    const glm::dvec3 way = glm::dvec3(ray.way) * (double(std::min(ray.tMax, 1000.0f)) - ray.tMin);
    for (const WorldTriangle& triangle : triangles) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 &p = triangle.corner[i], &q = triangle.corner[(i + 1) % 3];
            if (segmentDistance(from, way, p, q - p) <= grazing) return true;
        }
        const glm::dvec3 normal =
            glm::cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
        for (const glm::dvec3& end : {from, from + way}) {
            if (std::abs(glm::dot(end - triangle.corner[0], glm::normalize(normal))) > grazing) continue;
            const Ray through{glm::vec3(end - glm::normalize(normal)), 0.0f,
                              glm::vec3(2.0 * glm::normalize(normal)), 1.0f};
            if (meets(triangle, through)) return true;
        }
    }
    return false;
}

class EmbreeReference {
  public:
    explicit EmbreeReference(const std::vector<WorldTriangle>& triangles) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
        auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.size()));
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            for (std::uint32_t k = 0; k < 3; ++k) vertices[3 * i + k] = glm::vec3(triangles[i].corner[k]);
            indices[i] = {3 * i, 3 * i + 1, 3 * i + 2};
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }
    EmbreeReference(const EmbreeReference&) = delete;
    EmbreeReference& operator=(const EmbreeReference&) = delete;
    ~EmbreeReference() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    bool isOccluded(const Ray& ray) const {
        RTCRay query{};
        query.org_x = ray.from.x, query.org_y = ray.from.y, query.org_z = ray.from.z;
        query.dir_x = ray.way.x, query.dir_y = ray.way.y, query.dir_z = ray.way.z;
        query.tnear = ray.tMin, query.tfar = ray.tMax;
        query.mask = ~0u;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0.0f;
    }

  private:
    RTCDevice device_ = rtcNewDevice("threads=1");
    RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace candela::test
