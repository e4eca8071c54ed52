#include "render/occlusion/ambient_occlusion.h"

#include "base/thread_pool.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/readback.h"
#include "render/occlusion/ray_packet.h"
#include "render/occlusion/shared_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// The sine of the lowest elevation of a ray. The normals of the G-buffer err by up to 0.058 degrees, and
/// rays nearer to the plane might meet the surface itself: 0.12 degrees.
constexpr float minElevation = 0.002f;

/// Van der Corput's sequence in base 2: the bits mirrored at the binary point.
float radicalInverse(std::uint32_t i) {
    i = (i & 0x55555555u) << 1 | (i >> 1 & 0x55555555u);
    i = (i & 0x33333333u) << 2 | (i >> 2 & 0x33333333u);
    i = (i & 0x0f0f0f0fu) << 4 | (i >> 4 & 0x0f0f0f0fu);
    i = i << 24 | (i & 0xff00u) << 8 | (i >> 8 & 0xff00u) | i >> 24;
    return static_cast<float>(i >> 8) * 0x1p-24f;
}

/// A bijection of 32 bits with little bias, as a number from 0 to less than 1. Constants: Chris Wellons,
/// "Prospecting for hash functions", 2018.
float hashed(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

/// Two vectors that make an orthonormal basis with a unit vector. Duff et al., "Building an orthonormal
/// basis, revisited", 2017.
struct Tangents {
    explicit Tangents(const glm::vec3& n) {
        const float sign = std::copysign(1.0f, n.z), a = -1.0f / (sign + n.z), b = n.x * n.y * a;
        first = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
        second = {b, sign + n.y * n.y * a, -n.y};
    }
    glm::vec3 first, second;
};

/// A point above a surface and the directions that are free there.
struct Hemisphere {
    glm::vec3 origin, normal;
    float angle;  ///< Of the rotation around the normal, radians.
    float shift;  ///< In the strata of radii, 0 to 1.
};

class Sampler {
  public:
    explicit Sampler(const AmbientOcclusionInputs& inputs) : inputs_(inputs) {
        for (std::uint32_t i = 0; i < inputs.settings.rays; ++i) {
            const float angle = 2.0f * std::numbers::pi_v<float> * radicalInverse(i);
            onCircle_.emplace_back(std::cos(angle), std::sin(angle));
        }
    }

    float openShare(int x, int y) const {
        const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(inputs_.frame.size.x) +
                              static_cast<std::size_t>(x);
        if (inputs_.surfaces[i].y == 0) return 0.0f;
        const Hemisphere hemisphere = hemisphereAt(i, x, y);
        const auto rays = static_cast<std::uint32_t>(onCircle_.size());
        float blocked = 0.0f;
        for (std::uint32_t first = 0; first < rays; first += RayPacket::size) {
            float passing[RayPacket::size];
            inputs_.occluders.trace(inputs_.occluders.rays, packetOf(hemisphere, first), passing);
            for (const float share : passing) blocked += 1.0f - share;
        }
        return 1.0f - blocked / static_cast<float>(rays);
    }

  private:
    Hemisphere hemisphereAt(std::size_t i, int x, int y) const {
        const layout::FrameUniforms& frame = inputs_.frame;
        const glm::vec3 eye(frame.eye), forward(frame.cameraForward);
        const glm::vec3 position = worldPosition(frame, x, y, inputs_.depth[i]);
        const bool orthographic = frame.depthRange.w != 0.0f;
        const float pixelSide = glm::length(glm::vec3(frame.rayStepY));
        const float pixelExtent = orthographic ? pixelSide : glm::dot(position - eye, forward) * pixelSide;
        const ShadowSurface surface = unpackShadowWord(inputs_.shadowWords[i]);
        // The number of the pixel in its picture, of which the frame may be a part.
        const auto seed =
            2 * static_cast<std::uint32_t>((y + frame.size.w) * frame.lightCounts.w + x + frame.size.z);
        return {rays::shadowRayEnd(position, orthographic ? -forward : eye - position,
                                   surface.geometricNormal, surface.lift, pixelExtent),
                unpackSurface(inputs_.surfaces[i]).normal, 2.0f * std::numbers::pi_v<float> * hashed(seed),
                hashed(seed + 1)};
    }

    RayPacket packetOf(const Hemisphere& hemisphere, std::uint32_t first) const {
        const Tangents tangents(hemisphere.normal);
        const auto rays = static_cast<std::uint32_t>(onCircle_.size());
        const float cosine = std::cos(hemisphere.angle), sine = std::sin(hemisphere.angle);
        const glm::vec3 across = cosine * tangents.first + sine * tangents.second;
        const glm::vec3 along = cosine * tangents.second - sine * tangents.first;
        RayPacket packet;
        for (std::uint32_t lane = 0; lane < RayPacket::size; ++lane) {
            const std::uint32_t ray = std::min(first + lane, rays - 1);
            const float area = (static_cast<float>(ray) + hemisphere.shift) / static_cast<float>(rays);
            const float radius = std::sqrt(area);
            const float elevation = std::max(std::sqrt(std::max(1.0f - area, 0.0f)), minElevation);
            const glm::vec3 direction = radius * (onCircle_[ray].x * across + onCircle_[ray].y * along) +
                                        elevation * hemisphere.normal;
            for (int axis = 0; axis < 3; ++axis) {
                packet.origin[axis][lane] = hemisphere.origin[axis];
                packet.direction[axis][lane] = direction[axis];
            }
            packet.tMin[lane] = 0.0f;
            packet.tMax[lane] = inputs_.settings.distance;
            packet.active[lane] = first + lane < rays ? -1 : 0;
        }
        return packet;
    }

    const AmbientOcclusionInputs& inputs_;
    std::vector<glm::vec2> onCircle_;  ///< The directions around the normal, one a ray.
};

}  // namespace

std::vector<float> ambientOcclusion(const AmbientOcclusionInputs& inputs) {
    const auto width = static_cast<std::size_t>(inputs.frame.size.x),
               height = static_cast<std::size_t>(inputs.frame.size.y);
    const Sampler sampler(inputs);
    std::vector<float> shares(width * height);
    ThreadPool::shared()->run(height, [&](std::size_t y, unsigned) {
        for (std::size_t x = 0; x < width; ++x)
            shares[y * width + x] = sampler.openShare(static_cast<int>(x), static_cast<int>(y));
    });
    return shares;
}

}  // namespace candela
