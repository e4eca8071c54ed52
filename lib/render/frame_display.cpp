#include "render/renderer_state.h"

namespace candela {

void Renderer::State::displayFrame(const DisplayTransform& transform, const FrameTarget& target) {
    const FrameSettings& settings = frame->settings;
    const gl::PassTimer::Scope pass(timer, "display");
    const MemoryPicture picture = pictureInMemory();
    if (settings.debugView != DebugView::none) {
        debugView->display(*targets, target);
    } else if (!picture.radiance.empty() && MemoryDisplay::suits(target)) {
        memoryDisplay.render(picture, transform, target);
    } else {
        display.render({targets->litRadiance(),
                        settings.width,
                        settings.height,
                        transform,
                        target,
                        {frame->pixels.left, frame->pixels.bottom}});
    }
    if (hasLines(settings.overlays)) overlays->display(target);
}

std::vector<std::uint8_t> Renderer::State::displayPicture(const DisplayTransform& transform) {
    const MemoryPicture picture = pictureInMemory();
    if (!picture.radiance.empty() && !hasLines(frame->settings.overlays)) {
        const gl::PassTimer::Scope pass(timer, "display");
        return memoryDisplay.codes(picture, transform);
    }
    return shownTarget(transform).read();
}

const DisplayTarget& Renderer::State::shownTarget(const DisplayTransform& transform) {
    if (!displayTarget) displayTarget.emplace(targets->width, targets->height);
    displayFrame(transform, {.framebuffer = displayTarget->framebuffer.name()});
    return *displayTarget;
}

}  // namespace candela
