#include "gl/state_guard.h"

namespace candela::gl {

namespace {

// Blending and the scissor test stand elsewhere: they are switched for each draw buffer and viewport.
constexpr std::array<GLenum, 28> capabilityNames{
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_STENCIL_TEST,
    GL_DEPTH_CLAMP,
    GL_FRAMEBUFFER_SRGB,
    GL_RASTERIZER_DISCARD,
    GL_COLOR_LOGIC_OP,
    GL_DITHER,
    GL_PRIMITIVE_RESTART,
    GL_PRIMITIVE_RESTART_FIXED_INDEX,
    GL_POLYGON_OFFSET_FILL,
    // llvmpipe offsets filled polygons too where one of these is on.
    GL_POLYGON_OFFSET_LINE,
    GL_POLYGON_OFFSET_POINT,
    GL_POLYGON_SMOOTH,
    GL_LINE_SMOOTH,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
    GL_SAMPLE_MASK,
    GL_SAMPLE_SHADING,
    GL_CLIP_DISTANCE0,
    GL_CLIP_DISTANCE1,
    GL_CLIP_DISTANCE2,
    GL_CLIP_DISTANCE3,
    GL_CLIP_DISTANCE4,
    GL_CLIP_DISTANCE5,
    GL_CLIP_DISTANCE6,
    GL_CLIP_DISTANCE7,
};
constexpr std::array<GLenum, 6> blendNames{GL_BLEND_SRC_RGB,      GL_BLEND_DST_RGB,
                                           GL_BLEND_SRC_ALPHA,    GL_BLEND_DST_ALPHA,
                                           GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
constexpr std::array<GLenum, 7> stencilFrontNames{GL_STENCIL_FUNC,
                                                  GL_STENCIL_REF,
                                                  GL_STENCIL_VALUE_MASK,
                                                  GL_STENCIL_FAIL,
                                                  GL_STENCIL_PASS_DEPTH_FAIL,
                                                  GL_STENCIL_PASS_DEPTH_PASS,
                                                  GL_STENCIL_WRITEMASK};
constexpr std::array<GLenum, 7> stencilBackNames{GL_STENCIL_BACK_FUNC,
                                                 GL_STENCIL_BACK_REF,
                                                 GL_STENCIL_BACK_VALUE_MASK,
                                                 GL_STENCIL_BACK_FAIL,
                                                 GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                                                 GL_STENCIL_BACK_PASS_DEPTH_PASS,
                                                 GL_STENCIL_BACK_WRITEMASK};
constexpr std::array<GLenum, 14> packingNames{
    GL_PACK_ALIGNMENT,    GL_UNPACK_ALIGNMENT,    GL_PACK_ROW_LENGTH,  GL_UNPACK_ROW_LENGTH,
    GL_PACK_IMAGE_HEIGHT, GL_UNPACK_IMAGE_HEIGHT, GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS,
    GL_PACK_SKIP_ROWS,    GL_UNPACK_SKIP_ROWS,    GL_PACK_SKIP_IMAGES, GL_UNPACK_SKIP_IMAGES,
    GL_PACK_SWAP_BYTES,   GL_UNPACK_SWAP_BYTES,
};
/// What candela reads and writes pixels with: tightly packed rows.
constexpr std::array<GLint, 14> packingDefaults{1, 1};

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void setEnabled(GLenum capability, GLboolean enabled) {
    if (enabled == GL_TRUE) {
        glEnable(capability);
    } else {
        glDisable(capability);
    }
}

void setEnabled(GLenum capability, GLuint index, GLboolean enabled) {
    if (enabled == GL_TRUE) {
        glEnablei(capability, index);
    } else {
        glDisablei(capability, index);
    }
}

void restoreStencil(GLenum face, const std::array<GLint, 7>& stencil) {
    glStencilFuncSeparate(face, stencil[0], stencil[1], stencil[2]);
    glStencilOpSeparate(face, stencil[3], stencil[4], stencil[5]);
    glStencilMaskSeparate(face, stencil[6]);
}

template <typename Indexed>
void keepIndexed(Indexed& kept, GLenum binding, GLenum start, GLenum size, GLuint index) {
    glGetIntegeri_v(binding, index, &kept.buffer);
    glGetInteger64i_v(start, index, &kept.start);
    glGetInteger64i_v(size, index, &kept.size);
}

template <typename Indexed>
void restoreIndexed(const Indexed& kept, GLenum target, GLuint index) {
    if (kept.size > 0) {
        glBindBufferRange(target, index, kept.buffer, kept.start, kept.size);
    } else {
        glBindBufferBase(target, index, kept.buffer);
    }
}

}  // namespace

StateGuard::StateGuard(const ContextBinding& binding, const char* user) : restores_(!binding.isOwned()) {
    binding.requireCurrent(user);
    if (restores_) {
        keepCapabilities();
        keepBindings();
        keepFixedFunction();
        keepDrawBuffers();
        keepViewports();
    }
    setDefaults();
}

void StateGuard::setDefaults() {
    for (const GLenum capability : capabilityNames) glDisable(capability);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    for (std::size_t i = 0; i < packingNames.size(); ++i) glPixelStorei(packingNames[i], packingDefaults[i]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_QUERY_BUFFER, 0);
    glBindProgramPipeline(0);
    glBindSamplers(0, textureUnits, nullptr);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glStencilMask(0xff);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    // Rasterisers may start a triangle at this vertex: with another one depths differ in the last place.
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    glDepthRangef(0.0f, 1.0f);
    glLineWidth(1.0f);
    glBlendEquation(GL_FUNC_ADD);
    // Depth from 0 to 1: reversed depth needs the float format's precision near 0.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

StateGuard::~StateGuard() {
    if (!restores_) return;
    restoreCapabilities();
    restoreBindings();
    restoreFixedFunction();
    restoreDrawBuffers();
    restoreViewports();
}

void StateGuard::keepCapabilities() {
    for (std::size_t i = 0; i < capabilityNames.size(); ++i)
        capabilities_[i] = glIsEnabled(capabilityNames[i]);
}

void StateGuard::restoreCapabilities() const {
    for (std::size_t i = 0; i < capabilityNames.size(); ++i) setEnabled(capabilityNames[i], capabilities_[i]);
}

void StateGuard::keepBindings() {
    program_ = integer(GL_CURRENT_PROGRAM);
    pipeline_ = integer(GL_PROGRAM_PIPELINE_BINDING);
    vertexArray_ = integer(GL_VERTEX_ARRAY_BINDING);
    drawFramebuffer_ = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer_ = integer(GL_READ_FRAMEBUFFER_BINDING);
    arrayBuffer_ = integer(GL_ARRAY_BUFFER_BINDING);
    indirectBuffer_ = integer(GL_DRAW_INDIRECT_BUFFER_BINDING);
    dispatchBuffer_ = integer(GL_DISPATCH_INDIRECT_BUFFER_BINDING);
    packBuffer_ = integer(GL_PIXEL_PACK_BUFFER_BINDING);
    unpackBuffer_ = integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
    queryBuffer_ = integer(GL_QUERY_BUFFER_BINDING);
    activeTexture_ = integer(GL_ACTIVE_TEXTURE);
    for (int i = 0; i < textureUnits; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        units_[static_cast<std::size_t>(i)] = {
            integer(GL_TEXTURE_BINDING_1D),       integer(GL_TEXTURE_BINDING_2D),
            integer(GL_TEXTURE_BINDING_3D),       integer(GL_TEXTURE_BINDING_BUFFER),
            integer(GL_TEXTURE_BINDING_2D_ARRAY), integer(GL_SAMPLER_BINDING)};
    }
    glActiveTexture(static_cast<GLenum>(activeTexture_));
    uniformBuffer_ = integer(GL_UNIFORM_BUFFER_BINDING);
    storageBuffer_ = integer(GL_SHADER_STORAGE_BUFFER_BINDING);
    for (GLuint i = 0; i < uniformBindings; ++i) {
        keepIndexed(uniforms_[i], GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
                    i);
    }
    for (GLuint i = 0; i < storageBindings; ++i) {
        keepIndexed(storage_[i], GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
                    GL_SHADER_STORAGE_BUFFER_SIZE, i);
    }
    for (GLuint i = 0; i < imageUnits; ++i) {
        glGetIntegeri_v(GL_IMAGE_BINDING_NAME, i, &images_[i].name);
        glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, i, &images_[i].level);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, i, &images_[i].layered);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, i, &images_[i].layer);
        glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, i, &images_[i].access);
        glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, i, &images_[i].format);
    }
}

void StateGuard::restoreBindings() const {
    glUseProgram(program_);
    glBindProgramPipeline(pipeline_);
    glBindVertexArray(vertexArray_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawFramebuffer_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, readFramebuffer_);
    glBindBuffer(GL_ARRAY_BUFFER, arrayBuffer_);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, indirectBuffer_);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, dispatchBuffer_);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, packBuffer_);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, unpackBuffer_);
    glBindBuffer(GL_QUERY_BUFFER, queryBuffer_);
    for (int i = 0; i < textureUnits; ++i) {
        const TextureUnit& unit = units_[static_cast<std::size_t>(i)];
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_1D, unit.texture1d);
        glBindTexture(GL_TEXTURE_2D, unit.texture2d);
        glBindTexture(GL_TEXTURE_3D, unit.texture3d);
        glBindTexture(GL_TEXTURE_BUFFER, unit.textureBuffer);
        glBindTexture(GL_TEXTURE_2D_ARRAY, unit.texture2dArray);
        glBindSampler(i, unit.sampler);
    }
    glActiveTexture(static_cast<GLenum>(activeTexture_));
    for (GLuint i = 0; i < uniformBindings; ++i) restoreIndexed(uniforms_[i], GL_UNIFORM_BUFFER, i);
    for (GLuint i = 0; i < storageBindings; ++i) restoreIndexed(storage_[i], GL_SHADER_STORAGE_BUFFER, i);
    glBindBuffer(GL_UNIFORM_BUFFER, uniformBuffer_);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, storageBuffer_);
    for (GLuint i = 0; i < imageUnits; ++i) {
        const ImageUnit& image = images_[i];
        glBindImageTexture(i, image.name, image.level, image.layered != 0 ? GL_TRUE : GL_FALSE, image.layer,
                           static_cast<GLenum>(image.access), static_cast<GLenum>(image.format));
    }
}

void StateGuard::keepFixedFunction() {
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clearColor_.data());
    for (std::size_t i = 0; i < stencilFront_.size(); ++i) {
        stencilFront_[i] = integer(stencilFrontNames[i]);
        stencilBack_[i] = integer(stencilBackNames[i]);
    }
    for (std::size_t i = 0; i < packing_.size(); ++i) packing_[i] = integer(packingNames[i]);
    clipControl_ = {integer(GL_CLIP_ORIGIN), integer(GL_CLIP_DEPTH_MODE)};
    depthFunction_ = integer(GL_DEPTH_FUNC);
    cullFace_ = integer(GL_CULL_FACE_MODE);
    frontFace_ = integer(GL_FRONT_FACE);
    provokingVertex_ = integer(GL_PROVOKING_VERTEX);
    glGetFloatv(GL_LINE_WIDTH, &lineWidth_);
    // Some drivers still write one value for each face, as older versions of GL did.
    std::array<GLint, 2> polygonMode{};
    glGetIntegerv(GL_POLYGON_MODE, polygonMode.data());
    polygonMode_ = polygonMode[0];
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
}

void StateGuard::restoreFixedFunction() const {
    glClearColor(clearColor_[0], clearColor_[1], clearColor_[2], clearColor_[3]);
    restoreStencil(GL_FRONT, stencilFront_);
    restoreStencil(GL_BACK, stencilBack_);
    for (std::size_t i = 0; i < packingNames.size(); ++i) glPixelStorei(packingNames[i], packing_[i]);
    glClipControl(clipControl_[0], clipControl_[1]);
    glDepthFunc(depthFunction_);
    glCullFace(cullFace_);
    glFrontFace(frontFace_);
    glProvokingVertex(provokingVertex_);
    glLineWidth(lineWidth_);
    glPolygonMode(GL_FRONT_AND_BACK, polygonMode_);
    glDepthMask(depthMask_);
}

void StateGuard::keepDrawBuffers() {
    for (GLuint i = 0; i < drawBuffers; ++i) {
        DrawBuffer& buffer = drawBuffers_[i];
        buffer.blend = glIsEnabledi(GL_BLEND, i);
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, buffer.colorMask.data());
        for (std::size_t j = 0; j < blendNames.size(); ++j)
            glGetIntegeri_v(blendNames[j], i, &buffer.factors[j]);
    }
}

void StateGuard::restoreDrawBuffers() const {
    for (GLuint i = 0; i < drawBuffers; ++i) {
        const DrawBuffer& buffer = drawBuffers_[i];
        setEnabled(GL_BLEND, i, buffer.blend);
        glColorMaski(i, buffer.colorMask[0], buffer.colorMask[1], buffer.colorMask[2], buffer.colorMask[3]);
        glBlendFuncSeparatei(i, buffer.factors[0], buffer.factors[1], buffer.factors[2], buffer.factors[3]);
        glBlendEquationSeparatei(i, buffer.factors[4], buffer.factors[5]);
    }
}

void StateGuard::keepViewports() {
    for (GLuint i = 0; i < viewports; ++i) {
        Viewport& viewport = viewports_[i];
        viewport.scissor = glIsEnabledi(GL_SCISSOR_TEST, i);
        glGetFloati_v(GL_VIEWPORT, i, viewport.rectangle.data());
        glGetDoublei_v(GL_DEPTH_RANGE, i, viewport.depthRange.data());
        glGetIntegeri_v(GL_SCISSOR_BOX, i, viewport.scissorBox.data());
    }
}

void StateGuard::restoreViewports() const {
    for (GLuint i = 0; i < viewports; ++i) {
        const Viewport& viewport = viewports_[i];
        setEnabled(GL_SCISSOR_TEST, i, viewport.scissor);
        glViewportIndexedfv(i, viewport.rectangle.data());
        glDepthRangeIndexed(i, viewport.depthRange[0], viewport.depthRange[1]);
        glScissorIndexedv(i, viewport.scissorBox.data());
    }
}

}  // namespace candela::gl
