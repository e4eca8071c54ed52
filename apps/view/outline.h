#pragma once

#include <candela/camera.h>
#include <candela/scene.h>
#include <candela/subdivider.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// A line around what a node and the nodes below it show, over the picture, also where something else hides
/// them. Of cages it is that of the limit surface, or of their polygons without a subdivider.
class Outline {
  public:
    Outline() = default;
    Outline(const Outline&) = delete;
    Outline& operator=(const Outline&) = delete;
    /// The context has to be current.
    ~Outline();

    struct Target {
        const candela::Scene& scene;
        std::uint32_t node = 0;
        double time = 0.0;           ///< Seconds.
        std::uint64_t revision = 0;  ///< Differs where the scene does.
        std::optional<candela::Subdivider> subdivider = {};
    };
    /// A rectangle of the window's framebuffer, in pixels: `corner` is its lower left one.
    struct Area {
        glm::ivec2 corner{0}, size{1};
    };
    /// Draws to the window. Thickness in pixels.
    void draw(const Target& target, const candela::CameraView& view, const Area& area, float thickness);
    /// What was drawn last is another scene's.
    void forget() {
        drawn_.reset();
        refined_.clear();
    }

  private:
    void create();
    void resize(const glm::ivec2& size);
    void upload(const Target& target);
    std::vector<glm::vec3> shownTriangles(const Target& target);
    void addCage(const candela::Cage& cage, std::uint32_t index, const candela::PosedPoints& posed,
                 const Target& target, std::vector<glm::vec3>& triangles);

    struct Key {
        std::uint32_t node;
        double time;
        std::uint64_t revision;
        bool operator==(const Key&) const = default;
    };
    std::optional<Key> drawn_;
    std::map<std::uint32_t, candela::RefinedCage> refined_;  ///< By the index of the cage.
    glm::ivec2 size_{0};
    unsigned maskProgram_ = 0, lineProgram_ = 0, vertexArray_ = 0, buffer_ = 0, mask_ = 0, framebuffer_ = 0;
    int vertices_ = 0;
};
