#pragma once

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/frustum.h"
#include "render/lighting/fullscreen/fullscreen_technique.h"
#include "render/lighting/lighting_technique.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// Sorts light volumes into batches in which no two overlap on the screen, so that one stencil value serves
/// all volumes of a batch in one draw.
class LightBatches {
  public:
    struct Input {
        const LightReaches& reaches;
        std::size_t first, end;  ///< The lights of `reaches` to take.
        const Frustum& frustum;
        float proxyRadius;  ///< `SphereProxy::radius`.
        int width, height;  ///< Of the picture, pixels.
    };

    /// Assigns the lights in view. Lights whose volume reaches the near plane, and those that find no free
    /// batch, become `unsorted`.
    void assign(const Input& input);

    /// The lights of batch 0, then those of batch 1, and so on, then the unsorted ones.
    std::span<const std::uint32_t> lights() const { return lights_; }
    /// Where in `lights` each batch ends.
    std::span<const std::uint32_t> batchEnds() const { return ends_; }

  private:
    static constexpr std::uint32_t batchWords = 16;  ///< 1,024 batches at most.
    static constexpr int cellSize = 32;              ///< Pixels: overlap is tested per cell.

    std::uint32_t freeBatch(const Frustum::Rectangle& bounds);

    int columns_ = 0, rows_ = 0;
    std::vector<std::uint64_t> taken_;  ///< A bit for each batch in each cell.
    std::vector<std::vector<std::uint32_t>> batches_;
    std::vector<std::uint32_t> unsorted_, lights_, ends_;
};

/// A convex polyhedron of triangles around the unit sphere: the shape of a rasterised light volume.
struct SphereProxy {
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise from outside.
    float radius = 1.0f;                                  ///< Of the sphere around the polyhedron.
};

/// Rasterises the bounding volumes of lights into the bound framebuffer, whose depth is the scene's and whose
/// stencil is 0.
class LightVolumes {
  public:
    LightVolumes();

    /// Sorts the lights in view into batches and uploads the lists. Returns how many are in view.
    std::uint32_t prepare(const LightingInputs& inputs);

    /// Bytes of the lists.
    std::uint64_t listBytes() const { return lightIndices_.size() * sizeof(std::uint32_t); }

    /// Draws each volume where the surface lies inside it: front faces mark in the stencil the pixels whose
    /// surface lies behind them; back faces draw, of those, the pixels whose surface lies before them. A
    /// volume that reaches the near plane is drawn by its back faces alone, so that the camera may be
    /// inside any number of them.
    void drawInside(const gl::Program& pointProgram, const gl::Program& spotProgram) const;
    /// Draws the back faces of all volumes in view where the surface lies before them.
    void drawBackFaces(const gl::Program& pointProgram, const gl::Program& spotProgram) const;

  private:
    /// Part of `lightIndices_`.
    struct Run {
        std::uint32_t first, count;
    };
    /// The points or the spots.
    struct Kind {
        std::vector<Run> batches;
        Run unsorted{};
        Run all{};
    };

    Kind append(const LightingInputs& inputs, std::uint32_t firstLight, std::uint32_t count);
    void drawKind(const Kind& kind, const gl::Program& program) const;
    void draw(const Run& run) const;

    LightBatches batches_;
    Kind points_, spots_;
    std::vector<std::uint32_t> lightIndices_;
    bool hasFarPlane_ = false;  ///< The view of the last `prepare`.
    SphereProxy proxy_;
    gl::Program mark_;
    gl::Buffer vertices_, triangles_, indexBuffer_;
    gl::VertexArray vertexArray_;
};

/// A copy of the G-buffer's depth with a stencil, and a framebuffer of it with a colour target. The G-buffer
/// itself has no stencil, which would cost every other technique a third more memory traffic.
class StencilledDepth {
  public:
    StencilledDepth();

    /// Copies the depth, clears the stencil to 0, and binds a framebuffer of both with `color`.
    void bind(const GBufferTargets& targets, const gl::Texture& color);

  private:
    struct Sized {
        int width, height;
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    void resize(const GBufferTargets& targets, const gl::Texture& color);

    gl::Program copy_;
    gl::VertexArray vertexArray_;
    std::optional<Sized> sized_;
};

/// Rasterises each light's bounding volume against the depth buffer and shades the pixels whose surface lies
/// inside it.
class VolumesTechnique final : public LightingTechnique {
  public:
    explicit VolumesTechnique(const FullscreenPass& fullscreen);

    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    std::uint64_t lightListBytes() const override { return volumes_.listBytes(); }
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;

  private:
    const FullscreenPass& fullscreen_;
    ModelPrograms pointPrograms_, spotPrograms_;
    LightVolumes volumes_;
    StencilledDepth depth_;
};

}  // namespace candela
