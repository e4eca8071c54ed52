#include "gl_drawing.h"

#include <glm/gtc/matrix_transform.hpp>

namespace {

struct Vertex {
    glm::vec3 position, normal;
};

/// Of the vertices that a submesh draws.
candela::Bounds submeshBounds(const candela::Mesh& mesh, const candela::Submesh& submesh,
                              const glm::mat4& world) {
    candela::Bounds bounds;
    for (std::uint32_t i = 0; i < submesh.indexCount; ++i) {
        const glm::vec3 position =
            world * glm::vec4(mesh.positions[mesh.indices[submesh.firstIndex + i]], 1.0f);
        bounds.add({position, position});
    }
    return bounds;
}

}  // namespace

Target::Target(GLenum format, int width, int height) {
    glCreateTextures(GL_TEXTURE_2D, 1, &name_);
    glTextureStorage2D(name_, 1, format, width, height);
    glTextureParameteri(name_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(name_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Target::~Target() {
    glDeleteTextures(1, &name_);
}

Screen::Screen(int width, int height) : color_(GL_RGBA8, width, height) {
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, color_.name(), 0);
}

Screen::~Screen() {
    glDeleteFramebuffers(1, &framebuffer_);
}

SceneGeometry::SceneGeometry(const candela::Scene& scene) {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> firstVertex, firstIndex;
    for (const candela::Mesh& mesh : scene.meshes) {
        firstVertex.push_back(static_cast<std::uint32_t>(vertices.size()));
        firstIndex.push_back(static_cast<std::uint32_t>(indices.size()));
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            vertices.push_back({mesh.positions[i], mesh.normals[i]});
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        if (!scene.nodes[n].mesh) continue;
        const std::uint32_t mesh = *scene.nodes[n].mesh;
        for (const candela::Submesh& submesh : scene.meshes[mesh].submeshes) {
            if (submesh.topology != candela::Topology::triangles) continue;
            const candela::Material material =
                submesh.material ? scene.materials[*submesh.material] : candela::Material{};
            draws_.push_back({world[n],
                              glm::vec3(material.baseColor),
                              {material.metallic, material.roughness},
                              submesh.indexCount,
                              (std::uintptr_t{firstIndex[mesh]} + submesh.firstIndex) * sizeof(std::uint32_t),
                              static_cast<std::int32_t>(firstVertex[mesh])});
            bounds_.push_back(submeshBounds(scene.meshes[mesh], submesh, world[n]));
        }
    }
    glCreateBuffers(1, &vertices_);
    glNamedBufferStorage(vertices_, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                         vertices.data(), 0);
    glCreateBuffers(1, &indices_);
    glNamedBufferStorage(indices_, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                         indices.data(), 0);
    glCreateVertexArrays(1, &vertexArray_);
    glVertexArrayElementBuffer(vertexArray_, indices_);
    glVertexArrayVertexBuffer(vertexArray_, 0, vertices_, 0, sizeof(Vertex));
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexArrayAttrib(vertexArray_, attribute);
        glVertexArrayAttribFormat(vertexArray_, attribute, 3, GL_FLOAT, GL_FALSE,
                                  attribute * static_cast<GLuint>(sizeof(glm::vec3)));
        glVertexArrayAttribBinding(vertexArray_, attribute, 0);
    }
}

SceneGeometry::~SceneGeometry() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &vertices_);
    glDeleteBuffers(1, &indices_);
}

void SceneGeometry::draw() const {
    glBindVertexArray(vertexArray_);
    for (const Draw& draw : draws_) {
        glUniform3f(1, draw.color.r, draw.color.g, draw.color.b);
        glUniform2f(2, draw.metallicRoughness.x, draw.metallicRoughness.y);
        drawElements(draw);
    }
}

std::uint64_t SceneGeometry::draw(std::span<const std::uint32_t> draws) const {
    glBindVertexArray(vertexArray_);
    std::uint64_t triangles = 0;
    for (const std::uint32_t index : draws) {
        drawElements(draws_[index]);
        triangles += draws_[index].count / 3;
    }
    return triangles;
}

void SceneGeometry::drawElements(const Draw& draw) const {
    glUniformMatrix4fv(0, 1, GL_FALSE, &draw.world[0][0]);
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(draw.count), GL_UNSIGNED_INT,
                             reinterpret_cast<const void*>(draw.offset), draw.baseVertex);
}

glm::mat4 textbookClipFromWorld(const candela::CameraView& view, int width, int height) {
    const glm::mat4 projection = glm::perspective(
        view.verticalFov, static_cast<float>(width) / static_cast<float>(height), 0.1f, 1000.0f);
    return projection * glm::inverse(view.worldFromCamera);
}
