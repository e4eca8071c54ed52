#include "render/lighting/pair_counter.h"

#include "render/gbuffer/gbuffer_copy.h"
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

/// From where a pixel is lit.
struct LitSides {
    glm::vec3 normal, coatNormal;
    bool behind;

    bool faces(const glm::vec3& l) const {
        const float cosine = glm::dot(normal, l);
        return cosine > 0.0f || glm::dot(coatNormal, l) > 0.0f || (behind && cosine < 0.0f);
    }
};

LitSides litSides(GBufferCopy& copy, std::size_t pixel, bool hasLobeWords) {
    const glm::vec3 normal = unpackNormal(copy.surfaces()[2 * pixel + 1]);
    LitSides sides{normal, normal, false};
    if (!hasLobeWords || copy.lobeWords()[4 * pixel + 2] == 0) return sides;
    GBufferLobeWords words;
    for (std::size_t i = 0; i < words.lobes.size(); ++i) words.lobes[i] = copy.lobeWords()[4 * pixel + i];
    words.diffuseTransmission = copy.diffuseTransmission()[pixel];
    const ExtendedLobes<float> lobes = unpackLobeWords(words, normal);
    if (lobes.clearcoat > 0.0f) sides.coatNormal = lobes.clearcoatNormal;
    sides.behind = lobes.diffuseTransmission > 0.0f;
    return sides;
}

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
    GBufferCopy copy;
    copy.reset(inputs.targets);
    std::uint64_t rays = 0;
    for (std::size_t pixel = 0; pixel < copy.depth().size(); ++pixel) {
        if (copy.surfaces()[2 * pixel + 1] == 0) continue;
        const LitSides sides = litSides(copy, pixel, inputs.targets.parts.lobes);
        for (const glm::vec3& l : directions) rays += sides.faces(l);
    }
    return rays;
}

std::vector<std::string> with(std::vector<std::string> definitions, const char* last) {
    definitions.emplace_back(last);
    return definitions;
}

}  // namespace

PairCounter::RayPrograms::RayPrograms(const std::vector<std::string>& definitions)
    : points({{"light_volume.vert", {}, {}}, {"light_volume_count.frag", with(definitions, "SPOT 0"), {}}},
             "ray count, points"),
      spots({{"light_volume.vert", {}, {}}, {"light_volume_count.frag", with(definitions, "SPOT 1"), {}}},
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
    const bool withLobes = inputs.targets.parts.lobes;
    std::optional<RayPrograms>& programs = rayPrograms_[withLobes ? 1 : 0];
    if (!programs) {
        programs.emplace(withLobes ? std::vector<std::string>{"SHADOWS 1", "LOBES 1"}
                                   : std::vector<std::string>{"SHADOWS 1"});
    }
    const gl::Texture& counts = target(inputs);
    if (volumes_.prepare(inputs) > 0) {
        depth_.bind(inputs.targets, counts);
        volumes_.drawBackFaces(programs->points, programs->spots);
    }
    return sum(inputs, Channel::rays) + directionalRays(inputs);
}

std::uint64_t PairCounter::sum(const LightingInputs& inputs, Channel channel) const {
    const std::vector<float> values = read(inputs, channel);
    return static_cast<std::uint64_t>(std::accumulate(values.begin(), values.end(), 0.0));
}

}  // namespace candela
