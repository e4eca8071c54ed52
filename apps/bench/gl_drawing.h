#pragma once

#include <candela/camera.h>
#include <candela/scene.h>

#include <epoxy/gl.h>

#include <cstdint>
#include <span>
#include <vector>

/// A render target texture.
class Target {
  public:
    Target(GLenum format, int width, int height);
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target();

    GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
};

/// An RGBA8 framebuffer that the finished frame is displayed into.
class Screen {
  public:
    Screen(int width, int height);
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    ~Screen();

    GLuint framebuffer() const { return framebuffer_; }
    GLuint texture() const { return color_.name(); }

  private:
    Target color_;
    GLuint framebuffer_ = 0;
};

/// The meshes of a scene as plain vertex and index buffers, drawn one submesh after the other with uniforms:
/// location 0 the world matrix, 1 the base colour, 2 metallic and roughness. Textures are left out.
class SceneGeometry {
  public:
    explicit SceneGeometry(const candela::Scene& scene);
    SceneGeometry(const SceneGeometry&) = delete;
    SceneGeometry& operator=(const SceneGeometry&) = delete;
    ~SceneGeometry();

    void draw() const;

    /// World boxes of the draws, metres; empty ones where a mesh has no vertices.
    const std::vector<candela::Bounds>& bounds() const { return bounds_; }
    /// Draws these of the draws, by their indices in `bounds`, with the world matrix alone. Returns how many
    /// triangles these are.
    std::uint64_t draw(std::span<const std::uint32_t> draws) const;

  private:
    struct Draw {
        glm::mat4 world;
        glm::vec3 color;
        glm::vec2 metallicRoughness;
        std::uint32_t count;
        std::uintptr_t offset;
        std::int32_t baseVertex;
    };
    void drawElements(const Draw& draw) const;

    std::vector<Draw> draws_;
    std::vector<candela::Bounds> bounds_;
    GLuint vertexArray_ = 0, vertices_ = 0, indices_ = 0;
};

/// A projection with near plane 0.1 m and far plane 1000 m, depth from 0 at the near plane, times the view.
glm::mat4 textbookClipFromWorld(const candela::CameraView& view, int width, int height);
