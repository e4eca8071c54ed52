#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "render/lighting/lighting_technique.h"
#include "render/lighting/volumes/light_batches.h"
#include "render/lighting/volumes/sphere_proxy.h"

#include <cstdint>
#include <vector>

namespace candela {

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
    /// volume that reaches the near plane is drawn by its back faces alone, so that the camera may stand
    /// inside any number of them.
    void drawInside(const gl::Program& pointProgram, const gl::Program& spotProgram) const;
    /// Draws the back faces of all volumes in view where the surface lies before them.
    void drawBackFaces(const gl::Program& program) const;

  private:
    /// A run of `lightIndices_`.
    struct Run {
        std::uint32_t first, count;
    };
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
    SphereProxy proxy_;
    gl::Program mark_;
    gl::Buffer vertices_, triangles_, indexBuffer_;
    gl::VertexArray vertexArray_;
};

}  // namespace candela
