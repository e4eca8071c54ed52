#pragma once

#include "occlusion/occlusion_scenes.h"

#include "gl/shader_source.h"

#include <candela/context.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela::test {

/// lib/occlusion.glsl with a main that traces rays of a buffer.
class RayProgram {
  public:
    RayProgram() : rays_(GL_RGBA32F, "test rays"), answers_("test answers", gl::BufferUsage::readback) {
        const std::string text = gl::assembleShader("lib/occlusion.glsl") + R"(
layout(local_size_x = 64) in;
layout(binding = 0) uniform samplerBuffer rays;
layout(std430, binding = 0) writeonly buffer Answers { float answers[]; };
layout(location = 0) uniform int firstRay;
void main() {
    int i = firstRay + int(gl_GlobalInvocationID.x);
    if (2 * i >= textureSize(rays)) return;
    vec4 from = texelFetch(rays, 2 * i), way = texelFetch(rays, 2 * i + 1);
    answers[i] = transmittance(from.xyz, way.xyz, from.w, way.w);
}
)";
        const char* source = text.c_str();
        const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        program_ = glCreateProgram();
        glAttachShader(program_, shader);
        glLinkProgram(program_);
        glDeleteShader(shader);
        GLint linked = 0;
        glGetProgramiv(program_, GL_LINK_STATUS, &linked);
        char log[2000] = "";
        glGetProgramInfoLog(program_, sizeof log, nullptr, log);
        EXPECT_TRUE(linked) << log;
    }
    RayProgram(const RayProgram&) = delete;
    RayProgram& operator=(const RayProgram&) = delete;
    ~RayProgram() { glDeleteProgram(program_); }

    /// What passes along each ray, 0 to 1.
    std::vector<float> transmittances(const GpuOcclusion& structure, const std::vector<Ray>& rays) {
        rays_ = gl::BufferTexture(GL_RGBA32F, "test rays");
        rays_.upload(std::span<const Ray>(rays));
        answers_.reserve(rays.size() * sizeof(float));
        structure.bind();
        glBindTextureUnit(0, rays_.name());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, answers_.name());
        glUseProgram(program_);
        for (std::size_t first = 0; first < rays.size(); first += 65536) {
            glUniform1i(0, static_cast<GLint>(first));
            glDispatchCompute(
                static_cast<GLuint>((std::min<std::size_t>(rays.size() - first, 65536) + 63) / 64), 1, 1);
        }
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        std::vector<float> answers(rays.size());
        glGetNamedBufferSubData(answers_.name(), 0, static_cast<GLsizeiptr>(rays.size() * sizeof(float)),
                                answers.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return answers;
    }

  private:
    gl::BufferTexture rays_;
    gl::Buffer answers_;
    GLuint program_ = 0;
};

/// Tests that trace rays in shaders: one headless context and one program for the whole suite.
class RayProgramTest : public testing::Test {
  protected:
    static void SetUpTestSuite() { shared_ = std::make_unique<Shared>(); }
    static void TearDownTestSuite() { shared_.reset(); }

    static RayProgram& program() { return *shared_->program; }

  private:
    struct Shared {
        Shared() {
            context.makeCurrent();
            program.emplace();
        }
        Context context = Context::createHeadless();
        std::optional<RayProgram> program;
    };
    static inline std::unique_ptr<Shared> shared_;
};

}  // namespace candela::test
