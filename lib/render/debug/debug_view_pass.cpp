#include "render/debug/debug_view_pass.h"

#include "render/debug/color_scales.h"
#include "render/layout.h"

#include <glm/gtc/type_ptr.hpp>

#include <string>
#include <vector>

namespace candela {

namespace {

const char* definitionOf(DebugView debugView) {
    switch (debugView) {
        case DebugView::normals:
            return "SHOW SHOW_NORMALS";
        case DebugView::level:
            return "SHOW SHOW_LEVEL";
        case DebugView::baseColor:
            return "SHOW SHOW_BASE_COLOR";
        case DebugView::metallic:
            return "SHOW SHOW_METALLIC";
        case DebugView::roughness:
            return "SHOW SHOW_ROUGHNESS";
        case DebugView::depth:
            return "SHOW SHOW_DEPTH";
        case DebugView::emission:
            return "SHOW SHOW_EMISSION";
        default:
            return "SHOW SHOW_LIGHT_COUNT";
    }
}

gl::Program makeProgram(DebugView debugView) {
    const std::string heatStopCount = "HEAT_STOPS " + std::to_string(heatStops.size());
    gl::Program program(
        {{"fullscreen_triangle.vert", {}, {}}, {"debug_view.frag", {definitionOf(debugView), heatStopCount}, {}}},
        toString(debugView));
    if (debugView == DebugView::lightCount) {
        glProgramUniform3fv(program.name(), layout::HEAT_STOPS_LOCATION,
                            static_cast<GLsizei>(heatStops.size()), glm::value_ptr(heatStops[0]));
    }
    return program;
}

void drawPicture(const gl::VertexArray& vertexArray) {
    glBindVertexArray(vertexArray.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

DebugViewPass::DebugViewPass()
    : display_({{"fullscreen_triangle.vert", {}, {}}, {"debug_view_display.frag", {}, {}}}, "data display"),
      vertexArray_("data view"),
      instanceColors_(GL_RGBA32F, "instance colors") {}

const gl::Program& DebugViewPass::program(DebugView debugView) {
    auto found = programs_.find(debugView);
    if (found == programs_.end()) found = programs_.emplace(debugView, makeProgram(debugView)).first;
    return found->second;
}

void DebugViewPass::prepareLevels(const Inputs& inputs) {
    const GBufferTargets& targets = inputs.frame.targets;
    std::vector<glm::vec4> colors;
    for (std::uint32_t i = 0; i < inputs.scene.instances.size(); ++i) {
        const std::optional<std::uint32_t> level = inputs.scene.levelOf(i);
        colors.emplace_back(level ? levelColor(*level) : meshColor, 0.0f);
    }
    instanceColors_.upload(std::span<const glm::vec4>(colors));
    const gl::Texture& instances =
        inputs.instances.render({inputs.scene, inputs.draws, targets.width, targets.height});
    glBindTextureUnit(layout::SHOWN_UNIT, instances.name());
    glBindTextureUnit(layout::INSTANCE_COLORS_UNIT, instanceColors_.name());
}

void DebugViewPass::prepare(const Inputs& inputs) {
    const GBufferTargets& targets = inputs.frame.targets;
    if (inputs.debugView == DebugView::level) prepareLevels(inputs);
    if (inputs.debugView == DebugView::depth) maxReduction_.find(targets.depth, targets.width, targets.height);
    if (inputs.debugView == DebugView::lightCount) {
        const gl::Texture& counts = inputs.lighting.counter().drawLit(inputs.frame);
        maxReduction_.find(counts, targets.width, targets.height);
    }
    if (inputs.debugView == DebugView::emission) {
        glBindTextureUnit(layout::SHOWN_UNIT, targets.radiance.name());
        glTextureBarrier();
    }
}

void DebugViewPass::render(const Inputs& inputs) {
    prepare(inputs);
    const GBufferTargets& targets = inputs.frame.targets;
    glBindTextureUnit(layout::SURFACE_UNIT, targets.surface.name());
    glBindTextureUnit(layout::DEPTH_UNIT, targets.depth.name());
    glUseProgram(program(inputs.debugView).name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.lit.name());
    glViewport(0, 0, targets.width, targets.height);
    drawPicture(vertexArray_);
}

std::uint32_t DebugViewPass::maxLightCount() const {
    return static_cast<std::uint32_t>(maxReduction_.value());
}

void DebugViewPass::display(const GBufferTargets& targets, const FrameTarget& target) const {
    glUseProgram(display_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    glViewport(target.x, target.y, targets.width, targets.height);
    glBindTextureUnit(layout::RADIANCE_UNIT, targets.radiance.name());
    glUniform2i(layout::ORIGIN_LOCATION, target.x, target.y);
    drawPicture(vertexArray_);
}

}  // namespace candela
