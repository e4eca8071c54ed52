#include "common/gl_program.h"
#include "gl_drawing.h"
#include "programs.h"
#include "textbook_shaders.h"

#include <candela/brdf.h>
#include <candela/error.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace {

const std::string version = "#version 450 core\n";
/// Software rasterisers end a loop after this many iterations.
constexpr std::size_t maxLoopLights = 65'535;

/// A light as the shaders read it.
struct ShaderLight {
    glm::vec4 positionRange;
    glm::vec4 intensity;
};

std::vector<ShaderLight> shaderLights(const BenchScene& scene) {
    std::vector<ShaderLight> lights;
    for (const candela::WorldLight& light : scene.lights) {
        if (light.type != candela::LightType::point || light.range <= 0.0f) {
            throw candela::Error(candela::ErrorKind::unsupported, scene.name,
                                 "the textbook programs draw point lights with a range only");
        }
        lights.push_back({glm::vec4(light.position, light.range), glm::vec4(light.intensity, 0.0f)});
    }
    return lights;
}

void requireSupported(const BenchScene& scene, TextbookLighting lighting) {
    if (lighting == TextbookLighting::fullscreen && scene.lights.size() > maxLoopLights) {
        throw candela::Error(candela::ErrorKind::unsupported, scene.name,
                             std::to_string(scene.lights.size()) +
                                 " lights; the textbook full-screen loop ends at " +
                                 std::to_string(maxLoopLights));
    }
    for (const candela::Material& material : scene.scene.materials) {
        if (!material.baseColorTexture && !material.metallicRoughnessTexture && !material.normalTexture &&
            !material.unlit)
            continue;
        throw candela::Error(candela::ErrorKind::unsupported, scene.name,
                             "the textbook programs draw untextured materials only, and '" + material.name +
                                 "' has textures or is unlit");
    }
}

/// The split sum of the model `course`, for bilinear lookups by n·v and roughness.
class SplitSum {
  public:
    SplitSum() {
        std::vector<glm::vec2> texels;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const auto albedo = [&](double f0) {
                    return static_cast<float>(candela::specularAlbedo(candela::BrdfModel::course,
                                                                      glm::dvec3(f0), (x + 0.5) / size,
                                                                      (y + 0.5) / size)
                                                  .x);
                };
                texels.emplace_back(albedo(1.0) - albedo(0.0), albedo(0.0));
            }
        }
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RG32F, size, size);
        glTextureSubImage2D(texture_, 0, 0, 0, size, size, GL_RG, GL_FLOAT, texels.data());
        glTextureParameteri(texture_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(texture_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    SplitSum(const SplitSum&) = delete;
    SplitSum& operator=(const SplitSum&) = delete;
    ~SplitSum() { glDeleteTextures(1, &texture_); }

    GLuint texture() const { return texture_; }

  private:
    static constexpr int size = 128;
    GLuint texture_ = 0;
};

/// The instanced sphere of a textbook: 16 by 12 segments, scaled by 1.05 so that its flat faces lie outside
/// the unit sphere.
class Sphere {
  public:
    explicit Sphere(const std::vector<ShaderLight>& lights)
        : instances_(static_cast<GLsizei>(lights.size())) {
        constexpr int segments = 16, rings = 12;
        std::vector<glm::vec3> vertices;
        std::vector<std::uint32_t> indices;
        for (int ring = 0; ring <= rings; ++ring) {
            const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / rings;
            for (int segment = 0; segment <= segments; ++segment) {
                const float azimuth =
                    2.0f * std::numbers::pi_v<float> * static_cast<float>(segment) / segments;
                vertices.push_back(1.05f * glm::vec3(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                                     std::sin(polar) * std::sin(azimuth)));
            }
        }
        for (std::uint32_t ring = 0; ring < rings; ++ring) {
            for (std::uint32_t segment = 0; segment < segments; ++segment) {
                const std::uint32_t a = ring * (segments + 1) + segment, b = a + segments + 1;
                indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
            }
        }
        indexCount_ = static_cast<GLsizei>(indices.size());
        glCreateBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        glNamedBufferStorage(buffers_[0], static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3)),
                             vertices.data(), 0);
        glNamedBufferStorage(buffers_[1], static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                             indices.data(), 0);
        glNamedBufferStorage(buffers_[2], static_cast<GLsizeiptr>((lights.size() + 1) * sizeof(ShaderLight)),
                             nullptr, GL_DYNAMIC_STORAGE_BIT);
        glNamedBufferSubData(buffers_[2], 0, static_cast<GLsizeiptr>(lights.size() * sizeof(ShaderLight)),
                             lights.data());
        glCreateVertexArrays(1, &vertexArray_);
        glVertexArrayElementBuffer(vertexArray_, buffers_[1]);
        glVertexArrayVertexBuffer(vertexArray_, 0, buffers_[0], 0, sizeof(glm::vec3));
        glVertexArrayVertexBuffer(vertexArray_, 1, buffers_[2], 0, sizeof(ShaderLight));
        glVertexArrayBindingDivisor(vertexArray_, 1, 1);
        addAttribute(0, 3, 0, 0);
        addAttribute(1, 4, 1, 0);
        addAttribute(2, 4, 1, sizeof(glm::vec4));
    }
    Sphere(const Sphere&) = delete;
    Sphere& operator=(const Sphere&) = delete;
    ~Sphere() {
        glDeleteVertexArrays(1, &vertexArray_);
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    }

    void draw() const {
        glBindVertexArray(vertexArray_);
        glDrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr, instances_);
    }
    GLuint lightBuffer() const { return buffers_[2]; }

  private:
    void addAttribute(GLuint attribute, GLint components, GLuint binding, GLuint offset) const {
        glEnableVertexArrayAttrib(vertexArray_, attribute);
        glVertexArrayAttribFormat(vertexArray_, attribute, components, GL_FLOAT, GL_FALSE, offset);
        glVertexArrayAttribBinding(vertexArray_, attribute, binding);
    }

    std::array<GLuint, 3> buffers_{};
    GLuint vertexArray_ = 0;
    GLsizei indexCount_ = 0, instances_;
};

class TextbookProgram final : public Program {
  public:
    TextbookProgram(const candela::Context& context, const BenchScene& scene, const BenchOptions& options,
                    TextbookLighting lighting)
        : clock_(context),
          lighting_(lighting),
          width_(options.width),
          height_(options.height),
          eye_(scene.view.eye()),
          clipFromWorld_(textbookClipFromWorld(scene.view, options.width, options.height)),
          geometry_(scene.scene),
          lights_(shaderLights(scene)),
          sphere_(lights_),
          position_(GL_RGBA16F, width_, height_),
          normal_(GL_RGBA16F, width_, height_),
          color_(GL_RGBA8, width_, height_),
          depth_(GL_DEPTH_COMPONENT24, width_, height_),
          radiance_(GL_RGBA16F, width_, height_),
          counts_(GL_R32F, width_, height_),
          screen_(width_, height_),
          geometryProgram_(makeProgram(textbook::geometryVertex, textbook::geometryFragment)),
          lightingProgram_(makeLightingProgram()),
          countProgram_(makeProgram(textbook::volumeVertex, version + textbook::volumeCountFragment)),
          displayProgram_(makeProgram(textbook::fullscreenVertex, textbook::displayFragment)) {
        glCreateFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
        attach(framebuffers_[0], {position_.name(), normal_.name(), color_.name()});
        attach(framebuffers_[1], {radiance_.name()});
        attach(framebuffers_[2], {counts_.name()});
        glCreateTextures(GL_TEXTURE_BUFFER, 1, &lightTexture_);
        glTextureBuffer(lightTexture_, GL_RGBA32F, sphere_.lightBuffer());
        glCreateVertexArrays(1, &emptyVertexArray_);
    }
    ~TextbookProgram() override {
        for (const GLuint program : {geometryProgram_, lightingProgram_, countProgram_, displayProgram_})
            glDeleteProgram(program);
        glDeleteFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
        glDeleteTextures(1, &lightTexture_);
        glDeleteVertexArrays(1, &emptyVertexArray_);
    }

    FrameTimes draw() override {
        clock_.start();
        drawGeometry();
        clock_.lap("geometry");
        drawLighting();
        clock_.lap("lighting");
        drawDisplay();
        clock_.lap("display");
        return clock_.times();
    }

    void count(Result& result) override {
        if (lighting_ == TextbookLighting::fullscreen) {
            std::vector<float> positions(pixels() * 4);
            glGetTextureImage(position_.name(), 0, GL_RGBA, GL_FLOAT,
                              static_cast<GLsizei>(positions.size() * sizeof(float)), positions.data());
            std::uint64_t covered = 0;
            for (std::size_t i = 3; i < positions.size(); i += 4) covered += positions[i] != 0.0f;
            result.pairsEvaluated = covered * lights_.size();
            return;
        }
        drawVolumes(framebuffers_[2], countProgram_);
        std::vector<float> counts(pixels());
        glGetTextureImage(counts_.name(), 0, GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(counts.size() * sizeof(float)), counts.data());
        result.pairsEvaluated =
            static_cast<std::uint64_t>(std::accumulate(counts.begin(), counts.end(), 0.0));
    }

    std::vector<float> radiance() override {
        std::vector<float> rgb(pixels() * 3);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glGetTextureImage(radiance_.name(), 0, GL_RGB, GL_FLOAT,
                          static_cast<GLsizei>(rgb.size() * sizeof(float)), rgb.data());
        const std::size_t row = static_cast<std::size_t>(width_) * 3;
        for (std::size_t y = 0; y < static_cast<std::size_t>(height_) / 2; ++y) {
            std::swap_ranges(
                rgb.begin() + static_cast<std::ptrdiff_t>(y * row),
                rgb.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                rgb.begin() + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(height_) - 1 - y) * row));
        }
        return rgb;
    }

  private:
    GLuint makeLightingProgram() const {
        if (lighting_ == TextbookLighting::fullscreen) {
            return makeProgram(textbook::fullscreenVertex,
                               version + textbook::lightingFunctions + textbook::fullscreenFragment);
        }
        return makeProgram(textbook::volumeVertex,
                           version + textbook::lightingFunctions + textbook::volumeFragment);
    }

    void attach(GLuint framebuffer, const std::vector<GLuint>& colors) const {
        std::vector<GLenum> buffers;
        for (const GLuint color : colors) {
            buffers.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + buffers.size()));
            glNamedFramebufferTexture(framebuffer, buffers.back(), color, 0);
        }
        glNamedFramebufferDrawBuffers(framebuffer, static_cast<GLsizei>(buffers.size()), buffers.data());
        glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    }

    std::size_t pixels() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }

    void drawGeometry() const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
        glViewport(0, 0, width_, height_);
        glDisable(GL_BLEND);
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(geometryProgram_);
        glUniformMatrix4fv(3, 1, GL_FALSE, &clipFromWorld_[0][0]);
        geometry_.draw();
    }

    void drawLighting() const {
        const GLuint textures[] = {position_.name(), normal_.name(), color_.name(), lightTexture_,
                                   splitSum_.texture()};
        glBindTextures(0, 5, textures);
        glUseProgram(lightingProgram_);
        glUniform3f(4, eye_.x, eye_.y, eye_.z);
        if (lighting_ == TextbookLighting::volumes) return drawVolumes(framebuffers_[1], lightingProgram_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
        glUniform1i(5, static_cast<GLint>(lights_.size()));
        drawFullscreenTriangle();
    }

    void drawVolumes(GLuint framebuffer, GLuint program) const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        glUseProgram(program);
        glUniformMatrix4fv(3, 1, GL_FALSE, &clipFromWorld_[0][0]);
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_GEQUAL);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        sphere_.draw();
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }

    void drawDisplay() const {
        glBindFramebuffer(GL_FRAMEBUFFER, screen_.framebuffer());
        glBindTextureUnit(0, radiance_.name());
        glUseProgram(displayProgram_);
        drawFullscreenTriangle();
    }

    void drawFullscreenTriangle() const {
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        glBindVertexArray(emptyVertexArray_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    PassClock clock_;
    TextbookLighting lighting_;
    int width_, height_;
    glm::vec3 eye_;
    glm::mat4 clipFromWorld_;
    SceneGeometry geometry_;
    std::vector<ShaderLight> lights_;
    Sphere sphere_;
    Target position_, normal_, color_, depth_, radiance_, counts_;
    SplitSum splitSum_;
    Screen screen_;
    GLuint geometryProgram_, lightingProgram_, countProgram_, displayProgram_;
    std::array<GLuint, 3> framebuffers_{};
    GLuint lightTexture_ = 0, emptyVertexArray_ = 0;
};

}  // namespace

std::unique_ptr<Program> makeTextbookProgram(const candela::Context& context, const BenchScene& scene,
                                             const BenchOptions& options, TextbookLighting lighting) {
    requireSupported(scene, lighting);
    return std::make_unique<TextbookProgram>(context, scene, options, lighting);
}
