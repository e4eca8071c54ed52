#include "outline.h"

#include "common/gl_program.h"
#include "gizmo_math.h"

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cstddef>

namespace {

/// Nodes of more points are not outlined: their points would be posed whenever something changes.
constexpr std::size_t maxPoints = 20'000'000;

constexpr const char* maskVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 clipFromWorld;
void main() {
    gl_Position = clipFromWorld * vec4(position, 1.0);
    // Depth does not matter, and clips nothing.
    gl_Position.z = 0.0;
}
)";
constexpr const char* maskFragment = R"(#version 450 core
layout(location = 0) out float covered;
void main() { covered = 1.0; }
)";
constexpr const char* lineVertex = R"(#version 450 core
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";
/// The distance to the nearest covered pixel, up to the thickness.
constexpr const char* lineFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D mask;
layout(location = 0) uniform ivec2 corner;
layout(location = 1) uniform float thickness;
layout(location = 0) out vec4 color;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - corner;
    ivec2 last = textureSize(mask, 0) - 1;
    if (texelFetch(mask, pixel, 0).r > 0.5) discard;
    int reach = int(ceil(thickness));
    float nearest = 1.0e9;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            if (texelFetch(mask, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).r > 0.5)
                nearest = min(nearest, length(vec2(x, y)));
    float alpha = clamp(thickness + 0.5 - nearest, 0.0, 1.0);
    if (alpha == 0.0) discard;
    color = vec4(0.95, 0.66, 0.27, alpha);
}
)";

void addMesh(const candela::Mesh& mesh, const candela::PosedPoints& posed,
             std::vector<glm::vec3>& triangles) {
    const auto add = [&](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i)
            triangles.emplace_back(posed.worldFromPoints * glm::vec4(posed.points[mesh.indices[i]], 1.0f));
    };
    if (mesh.submeshes.empty()) add(0, mesh.indices.size());
    for (const candela::Submesh& submesh : mesh.submeshes)
        if (submesh.topology == candela::Topology::triangles) add(submesh.firstIndex, submesh.indexCount);
}

/// The level at which a cage is outlined: its points lie on the limit surface at any.
std::uint32_t outlinedLevel(const candela::Cage& cage) {
    constexpr std::uint32_t finest = 4;
    constexpr std::size_t maxFaces = 200'000;
    std::uint32_t level = 1;
    while (level < finest && cage.faceSizes.size() << 2 * (level + 1) <= maxFaces) ++level;
    return level;
}

/// Each face as a fan.
void addFaces(const candela::RefinedCage& refined, const candela::PosedPoints& posed,
              std::vector<glm::vec3>& triangles) {
    std::vector<glm::vec3> positions(refined.vertexCount()), normals(refined.vertexCount());
    candela::evaluateLimit(refined, posed.points, {positions, normals, {}, {}});
    for (std::size_t first = 0; first < refined.faceVertices.size(); first += refined.faceSize) {
        const auto corner = [&](std::size_t i) {
            return glm::vec3(posed.worldFromPoints *
                             glm::vec4(positions[refined.faceVertices[first + i]], 1.0f));
        };
        for (std::size_t i = 2; i < refined.faceSize; ++i)
            triangles.insert(triangles.end(), {corner(0), corner(i - 1), corner(i)});
    }
}

/// The state of the context that `draw` changes, restored at the end.
class SavedState {
  public:
    SavedState() {
        glGetIntegerv(GL_VIEWPORT, viewport_.data());
        for (std::size_t i = 0; i < caps.size(); ++i) enabled_[i] = glIsEnabled(caps[i]);
        glGetBooleanv(GL_COLOR_WRITEMASK, mask_.data());
    }
    ~SavedState() {
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        for (std::size_t i = 0; i < caps.size(); ++i) (enabled_[i] ? glEnable : glDisable)(caps[i]);
        glColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
        glBindVertexArray(0);
        glUseProgram(0);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

    static constexpr std::array<GLenum, 5> caps{GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST,
                                                GL_FRAMEBUFFER_SRGB};

  private:
    std::array<int, 4> viewport_{};
    std::array<GLboolean, 5> enabled_{};
    std::array<GLboolean, 4> mask_{};
};

}  // namespace

void Outline::addCage(const candela::Cage& cage, std::uint32_t index, const candela::PosedPoints& posed,
                      const Target& target, std::vector<glm::vec3>& triangles) {
    auto refined = refined_.find(index);
    if (refined == refined_.end())
        refined = refined_
                      .emplace(index, target.subdivider ? target.subdivider->refine(cage, outlinedLevel(cage))
                                                        : candela::cagePolygons(cage))
                      .first;
    addFaces(refined->second, posed, triangles);
}

/// What the node and the nodes below it show, in world space.
std::vector<glm::vec3> Outline::shownTriangles(const Target& target) {
    const candela::Scene& scene = target.scene;
    const double time = target.time;
    const std::vector<glm::mat4> world = candela::worldTransforms(scene, time);
    std::vector<bool> inside(scene.nodes.size(), false);
    std::vector<glm::vec3> triangles;
    // Parents stand before their children.
    for (std::uint32_t i = target.node; i < scene.nodes.size() && triangles.size() < 3 * maxPoints; ++i) {
        const candela::Node& one = scene.nodes[i];
        inside[i] = i == target.node || (one.parent && inside[*one.parent]);
        if (!inside[i]) continue;
        if (one.mesh) addMesh(scene.meshes[*one.mesh], candela::poseMesh(scene, i, world, time), triangles);
        if (one.cage)
            addCage(scene.cages[*one.cage], *one.cage, candela::poseCage(scene, i, world, time), target,
                    triangles);
    }
    return triangles;
}

Outline::~Outline() {
    glDeleteProgram(maskProgram_);
    glDeleteProgram(lineProgram_);
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &buffer_);
    glDeleteTextures(1, &mask_);
    glDeleteFramebuffers(1, &framebuffer_);
}

void Outline::create() {
    if (vertexArray_ != 0) return;
    maskProgram_ = makeProgram(maskVertex, maskFragment);
    glObjectLabel(GL_PROGRAM, maskProgram_, -1, "mask of the outline");
    lineProgram_ = makeProgram(lineVertex, lineFragment);
    glObjectLabel(GL_PROGRAM, lineProgram_, -1, "outline");
    glCreateBuffers(1, &buffer_);
    glObjectLabel(GL_BUFFER, buffer_, -1, "outline");
    glCreateVertexArrays(1, &vertexArray_);
    glObjectLabel(GL_VERTEX_ARRAY, vertexArray_, -1, "outline");
    glEnableVertexArrayAttrib(vertexArray_, 0);
    glVertexArrayAttribFormat(vertexArray_, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertexArray_, 0, 0);
    glVertexArrayVertexBuffer(vertexArray_, 0, buffer_, 0, sizeof(glm::vec3));
    glCreateFramebuffers(1, &framebuffer_);
    glObjectLabel(GL_FRAMEBUFFER, framebuffer_, -1, "outline");
}

void Outline::resize(const glm::ivec2& size) {
    if (size == size_) return;
    glDeleteTextures(1, &mask_);
    glCreateTextures(GL_TEXTURE_2D, 1, &mask_);
    glObjectLabel(GL_TEXTURE, mask_, -1, "outline");
    glTextureStorage2D(mask_, 1, GL_R8, size.x, size.y);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, mask_, 0);
    size_ = size;
}

void Outline::upload(const Target& target) {
    const Key key{target.node, target.time, target.revision};
    if (drawn_ == key) return;
    const std::vector<glm::vec3> triangles = shownTriangles(target);
    glNamedBufferData(buffer_, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec3)),
                      triangles.data(), GL_DYNAMIC_DRAW);
    vertices_ = static_cast<int>(triangles.size());
    drawn_ = key;
}

void Outline::draw(const Target& target, const candela::CameraView& view, const Area& area, float thickness) {
    create();
    resize(area.size);
    upload(target);
    if (vertices_ == 0) return;
    const SavedState saved;
    for (const GLenum cap : SavedState::caps) glDisable(cap);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    constexpr std::array<float, 4> none{};
    glClearNamedFramebufferfv(framebuffer_, GL_COLOR, 0, none.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, area.size.x, area.size.y);
    glBindVertexArray(vertexArray_);
    glUseProgram(maskProgram_);
    const float aspect = static_cast<float>(area.size.x) / static_cast<float>(area.size.y);
    const glm::mat4 clipFromWorld = clipFromWorldOf(view, aspect);
    glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(clipFromWorld));
    glDrawArrays(GL_TRIANGLES, 0, vertices_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glViewport(area.corner.x, area.corner.y, area.size.x, area.size.y);
    glUseProgram(lineProgram_);
    glUniform2i(0, area.corner.x, area.corner.y);
    glUniform1f(1, thickness);
    glBindTextureUnit(0, mask_);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}
