#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// Where the transparent surfaces of a frame have fragments, layer by layer.
struct LayerExtents {
    struct Layer {
        gl::PixelRectangle rectangle;  ///< Around its pixels; within that of the layer before.
        bool sharesDepths = false;     ///< With the layer before or behind, at some pixel.
    };
    std::vector<Layer> layers;          ///< The nearest first.
    std::uint64_t fragmentsBeyond = 0;  ///< Those that none of `layers` holds.
};

/// The layers of counts of fragments, `limit` at most. `counts` are those of the pixels of `rectangle`, row
/// by row. Ties are not found.
LayerExtents extentsOf(std::span<const std::uint32_t> counts, const gl::PixelRectangle& rectangle,
                       std::uint32_t limit);

/// The depths of the transparent fragments of each pixel, sorted: each layer draws its own surfaces, and no
/// others, by a test for equal depth. Pixels that share a depth are told apart by the numbers of surfaces.
class FragmentLists {
  public:
    FragmentLists();

    /// Lets `draw` record all fragments within `rectangle` (`GeometryPass::recordFragments`), which may take
    /// it several times, and finds the layers, `limit` at most.
    LayerExtents record(int width, int height, const gl::PixelRectangle& rectangle, std::uint32_t limit,
                        const std::function<void()>& draw);
    /// Binds the lists for reading by shaders.
    void bind() const;
    /// Writes the depths of layer `index` into `targets`, within `rectangle`.
    void drawDepth(std::uint32_t index, const GBufferTargets& targets, const gl::PixelRectangle& rectangle);
    /// Lets `draw` find which surfaces a layer holds that shares depths (`GeometryPass::numberSurfaces`).
    /// Layers are numbered one after the other.
    void number(std::uint32_t index, const gl::PixelRectangle& rectangle, const std::function<void()>& draw);

  private:
    struct Storage {
        Storage(int width, int height, int length);
        int width, height, length;
        gl::Texture depths;                  ///< R32UI array of `length`: bits of floats; 0 is none.
        gl::Texture counts;                  ///< R32UI: of all fragments, also of those that lists drop.
        gl::Texture ties;                    ///< R32UI: a word that says that there are any, then bits.
        std::array<gl::Texture, 2> numbers;  ///< R32UI: of the layer that is drawn, and of the one before.
    };
    void fit(int width, int height, std::uint32_t length);
    std::vector<std::uint32_t> recordOnce(const gl::PixelRectangle& rectangle,
                                          const std::function<void()>& draw);
    void findTies(const gl::PixelRectangle& rectangle, LayerExtents& extents);
    void drawTriangle(const gl::Program& program, const gl::PixelRectangle& rectangle) const;

    gl::Program depthProgram_, tieProgram_;
    gl::VertexArray vertexArray_;
    std::optional<Storage> storage_;
};

}  // namespace candela
