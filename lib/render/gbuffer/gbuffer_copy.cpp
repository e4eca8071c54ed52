#include "render/gbuffer/gbuffer_copy.h"

#include "render/gbuffer/readback.h"

namespace candela {

void GBufferCopy::reset(const GBufferTargets& targets) {
    reset(targets, wholeOf(targets));
}

void GBufferCopy::reset(const GBufferTargets& targets, const gl::PixelRectangle& rectangle) {
    targets_ = &targets;
    rectangle_ = rectangle;
    present_ = 0;
}

const gl::TextureMapping& GBufferCopy::mappingOf(int output) const {
    return targets_->wordMappings[targets_->indexOf(output)];
}

template <typename T, typename Read>
std::span<const T> GBufferCopy::once(std::vector<T>& values, std::size_t perPixel, unsigned part,
                                     const gl::TextureMapping& mapping, const Read& read) {
    const bool isPresent = (present_ & part) != 0;
    present_ |= part;
    const std::size_t count =
        perPixel * static_cast<std::size_t>(targets_->width) * static_cast<std::size_t>(targets_->height);
    if (mapping.data() != nullptr && mapped_ == Mapped::inPlace) {
        if (!isPresent) glFinish();
        std::vector<T>().swap(values);  // What earlier targets needed.
        return {reinterpret_cast<const T*>(mapping.data()), count};
    }
    if (!isPresent) {
        values.resize(count);
        read(std::span<T>(values));
    }
    return values;
}

std::span<const std::uint32_t> GBufferCopy::words(std::vector<std::uint32_t>& values, std::size_t perPixel,
                                                  unsigned part, int output) {
    return once(values, perPixel, part, mappingOf(output),
                [&](std::span<std::uint32_t> into) { readWords(*targets_, rectangle_, output, into); });
}

std::span<const std::uint32_t> GBufferCopy::surfaces() {
    return words(surfaces_, 2, 1, layout::SURFACE_OUTPUT);
}

std::span<const float> GBufferCopy::depth() {
    return once(depth_, 1, 2, targets_->depthMapping,
                [&](std::span<float> into) { readDepth(*targets_, rectangle_, into); });
}

std::span<const std::uint32_t> GBufferCopy::shadowWords() {
    return words(shadowWords_, 1, 4, layout::SHADOW_OUTPUT);
}

std::span<const std::uint8_t> GBufferCopy::occlusion() {
    return once(occlusion_, 1, 8, mappingOf(layout::OCCLUSION_OUTPUT),
                [&](std::span<std::uint8_t> into) { readOcclusion(*targets_, rectangle_, into); });
}

std::span<const std::uint32_t> GBufferCopy::lobeWords() {
    return words(lobeWords_, 4, 16, layout::LOBES_OUTPUT);
}

std::span<const std::uint32_t> GBufferCopy::diffuseTransmission() {
    return words(diffuseTransmission_, 1, 32, layout::DIFFUSE_TRANSMISSION_OUTPUT);
}

}  // namespace candela
