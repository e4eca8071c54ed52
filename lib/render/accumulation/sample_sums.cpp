#include "render/accumulation/sample_sums.h"

#include "base/thread_pool.h"
#include "render/layout.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace candela {

namespace {

/// How many frames the first level takes.
constexpr std::uint32_t levelSize = 256;

void clearToBlack(const gl::Framebuffer& framebuffer) {
    constexpr std::array<GLfloat, 4> black{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, black.data());
}

void upload(const SampleTarget& target, int width, int height, std::span<const float> rgba) {
    glTextureSubImage2D(target.texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
}

/// Calls `body(first, end)` for spans of `pixels` pixels, on all cores.
template <typename Body>
void forSpans(std::size_t pixels, const Body& body) {
    constexpr std::size_t perSpan = std::size_t{1} << 15;
    ThreadPool::shared()->run((pixels + perSpan - 1) / perSpan, [&](std::size_t i, unsigned) {
        body(i * perSpan, std::min(pixels, (i + 1) * perSpan));
    });
}

}  // namespace

SampleTarget::SampleTarget(int width, int height, const char* label)
    : texture(gl::Texture::target2d(GL_RGBA32F, width, height, label)),
      framebuffer({&texture}, nullptr, label) {}

SampleSums::Device::Device(int width, int height)
    : sum(width, height, "sum of samples"),
      largeSum(width, height, "large sum of samples"),
      addProgram({{"fullscreen_triangle.vert", {}, {}}, {"sample_add.frag", {}, {}}}, "sample add"),
      meanProgram({{"fullscreen_triangle.vert", {}, {}}, {"sample_mean.frag", {}, {}}}, "sample mean"),
      vertexArray("samples") {
    clearToBlack(sum.framebuffer);
    clearToBlack(largeSum.framebuffer);
}

SampleSums::SampleSums(int width, int height)
    : width_(width), height_(height), mean_(width, height, "mean of samples") {}

void SampleSums::clear() {
    if (onDevice_) {
        clearToBlack(device_->sum.framebuffer);
        clearToBlack(device_->largeSum.framebuffer);
    }
    memory_.largeSum.clear();
    onDevice_ = false;
    count_ = meanOf_ = memory_.meanOf = 0;
}

void SampleSums::add(const GBufferTargets& targets) {
    const bool inMemory = !targets.memory.radiance.empty();
    if (inMemory && !onDevice_) {
        addInMemory(targets.memory);
    } else {
        if (!onDevice_) moveToDevice();
        addOnDevice(targets);
    }
}

void SampleSums::moveToDevice() {
    if (!device_) device_.emplace(width_, height_);
    if (count_ > 0) {
        for (std::size_t i = 0; i < memory_.coverage.size(); ++i)
            memory_.sum[4 * i + 3] = memory_.coverage[i];
        upload(device_->sum, width_, height_, memory_.sum);
    }
    if (!memory_.largeSum.empty()) {
        for (std::size_t i = 3; i < memory_.largeSum.size(); i += 4) memory_.largeSum[i] = 0.0f;
        upload(device_->largeSum, width_, height_, memory_.largeSum);
    }
    memory_ = {};
    onDevice_ = true;
}

void SampleSums::draw(const gl::Program& program, const SampleTarget& into) const {
    glUseProgram(program.name());
    glBindVertexArray(device_->vertexArray.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, into.framebuffer.name());
    glViewport(0, 0, width_, height_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SampleSums::addOnDevice(const GBufferTargets& targets) {
    glBindTextureUnit(layout::RADIANCE_UNIT, targets.litRadiance().name());
    glBindTextureUnit(layout::DEPTH_UNIT, targets.depth.name());
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_BLEND);
    draw(device_->addProgram, device_->sum);
    glDisable(GL_BLEND);
    if (++count_ % levelSize != 0) return;
    writeMeanOnDevice(1.0f, mean_);
    std::swap(mean_, device_->largeSum);
    clearToBlack(device_->sum.framebuffer);
}

void SampleSums::addInMemory(const GBufferTargets::Memory& frame) {
    const std::size_t pixels = frame.depth.size();
    memory_.sum.resize(4 * pixels);
    memory_.coverage.resize(pixels);
    const bool replaces = count_ == 0;
    forSpans(pixels, [&](std::size_t first, std::size_t end) {
        const float* radiance = frame.radiance.data();
        float* sum = memory_.sum.data();
        if (replaces) {
            std::fill(sum + 4 * first, sum + 4 * end, 0.0f);
            std::fill(memory_.coverage.data() + first, memory_.coverage.data() + end, 0.0f);
        }
        for (std::size_t c = 4 * first; c < 4 * end; ++c) sum[c] += radiance[c];
    });
    countInMemory(frame.depth);
}

void SampleSums::countInMemory(std::span<const float> depth) {
    forSpans(depth.size(), [&](std::size_t first, std::size_t end) {
        float* coverage = memory_.coverage.data();
        for (std::size_t i = first; i < end; ++i) coverage[i] += depth[i] > 0.0f ? 1.0f : 0.0f;
    });
    if (++count_ % levelSize == 0) carryInMemory();
}

void SampleSums::carryInMemory() {
    memory_.largeSum.resize(memory_.sum.size(), 0.0f);
    forSpans(memory_.sum.size(), [&](std::size_t first, std::size_t end) {
        for (std::size_t c = first; c < end; ++c) memory_.largeSum[c] += std::exchange(memory_.sum[c], 0.0f);
    });
}

void SampleSums::writeMeanOnDevice(float divisor, const SampleTarget& into) const {
    glBindTextureUnit(layout::SUM_UNIT, device_->sum.texture.name());
    glBindTextureUnit(layout::LARGE_SUM_UNIT, device_->largeSum.texture.name());
    glProgramUniform1f(device_->meanProgram.name(), layout::SAMPLE_COUNT_LOCATION, divisor);
    draw(device_->meanProgram, into);
}

std::span<const float> SampleSums::meanInMemory() {
    if (memory_.meanOf == count_) return memory_.mean;
    memory_.meanOf = count_;
    memory_.mean.resize(memory_.sum.size());
    const auto divisor = static_cast<float>(count_);
    forSpans(memory_.coverage.size(), [&](std::size_t first, std::size_t end) {
        float* mean = memory_.mean.data();
        for (std::size_t c = 4 * first; c < 4 * end; ++c) {
            const float large = memory_.largeSum.empty() ? 0.0f : memory_.largeSum[c];
            mean[c] = (memory_.sum[c] + large) / divisor;
        }
        for (std::size_t i = first; i < end; ++i) mean[4 * i + 3] = memory_.coverage[i] / divisor;
    });
    return memory_.mean;
}

const gl::Texture& SampleSums::mean() {
    if (meanOf_ == count_) return mean_.texture;
    if (onDevice_)
        writeMeanOnDevice(static_cast<float>(count_), mean_);
    else
        upload(mean_, width_, height_, meanInMemory());
    meanOf_ = count_;
    return mean_.texture;
}

}  // namespace candela
