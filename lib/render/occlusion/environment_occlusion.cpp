#include "render/occlusion/environment_occlusion.h"

#include "base/thread_pool.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/readback.h"
#include "render/occlusion/ray_packet.h"
#include "render/occlusion/shared_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr int pattern = rays::OCCLUSION_PATTERN;
/// Pixels along the side of a tile: a packet has the rays of one place of the pattern and one direction.
constexpr int tileSide = 16;
static_assert(tileSide / pattern * (tileSide / pattern) == RayPacket::size);

bool isOrthographic(const layout::FrameUniforms& frame) {
    return frame.depthRange.w != 0.0f;
}

/// The side of a pixel at a distance along the view axis, metres.
float pixelExtentAt(const layout::FrameUniforms& frame, float viewDistance) {
    const float side = glm::length(glm::vec3(frame.rayStepY));
    return isOrthographic(frame) ? side : viewDistance * side;
}

/// Heights over a plane through the eye.
class PixelPlane {
  public:
    PixelPlane(const layout::FrameUniforms& frame, const glm::vec3& normal)
        : corner_(glm::dot(normal, glm::vec3(frame.rayCorner))),
          stepX_(glm::dot(normal, glm::vec3(frame.rayStepX))),
          stepY_(glm::dot(normal, glm::vec3(frame.rayStepY))),
          forward_(glm::dot(normal, glm::vec3(frame.cameraForward))),
          orthographic_(isOrthographic(frame)) {}

    /// Of the surface of a pixel.
    float heightOf(int x, int y, float viewDistance) const {
        const float ray = corner_ + static_cast<float>(x) * stepX_ + static_cast<float>(y) * stepY_;
        return orthographic_ ? ray + forward_ * viewDistance : ray * viewDistance;
    }

  private:
    float corner_, stepX_, stepY_, forward_;
    bool orthographic_;
};

/// Sixteen pixels of a tile at the same place of the pattern.
struct Hemispheres {
    glm::vec3 origin[RayPacket::size], normal[RayPacket::size], geometricNormal[RayPacket::size];
    rays::TangentPair tangents[RayPacket::size];
    std::size_t pixel[RayPacket::size];
    std::int32_t active[RayPacket::size] = {};  ///< As in `RayPacket`.
    bool any = false;
};

RayPacket packetOf(const Hemispheres& from, const glm::vec3& direction, float distance) {
    RayPacket packet;
    for (int lane = 0; lane < RayPacket::size; ++lane) {
        const glm::vec3 way = rays::aboveTriangle(direction.x * from.tangents[lane].first +
                                                      direction.y * from.tangents[lane].second +
                                                      direction.z * from.normal[lane],
                                                  from.geometricNormal[lane]);
        for (int axis = 0; axis < 3; ++axis) {
            packet.origin[axis][lane] = from.origin[lane][axis];
            packet.direction[axis][lane] = way[axis];
        }
        packet.tMin[lane] = 0.0f;
        packet.tMax[lane] = distance;
        packet.active[lane] = from.active[lane];
    }
    return packet;
}

}  // namespace

/// The pixels of a tile, read place by place of the pattern.
struct EnvironmentOcclusion::Tile {
    const EnvironmentOcclusionInputs& inputs;
    int left, bottom;

    Hemispheres hemispheres(int placeX, int placeY, std::vector<Sample>& samples) const {
        Hemispheres result{};
        for (int lane = 0; lane < RayPacket::size; ++lane) {
            const int x = left + placeX + pattern * (lane % pattern),
                      y = bottom + placeY + pattern * (lane / pattern);
            if (x < inputs.frame.size.x && y < inputs.frame.size.y) read(x, y, lane, result, samples);
        }
        return result;
    }

  private:
    void read(int x, int y, int lane, Hemispheres& result, std::vector<Sample>& samples) const {
        const layout::FrameUniforms& frame = inputs.frame;
        const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.size.x) +
                              static_cast<std::size_t>(x);
        samples[i].viewDistance = 0.0f;
        result.pixel[lane] = i;
        if (inputs.surfaces[2 * i + 1] == 0) return;
        const float distance = viewDistance(frame, inputs.depth[i]);
        const glm::vec3 position = worldPosition(frame, x, y, inputs.depth[i]);
        const ShadowSurface surface = unpackShadowWord(inputs.shadowWords[i]);
        samples[i] = {surface.geometricNormal, distance};
        const glm::vec3 way =
            isOrthographic(frame) ? -glm::vec3(frame.cameraForward) : glm::vec3(frame.eye) - position;
        result.origin[lane] = rays::shadowRayEnd(position, way, surface.geometricNormal, surface.lift,
                                                 pixelExtentAt(frame, distance));
        result.normal[lane] = unpackNormal(inputs.surfaces[2 * i + 1]);
        result.geometricNormal[lane] = surface.geometricNormal;
        result.tangents[lane] = rays::tangentsOf(result.normal[lane]);
        result.active[lane] = -1;
        result.any = true;
    }
};

void EnvironmentOcclusion::trace(const EnvironmentOcclusionInputs& inputs,
                                 std::span<const glm::vec3> directions, int left, int bottom) {
    const Tile tile{inputs, left, bottom};
    const std::uint32_t count = inputs.rays.rays;
    for (int place = 0; place < pattern * pattern; ++place) {
        const Hemispheres from = tile.hemispheres(place % pattern, place / pattern, samples_);
        if (!from.any) continue;
        float hidden[RayPacket::size] = {};
        for (std::uint32_t ray = 0; ray < count; ++ray) {
            const glm::vec3& direction = directions[static_cast<std::size_t>(place) * count + ray];
            float passing[RayPacket::size];
            inputs.occluders.trace(inputs.occluders.rays, packetOf(from, direction, inputs.rays.distance),
                                   passing);
            for (int lane = 0; lane < RayPacket::size; ++lane) hidden[lane] += 1.0f - passing[lane];
        }
        for (int lane = 0; lane < RayPacket::size; ++lane) {
            if (from.active[lane] != 0) hidden_[from.pixel[lane]] = hidden[lane] / static_cast<float>(count);
        }
    }
}

/// The mean over the pixels of a window of the pattern's size that lie on the surface of pixel (x, y).
float EnvironmentOcclusion::hiddenAt(const EnvironmentOcclusionInputs& inputs, int x, int y) const {
    const layout::FrameUniforms& frame = inputs.frame;
    const auto width = static_cast<std::size_t>(frame.size.x);
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
    };
    const int left = x + rays::filterStart(inputs.rays.sample, 0),
              bottom = y + rays::filterStart(inputs.rays.sample, 1);
    const int endRow = std::min(bottom + pattern, frame.size.y),
              endColumn = std::min(left + pattern, frame.size.x);
    float any = 0.0f;
    for (int row = std::max(bottom, 0); row < endRow; ++row) {
        for (int column = std::max(left, 0); column < endColumn; ++column) any += hidden_[at(column, row)];
    }
    if (any == 0.0f) return 0.0f;
    const Sample& center = samples_[at(x, y)];
    const PixelPlane plane(frame, center.geometricNormal);
    const float height = plane.heightOf(x, y, center.viewDistance);
    const float extent = pixelExtentAt(frame, center.viewDistance);
    float sum = 0.0f, weight = 0.0f;
    for (int row = std::max(bottom, 0); row < endRow; ++row) {
        for (int column = std::max(left, 0); column < endColumn; ++column) {
            const std::size_t index = at(column, row);
            const Sample& other = samples_[index];
            if (other.viewDistance == 0.0f) continue;
            const float distance = plane.heightOf(column, row, other.viewDistance) - height;
            const float cosine = glm::dot(center.geometricNormal, other.geometricNormal);
            if (!rays::isFiltered(distance, cosine, extent)) continue;
            sum += hidden_[index];
            weight += 1.0f;
        }
    }
    return weight > 0.0f ? sum / weight : hidden_[at(x, y)];
}

void EnvironmentOcclusion::filterRow(const EnvironmentOcclusionInputs& inputs, int y) {
    for (int x = 0; x < inputs.frame.size.x; ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(inputs.frame.size.x) +
                              static_cast<std::size_t>(x);
        visibility_[i] = 0;
        if (samples_[i].viewDistance == 0.0f) continue;
        const float texture =
            inputs.textures.empty() ? 1.0f : static_cast<float>(inputs.textures[i]) / 255.0f;
        const float visibility = (1.0f - hiddenAt(inputs, x, y)) * texture;
        visibility_[i] = static_cast<std::uint8_t>(std::floor(visibility * 255.0f + 0.5f));
    }
}

std::span<const std::uint8_t> EnvironmentOcclusion::compute(const EnvironmentOcclusionInputs& inputs) {
    const glm::ivec2 size(inputs.frame.size);
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    samples_.resize(pixels);
    hidden_.assign(pixels, 0.0f);
    visibility_.resize(pixels);
    std::vector<glm::vec3> directions;
    for (std::uint32_t place = 0; place < pattern * pattern; ++place) {
        const std::uint32_t first =
            rays::firstEnvironmentRay(place % pattern, place / pattern, inputs.rays.sample, inputs.rays.rays);
        for (std::uint32_t ray = 0; ray < inputs.rays.rays; ++ray)
            directions.push_back(rays::environmentDirection(first + ray));
    }
    const int columns = (size.x + tileSide - 1) / tileSide, rows = (size.y + tileSide - 1) / tileSide;
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    pool->run(static_cast<std::size_t>(columns * rows), [&](std::size_t i, unsigned) {
        const int tile = static_cast<int>(i);
        trace(inputs, directions, tile % columns * tileSide, tile / columns * tileSide);
    });
    pool->run(static_cast<std::size_t>(size.y),
              [&](std::size_t y, unsigned) { filterRow(inputs, static_cast<int>(y)); });
    return visibility_;
}

}  // namespace candela
