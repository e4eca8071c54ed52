#include "render/occlusion/environment_occlusion.h"

#include "base/thread_pool.h"
#include "render/environment/environment_map.h"
#include "render/lighting/tiled/cpu_tiles.h"
#include "render/occlusion/ray_packet.h"
#include "render/occlusion/shared_rays.h"

#include <algorithm>

namespace candela {

namespace {

constexpr int pattern = rays::OCCLUSION_PATTERN;
/// Pixels along the side of a tile: a packet has the rays of one place of the pattern and one direction.
constexpr int tileSide = 16;
static_assert(tileSide / pattern * (tileSide / pattern) == RayPacket::size);

}  // namespace

void EnvironmentOcclusion::trace(const EnvironmentOcclusionInputs& inputs, const TileFrame& frame,
                                 std::span<const glm::vec3> directions, int left, int bottom) {
    const TileKernel& kernel = tileKernel();
    const std::uint32_t count = inputs.rays.rays;
    for (int place = 0; place < pattern * pattern; ++place) {
        HemisphereBlock from;
        const int x = left + place % pattern, y = bottom + place / pattern;
        kernel.readHemispheres(frame, x, y, pattern, from);
        float hidden[RayPacket::size] = {};
        const bool any = std::ranges::any_of(from.active, [](std::int32_t active) { return active != 0; });
        for (std::uint32_t ray = 0; any && ray < count; ++ray) {
            const glm::vec3& direction = directions[static_cast<std::size_t>(place) * count + ray];
            RayPacket packet;
            kernel.aimRays(from, &direction.x, inputs.rays.distance, packet);
            float passing[RayPacket::size];
            inputs.occluders.trace(inputs.occluders.rays, packet, passing);
            for (int lane = 0; lane < RayPacket::size; ++lane)
                hidden[lane] += (1.0f - passing[lane]) / static_cast<float>(count);
        }
        for (int lane = 0; lane < RayPacket::size; ++lane) {
            const int column = x + pattern * (lane % pattern), row = y + pattern * (lane / pattern);
            if (column < frame.width && row < frame.height)
                surfaces_.set(static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) +
                                  static_cast<std::size_t>(column),
                              from, lane, hidden[lane]);
        }
    }
}

void EnvironmentOcclusion::Surfaces::resize(std::size_t pixels) {
    const auto fit = [&](std::vector<float>& column) {
        column.resize(pixels + 2 * VisibilityFilterJob::padding);
    };
    for (std::vector<float>& column : normal) fit(column);
    for (std::vector<float>& column : position) fit(column);
    fit(extent), fit(hidden);
}

void EnvironmentOcclusion::Surfaces::set(std::size_t pixel, const HemisphereBlock& block, int lane,
                                         float hiddenShare) {
    const std::size_t at = VisibilityFilterJob::padding + pixel;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        normal[axis][at] = block.geometricNormal[axis][lane];
        position[axis][at] = block.position[axis][lane];
    }
    extent[at] = block.extent[lane];
    hidden[at] = hiddenShare;
}

VisibilityFilterJob EnvironmentOcclusion::filterJob(const EnvironmentOcclusionInputs& inputs) {
    const auto begin = [](const std::vector<float>& column) {
        return column.data() + VisibilityFilterJob::padding;
    };
    VisibilityFilterJob job{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        job.normal[axis] = begin(surfaces_.normal[axis]);
        job.position[axis] = begin(surfaces_.position[axis]);
    }
    job.extent = begin(surfaces_.extent);
    job.hidden = begin(surfaces_.hidden);
    job.textures = inputs.textures.empty() ? nullptr : inputs.textures.data();
    job.visibility = visibility_.data();
    job.width = inputs.frame.size.x;
    job.height = inputs.frame.size.y;
    job.left = rays::filterStart(inputs.rays.sample, 0);
    job.bottom = rays::filterStart(inputs.rays.sample, 1);
    job.side = pattern;
    job.maxDistance = rays::MAX_FILTER_PIXELS;
    job.minCosine = rays::MIN_FILTER_COSINE;
    return job;
}

std::span<const std::uint8_t> EnvironmentOcclusion::compute(const EnvironmentOcclusionInputs& inputs) {
    const glm::ivec2 size(inputs.frame.size);
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    surfaces_.resize(pixels);
    visibility_.resize(pixels);
    std::vector<glm::vec3> directions;
    for (std::uint32_t place = 0; place < pattern * pattern; ++place) {
        const std::uint32_t first =
            rays::firstEnvironmentRay(place % pattern, place / pattern, inputs.rays.sample, inputs.rays.rays);
        for (std::uint32_t ray = 0; ray < inputs.rays.rays; ++ray)
            directions.push_back(rays::environmentDirection(first + ray));
    }
    TileFrame frame{};
    readView(frame, inputs.frame);
    frame.width = size.x;
    frame.height = size.y;
    frame.surfaces = inputs.surfaces.data();
    frame.depth = inputs.depth.data();
    frame.shadowWords = inputs.shadowWords.data();
    const gl::PixelRectangle& part = inputs.rectangle;
    const int left = part.x / tileSide, columns = (part.x + part.width + tileSide - 1) / tileSide - left;
    const int bottom = part.y / tileSide, rows = (part.y + part.height + tileSide - 1) / tileSide - bottom;
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    pool->run(static_cast<std::size_t>(columns * rows), [&](std::size_t i, unsigned) {
        const int tile = static_cast<int>(i);
        trace(inputs, frame, directions, (left + tile % columns) * tileSide,
              (bottom + tile / columns) * tileSide);
    });
    const VisibilityFilterJob job = filterJob(inputs);
    const EnvironmentKernel& kernel = environmentKernel();
    pool->run(static_cast<std::size_t>(part.height),
              [&](std::size_t row, unsigned) { kernel.visibility(job, part.y + static_cast<int>(row)); });
    return visibility_;
}

}  // namespace candela
