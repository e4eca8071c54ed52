#include "render/debug/overlay_pass.h"

#include "render/layout.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>

namespace candela {

namespace {

// Medium lightness and strong hue stand out on dark and on light surfaces. Code values.
constexpr glm::vec3 wireframeColor(0.10f, 0.55f, 1.00f);
constexpr glm::vec3 cageColor(1.00f, 0.45f, 0.05f);

gl::Program makeProgram(const char* vertexFile, const char* corners, const char* label) {
    return gl::Program(
        {{vertexFile, {}, {}}, {"overlay_edges.geom", {corners}, {}}, {"overlay_lines.frag", {}, {}}}, label);
}

void setColor(const glm::vec3& color) {
    glUniform3fv(layout::LINE_COLOR_LOCATION, 1, glm::value_ptr(color));
}

}  // namespace

OverlayPass::Target::Target(int pixelsWide, int pixelsHigh)
    : width(pixelsWide),
      height(pixelsHigh),
      texture(gl::Texture::target2d(GL_RGBA8, width, height, "overlays")),
      framebuffer({&texture}, nullptr, "overlays") {}

OverlayPass::OverlayPass()
    : meshEdges_(makeProgram("overlay_mesh.vert", "CORNERS 3", "mesh edges")),
      cageLines_(makeProgram("overlay_cage.vert", "CORNERS 2", "cage lines")),
      display_({{"fullscreen_triangle.vert", {}, {}}, {"overlay_display.frag", {}, {}}}, "overlay display"),
      vertexArray_("overlay display") {}

void OverlayPass::render(const Inputs& inputs) {
    begin(inputs.targets);
    glBindTextureUnit(layout::INSTANCES_UNIT, inputs.scene.instances.records().name());
    glBindTextureUnit(layout::DEPTH_UNIT, inputs.targets.depth.name());
    if (inputs.overlays.wireframe) {
        drawMeshEdges(inputs);
        drawCageLines(inputs, CageLineKind::faceEdges, wireframeColor);
    }
    if (inputs.overlays.cage) drawCageLines(inputs, CageLineKind::cageEdges, cageColor);
}

void OverlayPass::begin(const GBufferTargets& targets) {
    const bool fits = target_ && target_->width == targets.width && target_->height == targets.height;
    if (!fits) target_.emplace(targets.width, targets.height);
    constexpr std::array<GLfloat, 4> nothing{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(target_->framebuffer.name(), GL_COLOR, 0, nothing.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_->framebuffer.name());
    glViewport(0, 0, targets.width, targets.height);
}

void OverlayPass::drawMeshEdges(const Inputs& inputs) const {
    glUseProgram(meshEdges_.name());
    setColor(wireframeColor);
    inputs.draws.bind();
    for (const DrawBatch& batch : inputs.draws.batches()) {
        if (batch.key.geometry.kind == DrawGeometry::Kind::cage) continue;
        if (batch.key.topology != Topology::triangles) continue;
        glBindVertexArray(inputs.scene.vertexArrayOf(batch.key));
        DrawSelection::draw(batch);
    }
}

void OverlayPass::drawCageLines(const Inputs& inputs, CageLineKind kind, const glm::vec3& color) {
    drawnLines_.clear();
    inputs.scene.appendLines(kind, inputs.draws, drawnLines_);
    glUseProgram(cageLines_.name());
    setColor(color);
    for (const CageLines& lines : drawnLines_) {
        glBindVertexArray(lines.vertexArray);
        glUniform1ui(layout::LINE_INSTANCE_LOCATION, lines.instance);
        glDrawElements(GL_LINES, lines.indexCount, GL_UNSIGNED_INT, nullptr);
    }
}

void OverlayPass::display(const FrameTarget& target) const {
    glUseProgram(display_.name());
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    glViewport(target.x, target.y, target_->width, target_->height);
    glBindTextureUnit(layout::OVERLAY_UNIT, target_->texture.name());
    glUniform2i(layout::ORIGIN_LOCATION, target.x, target.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace candela
