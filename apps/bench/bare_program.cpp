#include "common/gl_program.h"
#include "gl_drawing.h"
#include "programs.h"

namespace {

constexpr const char* vertexText = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 world;
layout(location = 3) uniform mat4 clipFromWorld;
layout(location = 0) out vec3 worldNormal;
void main() {
    worldNormal = mat3(world) * normal;
    gl_Position = clipFromWorld * (world * vec4(position, 1.0));
}
)";

constexpr const char* fragmentText = R"(#version 450 core
layout(location = 0) in vec3 worldNormal;
layout(location = 1) uniform vec3 baseColor;
layout(location = 2) uniform vec2 metallicRoughness;
layout(location = 0) out vec4 color;
void main() { color = vec4(baseColor * (0.5 + 0.5 * worldNormal.y), metallicRoughness.x); }
)";

class BareProgram final : public Program {
  public:
    BareProgram(const candela::Context& context, const BenchScene& scene, const BenchOptions& options)
        : clock_(context),
          geometry_(scene.scene),
          screen_(options.width, options.height),
          depth_(GL_DEPTH_COMPONENT24, options.width, options.height),
          program_(makeProgram(vertexText, fragmentText)),
          clipFromWorld_(textbookClipFromWorld(scene.view, options.width, options.height)),
          width_(options.width),
          height_(options.height) {
        glNamedFramebufferTexture(screen_.framebuffer(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    }
    ~BareProgram() override { glDeleteProgram(program_); }

    FrameTimes draw() override {
        clock_.start();
        glBindFramebuffer(GL_FRAMEBUFFER, screen_.framebuffer());
        glViewport(0, 0, width_, height_);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program_);
        glUniformMatrix4fv(3, 1, GL_FALSE, &clipFromWorld_[0][0]);
        geometry_.draw();
        clock_.lap("geometry");
        return clock_.times();
    }

    void count(Result&) override {}
    std::vector<float> radiance() override { return {}; }

  private:
    PassClock clock_;
    SceneGeometry geometry_;
    Screen screen_;
    Target depth_;
    GLuint program_;
    glm::mat4 clipFromWorld_;
    int width_, height_;
};

}  // namespace

std::unique_ptr<Program> makeBareProgram(const candela::Context& context, const BenchScene& scene,
                                         const BenchOptions& options) {
    return std::make_unique<BareProgram>(context, scene, options);
}
