#include "render/layers/layer_pass.h"

#include "render/layout.h"

#include <candela/error.h>

#include <algorithm>
#include <bit>

namespace candela {

namespace {

GLuint createQuery() {
    GLuint name = 0;
    glCreateQueries(GL_SAMPLES_PASSED, 1, &name);
    return name;
}

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

LayerPass::LayerPass() : vertexArray_("layers"), query_(createQuery()) {}

void LayerPass::begin(int width, int height, const GBufferParts& parts, const gl::PixelRectangle& rectangle,
                      BrdfModel model) {
    model_ = model;
    const bool sized = targets_[0] && targets_[0]->width == width && targets_[0]->height == height;
    if (!sized) backdrop_.reset();
    if (!sized || targets_[0]->parts != parts) {
        layers_.clear();
        for (std::optional<GBufferTargets>& targets : targets_) targets.emplace(width, height, parts);
        rectangle_ = {};
    }
    // Passes that read whole targets find no surfaces of another rectangle.
    if (rectangle_ != rectangle) {
        for (const std::optional<GBufferTargets>& targets : targets_) {
            targets->clearSurfaces();
            targets->clearRadiance();
        }
    }
    rectangle_ = rectangle;
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

std::uint64_t LayerPass::keep(std::uint32_t index) {
    const GBufferTargets& from = targets(index);
    while (layers_.size() <= index) layers_.emplace_back(from.width, from.height, from.parts);
    const Layer& layer = layers_[index];
    from.bind();
    glBindTextureUnit(layout::LAYER_COLOR_UNIT, from.litRadiance().name());
    const gl::Scissor within(rectangle_);
    constexpr std::array<GLfloat, 4> nothing{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(layer.framebuffer.name(), GL_COLOR, 0, nothing.data());
    const gl::Program& program = programOf("layer_store.frag", Backdrop::none);
    return countFragments([&] { drawTriangle(program, layer.framebuffer); });
}

void LayerPass::copyBackdrop(const gl::Texture& radiance, Backdrop backdrop) {
    const int width = targets_[0]->width, height = targets_[0]->height;
    if (!backdrop_) backdrop_.emplace(makeBackdrop(width, height));
    glCopyImageSubData(radiance.name(), GL_TEXTURE_2D, 0, 0, 0, 0, backdrop_->name(), GL_TEXTURE_2D, 0, 0, 0,
                       0, width, height, 1);
    if (backdrop >= Backdrop::blurred) glGenerateTextureMipmap(backdrop_->name());
    glBindTextureUnit(layout::BEHIND_UNIT, backdrop_->name());
}

void LayerPass::composite(std::uint32_t count, const GBufferTargets& frame, Backdrop backdrop) {
    const gl::Texture& radiance = frame.litRadiance();  // The layers are drawn over it.
    glBindTextureUnit(layout::OPAQUE_DEPTH_UNIT, frame.depth.name());
    const gl::Program& program = programOf("layer_composite.frag", backdrop);
    for (std::uint32_t i = count; i-- > 0;) {
        if (backdrop != Backdrop::none) copyBackdrop(radiance, backdrop);
        if (refracts()) glBindTextureUnit(layout::LAYER_REFRACTION_UNIT, layers_[i].seenThrough.name());
        glBindTextureUnit(layout::LAYER_COLOR_UNIT, layers_[i].color.name());
        const gl::Scissor within(rectangle_);
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
    glViewport(0, 0, targets_[0]->width, targets_[0]->height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::uint64_t LayerPass::countFragments(const std::function<void()>& draw) const {
    GLint active = 0;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &active);
    if (active != 0) {
        throw Error(ErrorKind::badInput, "",
                    "a query of GL_SAMPLES_PASSED is active while transparent surfaces are drawn, whose "
                    "fragments are counted by one; the host has to end it before");
    }
    glBeginQuery(GL_SAMPLES_PASSED, query_.name());
    draw();
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint64 count = 0;
    glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &count);
    return count;
}

}  // namespace candela
