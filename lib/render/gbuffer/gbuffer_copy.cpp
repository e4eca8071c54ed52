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

template <typename T, typename Read>
std::span<const T> GBufferCopy::once(std::vector<T>& values, std::size_t perPixel, unsigned part,
                                     const Read& read) {
    if ((present_ & part) == 0) {
        values.resize(perPixel * static_cast<std::size_t>(targets_->width) *
                      static_cast<std::size_t>(targets_->height));
        read(std::span<T>(values));
    }
    present_ |= part;
    return values;
}

std::span<const std::uint32_t> GBufferCopy::surfaces() {
    return once(surfaces_, 2, 1, [&](std::span<std::uint32_t> into) {
        readWords(*targets_, rectangle_, layout::SURFACE_OUTPUT, into);
    });
}

std::span<const float> GBufferCopy::depth() {
    return once(depth_, 1, 2, [&](std::span<float> into) { readDepth(*targets_, rectangle_, into); });
}

std::span<const std::uint32_t> GBufferCopy::shadowWords() {
    return once(shadowWords_, 1, 4, [&](std::span<std::uint32_t> into) {
        readWords(*targets_, rectangle_, layout::SHADOW_OUTPUT, into);
    });
}

std::span<const std::uint8_t> GBufferCopy::occlusion() {
    return once(occlusion_, 1, 8,
                [&](std::span<std::uint8_t> into) { readOcclusion(*targets_, rectangle_, into); });
}

std::span<const std::uint32_t> GBufferCopy::lobeWords() {
    return once(lobeWords_, 4, 16, [&](std::span<std::uint32_t> into) {
        readWords(*targets_, rectangle_, layout::LOBES_OUTPUT, into);
    });
}

std::span<const std::uint32_t> GBufferCopy::diffuseTransmission() {
    return once(diffuseTransmission_, 1, 32, [&](std::span<std::uint32_t> into) {
        readWords(*targets_, rectangle_, layout::DIFFUSE_TRANSMISSION_OUTPUT, into);
    });
}

}  // namespace candela
