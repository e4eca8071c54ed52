#include "render/lighting/pair_counter.h"

#include "render/gbuffer/readback.h"

#include <array>
#include <numeric>

namespace candela {

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
        volumes_.drawBackFaces(program_);
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
    const std::vector<float> evaluated = read(inputs, Channel::evaluated);
    return static_cast<std::uint64_t>(std::accumulate(evaluated.begin(), evaluated.end(), 0.0));
}

}  // namespace candela
