#include "gl_state.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

namespace candela::test {

namespace {

struct Name {
    const char* text;
    GLenum name;
    int values = 1;
};

#define CANDELA_NAME(NAME, ...) \
    { #NAME, GL_##NAME __VA_OPT__(, ) __VA_ARGS__ }

constexpr Name capabilities[] = {
    CANDELA_NAME(BLEND),
    CANDELA_NAME(CLIP_DISTANCE0),
    CANDELA_NAME(CLIP_DISTANCE5),
    CANDELA_NAME(COLOR_LOGIC_OP),
    CANDELA_NAME(CULL_FACE),
    CANDELA_NAME(DEPTH_CLAMP),
    CANDELA_NAME(DEPTH_TEST),
    CANDELA_NAME(DITHER),
    CANDELA_NAME(FRAMEBUFFER_SRGB),
    CANDELA_NAME(LINE_SMOOTH),
    CANDELA_NAME(MULTISAMPLE),
    CANDELA_NAME(POLYGON_OFFSET_FILL),
    CANDELA_NAME(POLYGON_OFFSET_LINE),
    CANDELA_NAME(POLYGON_OFFSET_POINT),
    CANDELA_NAME(POLYGON_SMOOTH),
    CANDELA_NAME(PRIMITIVE_RESTART),
    CANDELA_NAME(PRIMITIVE_RESTART_FIXED_INDEX),
    CANDELA_NAME(PROGRAM_POINT_SIZE),
    CANDELA_NAME(RASTERIZER_DISCARD),
    CANDELA_NAME(SAMPLE_ALPHA_TO_COVERAGE),
    CANDELA_NAME(SAMPLE_ALPHA_TO_ONE),
    CANDELA_NAME(SAMPLE_COVERAGE),
    CANDELA_NAME(SAMPLE_MASK),
    CANDELA_NAME(SAMPLE_SHADING),
    CANDELA_NAME(SCISSOR_TEST),
    CANDELA_NAME(STENCIL_TEST),
    CANDELA_NAME(TEXTURE_CUBE_MAP_SEAMLESS),
    CANDELA_NAME(DEBUG_OUTPUT),
};

constexpr Name numbers[] = {
    CANDELA_NAME(ACTIVE_TEXTURE),
    CANDELA_NAME(ARRAY_BUFFER_BINDING),
    CANDELA_NAME(ATOMIC_COUNTER_BUFFER_BINDING),
    CANDELA_NAME(BLEND_COLOR, 4),
    CANDELA_NAME(CLIP_DEPTH_MODE),
    CANDELA_NAME(CLIP_ORIGIN),
    CANDELA_NAME(COLOR_CLEAR_VALUE, 4),
    CANDELA_NAME(COPY_READ_BUFFER_BINDING),
    CANDELA_NAME(COPY_WRITE_BUFFER_BINDING),
    CANDELA_NAME(CULL_FACE_MODE),
    CANDELA_NAME(CURRENT_PROGRAM),
    CANDELA_NAME(DEBUG_GROUP_STACK_DEPTH),
    CANDELA_NAME(DEPTH_CLEAR_VALUE),
    CANDELA_NAME(DEPTH_FUNC),
    CANDELA_NAME(DEPTH_WRITEMASK),
    CANDELA_NAME(DISPATCH_INDIRECT_BUFFER_BINDING),
    CANDELA_NAME(DRAW_BUFFER0),
    CANDELA_NAME(DRAW_BUFFER1),
    CANDELA_NAME(DRAW_FRAMEBUFFER_BINDING),
    CANDELA_NAME(DRAW_INDIRECT_BUFFER_BINDING),
    CANDELA_NAME(FRONT_FACE),
    CANDELA_NAME(LINE_WIDTH),
    CANDELA_NAME(LOGIC_OP_MODE),
    CANDELA_NAME(MIN_SAMPLE_SHADING_VALUE),
    CANDELA_NAME(PACK_ALIGNMENT),
    CANDELA_NAME(PACK_IMAGE_HEIGHT),
    CANDELA_NAME(PACK_LSB_FIRST),
    CANDELA_NAME(PACK_ROW_LENGTH),
    CANDELA_NAME(PACK_SKIP_IMAGES),
    CANDELA_NAME(PACK_SKIP_PIXELS),
    CANDELA_NAME(PACK_SKIP_ROWS),
    CANDELA_NAME(PACK_SWAP_BYTES),
    CANDELA_NAME(PATCH_VERTICES),
    CANDELA_NAME(PIXEL_PACK_BUFFER_BINDING),
    CANDELA_NAME(PIXEL_UNPACK_BUFFER_BINDING),
    CANDELA_NAME(POINT_SIZE),
    CANDELA_NAME(POLYGON_MODE),
    CANDELA_NAME(POLYGON_OFFSET_FACTOR),
    CANDELA_NAME(POLYGON_OFFSET_UNITS),
    CANDELA_NAME(PRIMITIVE_RESTART_INDEX),
    CANDELA_NAME(PROGRAM_PIPELINE_BINDING),
    CANDELA_NAME(PROVOKING_VERTEX),
    CANDELA_NAME(QUERY_BUFFER_BINDING),
    CANDELA_NAME(READ_BUFFER),
    CANDELA_NAME(READ_FRAMEBUFFER_BINDING),
    CANDELA_NAME(RENDERBUFFER_BINDING),
    CANDELA_NAME(SAMPLE_COVERAGE_INVERT),
    CANDELA_NAME(SAMPLE_COVERAGE_VALUE),
    CANDELA_NAME(SHADER_STORAGE_BUFFER_BINDING),
    CANDELA_NAME(STENCIL_BACK_FAIL),
    CANDELA_NAME(STENCIL_BACK_FUNC),
    CANDELA_NAME(STENCIL_BACK_PASS_DEPTH_FAIL),
    CANDELA_NAME(STENCIL_BACK_PASS_DEPTH_PASS),
    CANDELA_NAME(STENCIL_BACK_REF),
    CANDELA_NAME(STENCIL_BACK_VALUE_MASK),
    CANDELA_NAME(STENCIL_BACK_WRITEMASK),
    CANDELA_NAME(STENCIL_CLEAR_VALUE),
    CANDELA_NAME(STENCIL_FAIL),
    CANDELA_NAME(STENCIL_FUNC),
    CANDELA_NAME(STENCIL_PASS_DEPTH_FAIL),
    CANDELA_NAME(STENCIL_PASS_DEPTH_PASS),
    CANDELA_NAME(STENCIL_REF),
    CANDELA_NAME(STENCIL_VALUE_MASK),
    CANDELA_NAME(STENCIL_WRITEMASK),
    CANDELA_NAME(TRANSFORM_FEEDBACK_BUFFER_BINDING),
    CANDELA_NAME(UNIFORM_BUFFER_BINDING),
    CANDELA_NAME(UNPACK_ALIGNMENT),
    CANDELA_NAME(UNPACK_IMAGE_HEIGHT),
    CANDELA_NAME(UNPACK_LSB_FIRST),
    CANDELA_NAME(UNPACK_ROW_LENGTH),
    CANDELA_NAME(UNPACK_SKIP_IMAGES),
    CANDELA_NAME(UNPACK_SKIP_PIXELS),
    CANDELA_NAME(UNPACK_SKIP_ROWS),
    CANDELA_NAME(UNPACK_SWAP_BYTES),
    CANDELA_NAME(VERTEX_ARRAY_BINDING),
};

constexpr Name perUnit[] = {
    CANDELA_NAME(SAMPLER_BINDING),          CANDELA_NAME(TEXTURE_BINDING_1D),
    CANDELA_NAME(TEXTURE_BINDING_1D_ARRAY), CANDELA_NAME(TEXTURE_BINDING_2D),
    CANDELA_NAME(TEXTURE_BINDING_2D_ARRAY), CANDELA_NAME(TEXTURE_BINDING_2D_MULTISAMPLE),
    CANDELA_NAME(TEXTURE_BINDING_3D),       CANDELA_NAME(TEXTURE_BINDING_BUFFER),
    CANDELA_NAME(TEXTURE_BINDING_CUBE_MAP), CANDELA_NAME(TEXTURE_BINDING_RECTANGLE),
};

constexpr Name perDrawBuffer[] = {
    CANDELA_NAME(BLEND_SRC_RGB),      CANDELA_NAME(BLEND_DST_RGB),      CANDELA_NAME(BLEND_SRC_ALPHA),
    CANDELA_NAME(BLEND_DST_ALPHA),    CANDELA_NAME(BLEND_EQUATION_RGB), CANDELA_NAME(BLEND_EQUATION_ALPHA),
    CANDELA_NAME(COLOR_WRITEMASK, 4),
};

constexpr Name perUniformBinding[] = {
    CANDELA_NAME(UNIFORM_BUFFER_BINDING),
    CANDELA_NAME(UNIFORM_BUFFER_START),
    CANDELA_NAME(UNIFORM_BUFFER_SIZE),
};

constexpr Name perStorageBinding[] = {
    CANDELA_NAME(SHADER_STORAGE_BUFFER_BINDING),
    CANDELA_NAME(SHADER_STORAGE_BUFFER_START),
    CANDELA_NAME(SHADER_STORAGE_BUFFER_SIZE),
};

constexpr Name perSampleMask[] = {CANDELA_NAME(SAMPLE_MASK_VALUE)};

constexpr Name perImageUnit[] = {
    CANDELA_NAME(IMAGE_BINDING_NAME),    CANDELA_NAME(IMAGE_BINDING_LEVEL),
    CANDELA_NAME(IMAGE_BINDING_LAYERED), CANDELA_NAME(IMAGE_BINDING_LAYER),
    CANDELA_NAME(IMAGE_BINDING_ACCESS),  CANDELA_NAME(IMAGE_BINDING_FORMAT),
};

#undef CANDELA_NAME

constexpr int units = 24, drawBuffers = 4, viewports = 4, bufferBindings = 10, imageBindings = 6;

void queryIndexed(GlState& state, const Name& name, int index) {
    std::vector<GLint> values(static_cast<std::size_t>(name.values));
    glGetIntegeri_v(name.name, static_cast<GLuint>(index), values.data());
    state[name.text + ("[" + std::to_string(index) + "]")].assign(values.begin(), values.end());
}

void queryViewports(GlState& state) {
    for (int i = 0; i < viewports; ++i) {
        const std::string at = "[" + std::to_string(i) + "]";
        const auto index = static_cast<GLuint>(i);
        float viewport[4];
        int scissor[4];
        double range[2];
        glGetFloati_v(GL_VIEWPORT, index, viewport);
        glGetIntegeri_v(GL_SCISSOR_BOX, index, scissor);
        glGetDoublei_v(GL_DEPTH_RANGE, index, range);
        state["VIEWPORT" + at].assign(viewport, viewport + 4);
        state["SCISSOR_BOX" + at].assign(scissor, scissor + 4);
        state["DEPTH_RANGE" + at].assign(range, range + 2);
        state["SCISSOR_TEST" + at] = {double(glIsEnabledi(GL_SCISSOR_TEST, index))};
    }
}

}  // namespace

GlState queryState() {
    GlState state;
    for (const Name& name : capabilities) state[name.text] = {double(glIsEnabled(name.name))};
    for (const Name& name : numbers) {
        std::vector<double> values(static_cast<std::size_t>(std::max(name.values, 4)));
        glGetDoublev(name.name, values.data());
        values.resize(static_cast<std::size_t>(name.values));
        state[name.text] = values;
    }
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (int unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const Name& name : perUnit) {
            GLint value = 0;
            glGetIntegerv(name.name, &value);
            state[name.text + ("[" + std::to_string(unit) + "]")] = {double(value)};
        }
    }
    glActiveTexture(static_cast<GLenum>(active));
    for (int i = 0; i < drawBuffers; ++i) {
        for (const Name& name : perDrawBuffer) queryIndexed(state, name, i);
        state["BLEND[" + std::to_string(i) + "]"] = {double(glIsEnabledi(GL_BLEND, static_cast<GLuint>(i)))};
    }
    for (int i = 0; i < bufferBindings; ++i) {
        for (const Name& name : perUniformBinding) queryIndexed(state, name, i);
        for (const Name& name : perStorageBinding) queryIndexed(state, name, i);
    }
    for (int i = 0; i < imageBindings; ++i) {
        for (const Name& name : perImageUnit) queryIndexed(state, name, i);
    }
    queryIndexed(state, perSampleMask[0], 0);
    queryViewports(state);
    return state;
}

std::vector<std::string> differences(const GlState& before, const GlState& after) {
    std::vector<std::string> found;
    for (const auto& [name, values] : before) {
        if (after.at(name) == values) continue;
        std::ostringstream text;
        text << name << ":";
        for (const double value : values) text << ' ' << value;
        text << " became";
        for (const double value : after.at(name)) text << ' ' << value;
        found.push_back(text.str());
    }
    return found;
}

UnusualState::UnusualState() {
    makeObjects();
    bindObjects();
    bindUnits();
    setFixedFunction();
    setPerBuffer();
}

UnusualState::~UnusualState() {
    glUseProgram(0);
    glDeleteProgram(program_);
    glDeleteProgram(pipelineProgram_);
    glDeleteProgramPipelines(1, &pipeline_);
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteRenderbuffers(1, &renderbuffer_);
    glDeleteSamplers(1, &sampler_);
    glDeleteFramebuffers(2, framebuffers_);
    glDeleteTextures(8, textures_);
    glDeleteBuffers(8, buffers_);
}

void UnusualState::makeObjects() {
    const char* text = "#version 450 core\nvoid main() { gl_Position = vec4(0.0); }\n";
    program_ = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &text);
    pipelineProgram_ = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &text);
    glCreateProgramPipelines(1, &pipeline_);
    glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, pipelineProgram_);
    glCreateVertexArrays(1, &vertexArray_);
    glCreateRenderbuffers(1, &renderbuffer_);
    glCreateSamplers(1, &sampler_);
    glCreateBuffers(8, buffers_);
    for (const GLuint buffer : buffers_) glNamedBufferData(buffer, 4096, nullptr, GL_STATIC_DRAW);
    constexpr GLenum targets[8] = {GL_TEXTURE_1D,       GL_TEXTURE_2D,       GL_TEXTURE_3D,
                                   GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BUFFER,
                                   GL_TEXTURE_2D,       GL_TEXTURE_RECTANGLE};
    for (int i = 0; i < 8; ++i) glCreateTextures(targets[i], 1, &textures_[i]);
    glTextureStorage1D(textures_[0], 1, GL_RGBA8, 8);
    glTextureStorage2D(textures_[1], 1, GL_RGBA8, 8, 8);
    glTextureStorage3D(textures_[2], 1, GL_RGBA8, 8, 8, 8);
    glTextureStorage3D(textures_[3], 1, GL_RGBA8, 8, 8, 3);
    glTextureStorage2D(textures_[4], 1, GL_RGBA8, 8, 8);
    glTextureBuffer(textures_[5], GL_RGBA8, buffers_[7]);
    glTextureStorage2D(textures_[6], 1, GL_RGBA8, 64, 64);
    glTextureStorage2D(textures_[7], 1, GL_RGBA8, 8, 8);
    glCreateFramebuffers(2, framebuffers_);
    for (const GLuint framebuffer : framebuffers_) {
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT1, textures_[6], 0);
        constexpr GLenum buffers[2] = {GL_NONE, GL_COLOR_ATTACHMENT1};
        glNamedFramebufferDrawBuffers(framebuffer, 2, buffers);
        glNamedFramebufferReadBuffer(framebuffer, GL_COLOR_ATTACHMENT1);
    }
}

void UnusualState::bindObjects() const {
    glBindVertexArray(vertexArray_);
    glBindProgramPipeline(pipeline_);
    glUseProgram(program_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[0]);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
    constexpr GLenum targets[] = {
        GL_ARRAY_BUFFER,      GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER,
        GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER,  GL_COPY_READ_BUFFER,
        GL_COPY_WRITE_BUFFER, GL_QUERY_BUFFER,         GL_TRANSFORM_FEEDBACK_BUFFER};
    for (std::size_t i = 0; i < std::size(targets); ++i) glBindBuffer(targets[i], buffers_[i % 8]);
    for (GLuint i = 0; i < 10; ++i) {
        glBindBufferRange(GL_UNIFORM_BUFFER, i, buffers_[i % 4], 256 * static_cast<GLintptr>(i % 3), 256);
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffers_[4 + i % 4], 256, 512);
    }
    // A whole buffer, without a range, is something else than a range of the buffer's size.
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, buffers_[2]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, buffers_[3]);
    glBindBuffer(GL_UNIFORM_BUFFER, buffers_[5]);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffers_[6]);
}

void UnusualState::bindUnits() const {
    constexpr GLenum targets[8] = {GL_TEXTURE_1D,       GL_TEXTURE_2D,       GL_TEXTURE_3D,
                                   GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BUFFER,
                                   GL_TEXTURE_2D,       GL_TEXTURE_RECTANGLE};
    for (int unit = 0; unit < units; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (int i = 0; i < 8; ++i) {
            if (i != 6) glBindTexture(targets[i], textures_[i]);
        }
        glBindSampler(static_cast<GLuint>(unit), sampler_);
    }
    for (GLuint i = 0; i < 6; ++i)
        glBindImageTexture(i, textures_[3], 0, i % 2 == 0 ? GL_TRUE : GL_FALSE, 1, GL_WRITE_ONLY, GL_RGBA8UI);
    glActiveTexture(GL_TEXTURE5);
}

void UnusualState::setFixedFunction() const {
    for (const Name& name : capabilities) {
        const bool ownContext = name.name == GL_DEBUG_OUTPUT;
        if (!ownContext) glEnable(name.name);
    }
    glDisable(GL_MULTISAMPLE);
    glDisable(GL_DITHER);
    glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
    glClearColor(0.5f, 0.6f, 0.7f, 0.8f);
    glClearDepthf(0.25f);
    glClearStencil(3);
    glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
    glDepthFunc(GL_NEVER);
    glDepthMask(GL_FALSE);
    glLineWidth(0.5f);  // Wide ones are an error in forward-compatible contexts.
    glLogicOp(GL_XOR);
    glMinSampleShading(0.5f);
    glPatchParameteri(GL_PATCH_VERTICES, 7);
    glPointSize(3.0f);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glPolygonOffset(2.0f, 5.0f);
    glPrimitiveRestartIndex(2);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glSampleCoverage(0.25f, GL_TRUE);
    glSampleMaski(0, 0x5);
    glStencilFuncSeparate(GL_FRONT, GL_NEVER, 5, 0x3f);
    glStencilFuncSeparate(GL_BACK, GL_GREATER, 6, 0x1f);
    glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_INCR, GL_DECR);
    glStencilOpSeparate(GL_BACK, GL_INCR_WRAP, GL_DECR_WRAP, GL_REPLACE);
    glStencilMaskSeparate(GL_FRONT, 0x0);
    glStencilMaskSeparate(GL_BACK, 0x7);
    constexpr std::array packing{std::pair{GL_PACK_ALIGNMENT, 8},     std::pair{GL_PACK_IMAGE_HEIGHT, 11},
                                 std::pair{GL_PACK_ROW_LENGTH, 13},   std::pair{GL_PACK_SKIP_IMAGES, 1},
                                 std::pair{GL_PACK_SKIP_PIXELS, 2},   std::pair{GL_PACK_SKIP_ROWS, 3},
                                 std::pair{GL_PACK_SWAP_BYTES, 1},    std::pair{GL_PACK_LSB_FIRST, 1},
                                 std::pair{GL_UNPACK_ALIGNMENT, 8},   std::pair{GL_UNPACK_IMAGE_HEIGHT, 9},
                                 std::pair{GL_UNPACK_ROW_LENGTH, 17}, std::pair{GL_UNPACK_SKIP_IMAGES, 2},
                                 std::pair{GL_UNPACK_SKIP_PIXELS, 3}, std::pair{GL_UNPACK_SKIP_ROWS, 4},
                                 std::pair{GL_UNPACK_SWAP_BYTES, 1},  std::pair{GL_UNPACK_LSB_FIRST, 1}};
    for (const auto& [name, value] : packing) glPixelStorei(static_cast<GLenum>(name), value);
}

void UnusualState::setPerBuffer() const {
    for (GLuint i = 0; i < drawBuffers; ++i) {
        glColorMaski(i, GL_FALSE, i % 2 != 0, GL_FALSE, i % 3 == 0);
        glBlendFuncSeparatei(i, GL_DST_COLOR, GL_SRC_ALPHA_SATURATE - i, GL_CONSTANT_COLOR, GL_ZERO);
        glBlendEquationSeparatei(i, i % 2 == 0 ? GL_MIN : GL_MAX, GL_FUNC_REVERSE_SUBTRACT);
        if (i % 2 == 0) glDisablei(GL_BLEND, i);
    }
    for (GLuint i = 0; i < viewports; ++i) {
        glViewportIndexedf(i, float(i), 2.0f, 5.5f + float(i), 7.0f);
        glScissorIndexed(i, 1, static_cast<GLint>(i), 2, 3);
        glDepthRangeIndexed(i, 0.75, 0.125 * i);
        if (i % 2 != 0) glDisablei(GL_SCISSOR_TEST, i);
    }
}

}  // namespace candela::test
