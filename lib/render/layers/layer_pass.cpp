#include "render/layers/layer_pass.h"

#include "render/layout.h"

#include <algorithm>
#include <bit>

namespace candela {

namespace {

std::vector<const gl::Texture*> attachmentsOf(const gl::Texture& color, const gl::Texture& seenThrough) {
    if (seenThrough.name() == 0) return {&color};
    return {&color, &seenThrough};
}

gl::Texture makeBackdrop(int width, int height) {
    gl::Texture texture(GL_TEXTURE_2D, "backdrop");
    const int levels = std::bit_width(static_cast<unsigned>(std::max(width, height)));
    glTextureStorage2D(texture.name(), levels, GL_RGBA32F, width, height);
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

LayerPass::Layer::Layer(int width, int height, const GBufferParts& parts)
    : color(gl::Texture::target2d(GL_RGBA32F, width, height, "layer")),
      seenThrough(parts.refraction ? gl::Texture::target2d(GL_RGBA32UI, width, height, "layer refraction")
                                   : gl::Texture{}),
      framebuffer(attachmentsOf(color, seenThrough), nullptr, "layer") {}

LayerPass::LayerPass() : vertexArray_("layers") {}

void LayerPass::begin(int width, int height, const GBufferParts& parts, BrdfModel model) {
    model_ = model;
    const bool sized = targets_ && targets_->width == width && targets_->height == height;
    if (!sized) backdrop_.reset();
    if (sized && targets_->parts == parts) return;
    layers_.clear();
    targets_.reset();
    targets_.emplace(width, height, parts);
    targets_->clearRadiance();
    written_ = {0, 0, width, height};
}

const GBufferTargets& LayerPass::clear(const gl::PixelRectangle& rectangle) {
    // Passes that read more than the rectangle find no surfaces of another layer.
    const gl::Scissor within(written_);
    targets_->clearSurfaces();
    written_ = rectangle;
    return *targets_;
}

const gl::Program& LayerPass::programOf(const char* file, Backdrop backdrop) {
    std::vector<std::string> definitions;
    if (refracts()) {
        definitions = {"REFRACTION 1", "LOBES 1",
                       model_ == BrdfModel::course ? "BRDF BRDF_COURSE" : "BRDF BRDF_GLTF"};
    }
    // Shaders of software devices take every branch.
    if (backdrop >= Backdrop::blurred) definitions.emplace_back("BLURRED 1");
    if (backdrop == Backdrop::dispersed) definitions.emplace_back("DISPERSED 1");
    std::string name = file;
    for (const std::string& definition : definitions) name += " " + definition;
    const auto found = programs_.find(name);
    if (found != programs_.end()) return found->second;
    return programs_
        .try_emplace(
            name, std::vector<gl::Stage>{{"fullscreen_triangle.vert", {}, {}}, {file, definitions, {}}}, file)
        .first->second;
}

void LayerPass::keep(std::uint32_t index, const gl::PixelRectangle& rectangle) {
    const GBufferTargets& from = *targets_;
    while (layers_.size() <= index) layers_.emplace_back(from.width, from.height, from.parts);
    Layer& layer = layers_[index];
    layer.rectangle = rectangle;
    from.bind();
    glBindTextureUnit(layout::LAYER_COLOR_UNIT, from.litRadiance().name());
    const gl::Scissor within(rectangle);
    constexpr std::array<GLfloat, 4> nothing{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(layer.framebuffer.name(), GL_COLOR, 0, nothing.data());
    const gl::Program& program = programOf("layer_store.frag", Backdrop::none);
    drawTriangle(program, layer.framebuffer);
}

void LayerPass::copyBackdrop(const GBufferTargets& frame, const gl::PixelRectangle& part, Backdrop backdrop,
                             const DrawBehind& drawBehind) {
    if (!backdrop_) backdrop_.emplace(makeBackdrop(frame.width, frame.height));
    glCopyImageSubData(frame.radiance.name(), GL_TEXTURE_2D, 0, part.x, part.y, 0, backdrop_->name(),
                       GL_TEXTURE_2D, 0, part.x, part.y, 0, part.width, part.height, 1);
    if (drawBehind) {
        const gl::Framebuffer picture({&*backdrop_}, &frame.depth, "backdrop");
        const gl::Scissor within(part);
        drawBehind(picture);
    }
    if (backdrop >= Backdrop::blurred) glGenerateTextureMipmap(backdrop_->name());
    glBindTextureUnit(layout::BEHIND_UNIT, backdrop_->name());
}

void LayerPass::composite(std::uint32_t count, const GBufferTargets& frame, Backdrop backdrop,
                          const DrawBehind& drawBehind) {
    frame.takeLitRadiance();  // The layers are drawn over it.
    glBindTextureUnit(layout::OPAQUE_DEPTH_UNIT, frame.depth.name());
    const gl::Program& program = programOf("layer_composite.frag", backdrop);
    for (std::uint32_t i = count; i-- > 0;) {
        if (backdrop != Backdrop::none) {
            // The whole picture for the farthest layer, then what the one behind has changed.
            const gl::PixelRectangle whole{0, 0, frame.width, frame.height};
            copyBackdrop(frame, i + 1 == count ? whole : layers_[i + 1].rectangle, backdrop, drawBehind);
        }
        if (refracts()) glBindTextureUnit(layout::LAYER_REFRACTION_UNIT, layers_[i].seenThrough.name());
        glBindTextureUnit(layout::LAYER_COLOR_UNIT, layers_[i].color.name());
        const gl::Scissor within(layers_[i].rectangle);
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        drawTriangle(program, frame.lit);
        glDisable(GL_BLEND);
    }
}

void LayerPass::drawTriangle(const gl::Program& program, const gl::Framebuffer& into) const {
    glUseProgram(program.name());
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, into.name());
    glViewport(0, 0, targets_->width, targets_->height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace candela
