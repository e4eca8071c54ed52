#include "common/gl_program.h"
#include "gl_drawing.h"
#include "programs.h"
#include "textbook_shaders.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace {

constexpr int mapSide = 256;
/// Of the drawing of all maps.
constexpr double maxMilliseconds = 60.0e3;
/// Lights between two looks at the clock, which waits for the device.
constexpr std::size_t batchLights = 16;

/// A face of a cube map (OpenGL 4.5, table 8.19): looks along an axis.
struct Face {
    int axis;
    float sign;
    glm::vec3 up;

    glm::vec3 direction() const {
        glm::vec3 direction{0.0f};
        direction[axis] = sign;
        return direction;
    }
};

constexpr std::array<Face, 6> faces{{{0, 1.0f, {0.0f, -1.0f, 0.0f}},
                                     {0, -1.0f, {0.0f, -1.0f, 0.0f}},
                                     {1, 1.0f, {0.0f, 0.0f, 1.0f}},
                                     {1, -1.0f, {0.0f, 0.0f, -1.0f}},
                                     {2, 1.0f, {0.0f, -1.0f, 0.0f}},
                                     {2, -1.0f, {0.0f, -1.0f, 0.0f}}}};

glm::mat4 clipFromWorldOf(const Face& face, const candela::WorldLight& light) {
    constexpr float nearShare = 0.005f;
    const glm::mat4 projection =
        glm::perspectiveRH_ZO(0.5f * std::numbers::pi_v<float>, 1.0f, nearShare * light.range, light.range);
    return projection * glm::lookAt(light.position, light.position + face.direction(), face.up);
}

bool isInRange(const candela::Bounds& bounds, const candela::WorldLight& light) {
    if (bounds.empty()) return false;
    const glm::vec3 nearest = glm::clamp(light.position, bounds.min, bounds.max);
    return glm::distance(nearest, light.position) <= light.range;
}

/// May a box meet the pyramid of directions of a face? It is bounded by four planes between two axes each.
bool isInView(const candela::Bounds& bounds, const glm::vec3& eye, const Face& face) {
    const glm::vec3 min = bounds.min - eye, max = bounds.max - eye;
    const float farthest = face.sign > 0.0f ? max[face.axis] : -min[face.axis];
    if (farthest <= 0.0f) return false;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == face.axis) continue;
        if (farthest < min[axis] || farthest < -max[axis]) return false;
    }
    return true;
}

/// The planes of a view volume that points are in front of, of unit normals (Gribb and Hartmann, "Fast
/// extraction of viewing frustum planes", 2001): sides and the near plane.
std::array<glm::vec4, 5> frustumPlanes(const glm::mat4& clipFromWorld) {
    const glm::mat4 rows = glm::transpose(clipFromWorld);
    std::array<glm::vec4, 5> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                    rows[3] - rows[1], rows[2]};
    for (glm::vec4& plane : planes) plane /= glm::length(glm::vec3(plane));
    return planes;
}

/// The lights whose range meets the view frustum: others need no map.
std::vector<candela::WorldLight> lightsInView(const BenchScene& scene, const BenchOptions& options) {
    const auto planes = frustumPlanes(textbookClipFromWorld(scene.view, options.width, options.height));
    std::vector<candela::WorldLight> lights;
    for (const candela::WorldLight& light : scene.lights) {
        if (light.type != candela::LightType::point || light.range <= 0.0f) {
            throw candela::Error(candela::ErrorKind::unsupported, scene.name,
                                 "cube shadow maps are drawn of point lights with a range only");
        }
        const auto reaches = [&](const glm::vec4& plane) {
            return glm::dot(plane, glm::vec4(light.position, 1.0f)) >= -light.range;
        };
        if (std::ranges::all_of(planes, reaches)) lights.push_back(light);
    }
    if (lights.empty())
        throw candela::Error(candela::ErrorKind::unsupported, scene.name,
                             "no light in view to draw a cube shadow map of");
    return lights;
}

/// One cube map that all lights are drawn into: maps of 1.5 MB each for all lights would not fit many
/// devices.
class CubeShadowMap {
  public:
    explicit CubeShadowMap(const candela::Scene& scene)
        : geometry_(scene), program_(makeProgram(textbook::shadowVertex, textbook::shadowFragment)) {
        glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_DEPTH_COMPONENT32F, mapSide, mapSide);
        glCreateFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
        for (std::size_t face = 0; face < faces.size(); ++face)
            glNamedFramebufferTextureLayer(framebuffers_[face], GL_DEPTH_ATTACHMENT, texture_, 0,
                                           static_cast<GLint>(face));
    }
    CubeShadowMap(const CubeShadowMap&) = delete;
    CubeShadowMap& operator=(const CubeShadowMap&) = delete;
    ~CubeShadowMap() {
        glDeleteProgram(program_);
        glDeleteFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
        glDeleteTextures(1, &texture_);
    }

    /// Returns how many triangles were drawn.
    std::uint64_t draw(const candela::WorldLight& light) {
        inRange_.clear();
        for (std::uint32_t i = 0; i < geometry_.bounds().size(); ++i)
            if (isInRange(geometry_.bounds()[i], light)) inRange_.push_back(i);
        setState();
        std::uint64_t triangles = 0;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            inView_.clear();
            for (const std::uint32_t i : inRange_)
                if (isInView(geometry_.bounds()[i], light.position, faces[face])) inView_.push_back(i);
            constexpr float farthest = 1.0f;
            glClearNamedFramebufferfv(framebuffers_[face], GL_DEPTH, 0, &farthest);
            if (inView_.empty()) continue;
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[face]);
            const glm::mat4 clipFromWorld = clipFromWorldOf(faces[face], light);
            glUniformMatrix4fv(3, 1, GL_FALSE, &clipFromWorld[0][0]);
            triangles += geometry_.draw(inView_);
        }
        return triangles;
    }

  private:
    void setState() const {
        glViewport(0, 0, mapSide, mapSide);
        glDisable(GL_BLEND);
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        glUseProgram(program_);
    }

    SceneGeometry geometry_;
    GLuint program_, texture_ = 0;
    std::array<GLuint, faces.size()> framebuffers_{};
    std::vector<std::uint32_t> inRange_, inView_;
};

}  // namespace

Result measureShadowMaps(const candela::Context& context, const BenchScene& scene,
                         const BenchOptions& options) {
    const std::vector<candela::WorldLight> lights = lightsInView(scene, options);
    CubeShadowMap map(scene.scene);
    PassClock clock(context);
    map.draw(lights.front());  // compiles and allocates
    ShadowMaps maps;
    while (maps.lights < lights.size() && maps.milliseconds < maxMilliseconds) {
        const std::size_t end = std::min<std::size_t>(maps.lights + batchLights, lights.size());
        clock.start();
        for (; maps.lights < end; ++maps.lights) maps.triangles += map.draw(lights[maps.lights]);
        clock.lap("shadow maps");
        maps.milliseconds += clock.times().frame;
    }
    Result result;
    result.scene = scene.name;
    result.lights = scene.lights.size();
    result.width = options.width;
    result.height = options.height;
    result.frames = 1;
    result.frame = maps.milliseconds;
    result.lightsVisible = lights.size();
    result.shadowMaps = maps;
    return result;
}
