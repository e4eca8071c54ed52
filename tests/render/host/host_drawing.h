#pragma once

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include "gl/framebuffer.h"
#include "gl/texture.h"

#include <candela/color.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace candela::test {

inline constexpr int width = 88, height = 52;
inline constexpr std::size_t pixels = std::size_t(width) * height;

inline FrameSettings frameSettings(TileBackend backend = TileBackend::automatic) {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.tileBackend = backend;
    return settings;
}

inline const DisplayTransform& transform() {
    static const DisplayTransform display = ColorConfig::builtIn().displayTransform({});
    return display;
}

/// A texture of the frame's size, rows from the top.
inline std::vector<float> floatsOf(GLuint texture, GLenum format, std::size_t channels) {
    std::vector<float> values(channels * pixels), turned;
    glGetTextureImage(texture, 0, format, GL_FLOAT, GLsizei(4 * values.size()), values.data());
    const auto row = std::ptrdiff_t(channels) * width;
    for (std::ptrdiff_t y = height; y-- > 0;)
        turned.insert(turned.end(), values.begin() + y * row, values.begin() + (y + 1) * row);
    return turned;
}

inline const FrameTexture& named(const std::vector<FrameTexture>& textures, const std::string& name) {
    for (const FrameTexture& texture : textures)
        if (texture.name == name) return texture;
    throw std::runtime_error("there is no texture " + name);
}

/// A host's framebuffer with float colour and depth.
struct HostTarget {
    explicit HostTarget(GLenum depthFormat = GL_DEPTH_COMPONENT32F)
        : color(gl::Texture::target2d(GL_RGBA32F, width, height, "host color")),
          depth(gl::Texture::target2d(depthFormat, width, height, "host depth")),
          framebuffer({&color}, &depth, "host") {}
    void clear(const glm::vec4& value, float depthValue) const {
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, glm::value_ptr(value));
        glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &depthValue);
    }
    std::vector<float> depths() const { return floatsOf(depth.name(), GL_DEPTH_COMPONENT, 1); }

    gl::Texture color, depth;
    gl::Framebuffer framebuffer;
};

/// The host's own program: a quad in front of the camera at a depth, of one colour.
class HostQuad {
  public:
    explicit HostQuad(const char* outputs, const char* body) {
        const std::string vertex =
            "#version 450\nlayout(location = 0) uniform mat4 clip; void main() { vec2 c = vec2(gl_VertexID & "
            "1, "
            "gl_VertexID >> 1) * 2.0 - 1.0; gl_Position = clip * vec4(c, 0.0, 1.0); }";
        const std::string fragment =
            std::string("#version 450\n") + outputs + "\nvoid main() { " + body + " }";
        program_ = glCreateProgram();
        for (const auto& [stage, text] :
             {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
            const GLuint shader = glCreateShader(GLenum(stage));
            const char* source = text.c_str();
            glShaderSource(shader, 1, &source, nullptr);
            glCompileShader(shader);
            glAttachShader(program_, shader);
            glDeleteShader(shader);
        }
        glLinkProgram(program_);
        GLint linked = GL_FALSE;
        glGetProgramiv(program_, GL_LINK_STATUS, &linked);
        EXPECT_EQ(linked, GL_TRUE);
        glCreateVertexArrays(1, &array_);
    }
    HostQuad(const HostQuad&) = delete;
    HostQuad& operator=(const HostQuad&) = delete;
    ~HostQuad() {
        glDeleteProgram(program_);
        glDeleteVertexArrays(1, &array_);
    }
    /// The quad of 2 m a side that `world` places.
    void draw(const FrameStage& stage, const glm::mat4& world) const {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glUseProgram(program_);
        const glm::mat4 clip = stage.clipFromWorld * world;
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(clip));
        glBindVertexArray(array_);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }

  private:
    GLuint program_ = 0, array_ = 0;
};

/// A wall at z = -1 with a sphere before it, lit, seen from z = 4.
inline LitScene wallAndSphere() {
    LitScene lit;
    lit.scene = sceneOf(makeQuad(1.6f), Material{}, glm::translate(glm::mat4(1.0f), {0, 0, -1}));
    place(lit.scene, makeSphere(0.6f), Material{});
    lit.lights = {pointLight({1, 1, 3}, 20.0f, {30, 25, 20})};
    lit.view = lookAt({0, 0, 4}, {0, 0, 0}, 0.75f);
    return lit;
}

inline glm::mat4 hostPlace(float x, float z) {
    return glm::scale(glm::translate(glm::mat4(1.0f), {x, 0, z}), glm::vec3(0.5f, 0.5f, 1.0f));
}

class HostFrameTest : public DrawingTest {
  protected:
    /// What the host's own quad covers and at which distance, by candela itself.
    static std::vector<float> distances(const glm::mat4& world, const CameraView& view) {
        GpuScene alone = upload(sceneOf(makeQuad(1.0f), Material{}, world));
        return renderer().render(alone, view, frameSettings()).aovs({"Z"})[0].values[0];
    }
    static std::vector<float> distancesOf(GpuScene& scene, const CameraView& view,
                                          const FrameSettings& settings) {
        return renderer().render(scene, view, settings).aovs({"Z"})[0].values[0];
    }
};

}  // namespace candela::test
