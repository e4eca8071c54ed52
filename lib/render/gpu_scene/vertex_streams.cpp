#include "render/gpu_scene/vertex_streams.h"

#include "render/layout.h"

#include <array>
#include <cstdint>
#include <span>

namespace candela {

namespace {

// A tangent or a coordinate pair starts at the first float, a colour at the fifth.
constexpr std::array<float, 8> detail{0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f, 1.0f};
constexpr std::size_t colorOffset = 4 * sizeof(float);

}  // namespace

void feedFloats(const gl::VertexArray& vertexArray, int location, int components, GLuint binding,
                std::size_t offset) {
    const GLuint name = vertexArray.name();
    const auto index = static_cast<GLuint>(location);
    glEnableVertexArrayAttrib(name, index);
    glVertexArrayAttribFormat(name, index, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(name, index, binding);
}

void feedDraws(const gl::VertexArray& vertexArray, GLuint binding, const gl::Buffer& draws) {
    const GLuint name = vertexArray.name();
    glVertexArrayVertexBuffer(name, binding, draws.name(), 0, 2 * sizeof(std::uint32_t));
    glVertexArrayBindingDivisor(name, binding, 1);
    glEnableVertexArrayAttrib(name, layout::DRAW_ATTRIBUTE);
    glVertexArrayAttribIFormat(name, layout::DRAW_ATTRIBUTE, 2, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(name, layout::DRAW_ATTRIBUTE, binding);
}

DefaultDetail::DefaultDetail() : vertex_("default detail") {
    vertex_.upload(std::span<const float>(detail));
}

void DefaultDetail::describe(const gl::VertexArray& vertexArray, GLuint binding) const {
    // A stride of 0 gives every vertex the same element.
    glVertexArrayVertexBuffer(vertexArray.name(), binding, vertex_.name(), 0, 0);
    feedFloats(vertexArray, layout::TANGENT_ATTRIBUTE, 4, binding, 0);
    feedFloats(vertexArray, layout::UV0_ATTRIBUTE, 2, binding, 0);
    feedFloats(vertexArray, layout::UV1_ATTRIBUTE, 2, binding, 0);
    feedFloats(vertexArray, layout::COLOR_ATTRIBUTE, 4, binding, colorOffset);
}

}  // namespace candela
