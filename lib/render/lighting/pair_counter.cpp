#include "render/lighting/pair_counter.h"

#include "render/gbuffer/readback.h"
#include "render/layout.h"

#include <candela/gbuffer.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <numeric>

namespace candela {

namespace {

/// Pixels on the side of the directional lights that cast shadows.
std::uint64_t directionalRays(const LightingInputs& inputs) {
    const LightCounts& counts = inputs.lights.counts();
    std::vector<glm::vec3> directions;
    for (int i = counts.points + counts.spots; i < counts.points + counts.spots + counts.directionals; ++i) {
        const glm::vec4* record =
            inputs.lights.recordData().data() + static_cast<std::size_t>(i) * layout::LIGHT_TEXELS;
        if (record[1].w != 0.0f) directions.emplace_back(record[0]);
    }
    if (directions.empty()) return 0;
    std::uint64_t rays = 0;
    for (const GBufferTexel texel : readSurfaces(inputs.targets)) {
        if (texel.y == 0) continue;
        const glm::vec3 normal = unpackSurface(texel).normal;
        for (const glm::vec3& l : directions) rays += glm::dot(normal, l) > 0.0f;
    }
    return rays;
}

}  // namespace

PairCounter::RayPrograms::RayPrograms()
    : points({{"light_volume.vert", {}, {}}, {"light_volume_count.frag", {"SHADOWS 1", "SPOT 0"}, {}}},
             "ray count, points"),
      spots({{"light_volume.vert", {}, {}}, {"light_volume_count.frag", {"SHADOWS 1", "SPOT 1"}, {}}},
            "ray count, spots") {}

PairCounter::PairCounter()
    : program_({{"light_volume.vert", {}, {}}, {"light_volume_count.frag", {}, {}}}, "pair count") {}

const gl::Texture& PairCounter::target(const LightingInputs& inputs) {
    const GBufferTargets& targets = inputs.targets;
    if (!counts_ || width_ != targets.width || height_ != targets.height) {
        // Floats represent counts exactly up to 2^24 lights a pixel.
        counts_ = gl::Texture::target2d(GL_RGBA32F, targets.width, targets.height, "pair counts");
        width_ = targets.width;
        height_ = targets.height;
    }
    constexpr std::array<GLfloat, 4> zero{};
    glClearTexImage(counts_->name(), 0, GL_RGBA, GL_FLOAT, zero.data());
    return *counts_;
}

std::vector<float> PairCounter::read(const LightingInputs& inputs, Channel channel) const {
    const std::vector<float> texels = readColor(*counts_, inputs.targets.width, inputs.targets.height);
    std::vector<float> values(texels.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = texels[4 * i + static_cast<std::size_t>(channel)];
    return values;
}

const gl::Texture& PairCounter::drawLit(const LightingInputs& inputs) {
    const gl::Texture& counts = target(inputs);
    if (volumes_.prepare(inputs) > 0) {
        depth_.bind(inputs.targets, counts);
        volumes_.drawBackFaces(program_, program_);
    }
    return counts;
}

std::vector<float> PairCounter::litPerPixel(const LightingInputs& inputs) {
    drawLit(inputs);
    return read(inputs, Channel::lit);
}

std::uint32_t PairCounter::lightsInView(const LightingInputs& inputs) {
    return volumes_.prepare(inputs);
}

std::uint64_t PairCounter::countInside(const LightingInputs& inputs) {
    const gl::Texture& counts = target(inputs);
    if (volumes_.prepare(inputs) > 0) {
        depth_.bind(inputs.targets, counts);
        volumes_.drawInside(program_, program_);
    }
    return sum(inputs, Channel::evaluated);
}

std::uint64_t PairCounter::countRays(const LightingInputs& inputs) {
    if (!rayPrograms_) rayPrograms_.emplace();
    const gl::Texture& counts = target(inputs);
    if (volumes_.prepare(inputs) > 0) {
        depth_.bind(inputs.targets, counts);
        volumes_.drawBackFaces(rayPrograms_->points, rayPrograms_->spots);
    }
    return sum(inputs, Channel::rays) + directionalRays(inputs);
}

std::uint64_t PairCounter::sum(const LightingInputs& inputs, Channel channel) const {
    const std::vector<float> values = read(inputs, channel);
    return static_cast<std::uint64_t>(std::accumulate(values.begin(), values.end(), 0.0));
}

}  // namespace candela
