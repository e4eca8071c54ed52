#include "render/layers/layer_pass.h"

#include "render/layout.h"

namespace candela {

namespace {

GLuint createQuery() {
    GLuint name = 0;
    glCreateQueries(GL_SAMPLES_PASSED, 1, &name);
    return name;
}

}  // namespace

LayerPass::Layer::Layer(int width, int height)
    : color(gl::Texture::target2d(GL_RGBA32F, width, height, "layer")),
      framebuffer({&color}, nullptr, "layer") {}

LayerPass::LayerPass()
    : store_({{"fullscreen_triangle.vert", {}, {}}, {"layer_store.frag", {}, {}}}, "layer store"),
      composite_({{"fullscreen_triangle.vert", {}, {}}, {"layer_composite.frag", {}, {}}}, "layer composite"),
      vertexArray_("layers"),
      query_(createQuery()) {}

void LayerPass::begin(int width, int height, const GBufferParts& parts, const gl::PixelRectangle& rectangle) {
    const bool sized = targets_[0] && targets_[0]->width == width && targets_[0]->height == height;
    if (!sized) layers_.clear();
    if (!sized || targets_[0]->parts != parts) {
        for (std::optional<GBufferTargets>& targets : targets_) targets.emplace(width, height, parts);
        rectangle_ = {};
    }
    // Passes that read whole targets find no surfaces of another rectangle.
    if (rectangle_ != rectangle) clearTargets();
    rectangle_ = rectangle;
}

void LayerPass::clearTargets() const {
    for (const std::optional<GBufferTargets>& targets : targets_) {
        targets->clearSurfaces();
        targets->clearRadiance();
    }
}

std::uint64_t LayerPass::keep(std::uint32_t index) {
    const GBufferTargets& from = targets(index);
    while (layers_.size() <= index) layers_.emplace_back(from.width, from.height);
    const Layer& layer = layers_[index];
    glBindTextureUnit(layout::LAYER_COLOR_UNIT, from.litRadiance().name());
    glBindTextureUnit(layout::LAYER_UNIT, from.words[from.indexOf(layout::LAYER_OUTPUT)].name());
    const gl::Scissor within(rectangle_);
    constexpr std::array<GLfloat, 4> nothing{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(layer.framebuffer.name(), GL_COLOR, 0, nothing.data());
    return countFragments([&] { drawTriangle(store_, layer.framebuffer); });
}

void LayerPass::composite(std::uint32_t count, const GBufferTargets& frame) const {
    frame.litRadiance();  // The layers are drawn over it.
    const gl::Scissor within(rectangle_);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (std::uint32_t i = count; i-- > 0;) {
        glBindTextureUnit(layout::LAYER_COLOR_UNIT, layers_[i].color.name());
        drawTriangle(composite_, frame.lit);
    }
    glDisable(GL_BLEND);
}

void LayerPass::drawTriangle(const gl::Program& program, const gl::Framebuffer& into) const {
    glUseProgram(program.name());
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, into.name());
    glViewport(0, 0, targets_[0]->width, targets_[0]->height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::uint64_t LayerPass::countFragments(const std::function<void()>& draw) const {
    glBeginQuery(GL_SAMPLES_PASSED, query_.name());
    draw();
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint64 count = 0;
    glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &count);
    return count;
}

}  // namespace candela
