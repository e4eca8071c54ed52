#include "viewport.h"

#include <epoxy/gl.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <utility>

namespace {

/// A frame that takes longer than this is drawn at a lower resolution while the camera moves.
constexpr double interactiveMilliseconds = 50.0;
constexpr int maxDivisor = 4;
/// The resolution stays reduced in pauses of the motion that are shorter than this.
constexpr std::chrono::milliseconds rest{150};

}  // namespace

Viewport::Viewport(const candela::Context& context) : context_(context), renderer_(context) {
    glCreateFramebuffers(1, &framebuffer_);
    glObjectLabel(GL_FRAMEBUFFER, framebuffer_, -1, "picture");
}

Viewport::~Viewport() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void Viewport::resize(const glm::ivec2& size) {
    if (size == size_) return;
    glDeleteTextures(1, &texture_);
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glObjectLabel(GL_TEXTURE, texture_, -1, "picture");
    glTextureStorage2D(texture_, 1, GL_RGBA8, size.x, size.y);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    size_ = size;
}

double Viewport::draw(const Inputs& inputs) {
    const auto start = std::chrono::steady_clock::now();
    frame_.reset();
    samples_ = 0;
    frame_.emplace(draw(renderer_, inputs));
    samples_ = 1;
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void Viewport::refine(const Inputs& inputs) {
    if (!accumulator_) accumulator_.emplace(context_);
    if (samples_ == 1) {
        accumulator_->reset();
        accumulator_->add(*frame_);
    }
    frame_.reset();
    frame_.emplace(render(renderer_, inputs, samples_));
    accumulator_->add(*frame_);
    accumulator_->display(inputs.display, target());
    ++samples_;
    glFinish();
}

void Viewport::addSample(const Inputs& inputs, std::uint32_t sample, candela::Accumulator& sum) {
    frame_.reset();
    frame_.emplace(render(renderer_, inputs, sample));
    sum.add(*frame_);
}

candela::Frame Viewport::render(candela::Renderer& renderer, const Inputs& inputs,
                                std::uint32_t sample) const {
    candela::FrameSettings settings;
    settings.width = size_.x;
    settings.height = size_.y;
    settings.brdf = inputs.options.brdf;
    settings.technique = inputs.options.technique;
    settings.tileBackend = inputs.options.tileBackend;
    settings.shadows = inputs.options.shadows;
    settings.specularAntialiasing = inputs.options.specularAntialiasing;
    settings.layers = inputs.options.layers;
    settings.environmentOcclusion.rays = inputs.options.environmentRays;
    // A line of 1 pixel has gaps at a lower width.
    const auto scaled = [&](float pixels) {
        return std::max(pixels / static_cast<float>(inputs.divisor), std::min(pixels, 1.0f));
    };
    settings.pointSize = scaled(inputs.options.pointSize);
    settings.lineWidth = scaled(inputs.options.lineWidth);
    settings.debugView = inputs.options.debug.view;
    settings.overlays = inputs.options.debug.overlays;
    settings.sample = sample;
    return renderer.render(inputs.scene, inputs.view, settings);
}

candela::Frame Viewport::draw(candela::Renderer& renderer, const Inputs& inputs) {
    fullSize_ = {inputs.options.width, inputs.options.height};
    resize(glm::max(fullSize_ / inputs.divisor, 1));
    candela::Frame frame = render(renderer, inputs, 0);
    frame.display(inputs.display, target());
    return frame;
}

void Viewport::show(const glm::ivec2& windowSize, const glm::ivec2& corner, const glm::ivec2& size) const {
    constexpr std::array<float, 4> black{0.0f, 0.0f, 0.0f, 1.0f};
    glClearNamedFramebufferfv(0, GL_COLOR, 0, black.data());
    if (size_ == glm::ivec2(0) || size == glm::ivec2(0)) return;
    copy(windowSize, corner, size);
}

void Viewport::showLeft(const glm::ivec2& windowSize, const glm::ivec2& corner, const glm::ivec2& size,
                        int column) const {
    if (size_ == glm::ivec2(0) || column < 1) return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(corner.x, windowSize.y - corner.y - size.y, column, size.y);
    copy(windowSize, corner, size);
    glDisable(GL_SCISSOR_TEST);
}

void Viewport::copy(const glm::ivec2& windowSize, const glm::ivec2& corner, const glm::ivec2& size) const {
    const GLenum filter = size == size_ ? GL_NEAREST : GL_LINEAR;
    const int top = windowSize.y - corner.y;
    glBlitNamedFramebuffer(framebuffer_, 0, 0, 0, size_.x, size_.y, corner.x, top - size.y, corner.x + size.x,
                           top, GL_COLOR_BUFFER_BIT, filter);
}

glm::ivec2 Viewport::pixelAt(const glm::ivec2& pixel) const {
    return glm::clamp(pixel * size_ / fullSize_, glm::ivec2(0), size_ - 1);
}

glm::vec3 Viewport::displayValue(const glm::ivec2& pixel) const {
    const glm::ivec2 place = pixelAt(pixel);
    std::array<std::uint8_t, 4> value{};
    glGetTextureSubImage(texture_, 0, place.x, size_.y - 1 - place.y, 0, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                         static_cast<GLsizei>(value.size()), value.data());
    return glm::vec3(value[0], value[1], value[2]) / 255.0f;
}

void Viewport::reloadShaders(const std::optional<Inputs>& inputs) {
    candela::Renderer fresh(context_);
    // Most programs are compiled when they are first used.
    std::optional<candela::Frame> frame;
    if (inputs) frame.emplace(draw(fresh, *inputs));
    renderer_ = std::move(fresh);
    frame_ = std::move(frame);
    samples_ = frame_ ? 1 : 0;
    accumulator_.reset();
}

int ResolutionScale::divisor(Motion motion, Clock::time_point now) {
    if (motion == Motion::rests) {
        if (now - lastMotion_ >= rest) divisor_ = 1;
        return divisor_;
    }
    lastMotion_ = now;
    divisor_ = 1;
    while (divisor_ < maxDivisor && fullMilliseconds_ / (divisor_ * divisor_) > interactiveMilliseconds)
        divisor_ *= 2;
    return divisor_;
}
