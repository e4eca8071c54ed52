#pragma once

#include <candela/camera.h>
#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/frame_data.h>
#include <candela/frame_settings.h>
#include <candela/gpu_scene.h>
#include <candela/pending.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

class Frame;

/// Draws frames of scenes. Holds every target and program, and creates none while the size stays. In a host's
/// context it leaves the bound state as it found it. Every function throws `Error` (environment) when the
/// context is not current on the calling thread, and (badInput) after a move.
class CANDELA_API Renderer {
  public:
    /// Throws `Error` (environment) when `CANDELA_INSTRUCTION_SET` names none that this processor runs.
    explicit Renderer(const Context& context);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws `scene` from `view`: geometry, lights, environment and layers, or the debug view instead
    /// of light. Applies the edits made to the scene since its last frame. Throws `Error`: badInput when the
    /// view or the settings break what they state or the scene belongs to another context, limit when the
    /// size or the lists of lights are beyond the device.
    Frame render(GpuScene& scene, const CameraView& view, const FrameSettings& settings = {});

    /// Draws a frame of each view, such as those of `stereoViews` or `cubeViews`, and calls `use` with it and
    /// the number of its view before the next one is drawn. Throws as `render`, and what `use` throws.
    void renderViews(GpuScene& scene, std::span<const CameraView> views, const FrameSettings& settings,
                     const std::function<void(std::size_t view, const Frame& frame)>& use);

    /// Makes the context that it was created for current on this thread, also after the end of the `Context`,
    /// which it keeps alive; does nothing to a host's context.
    void makeCurrent() const;

    /// The names `Frame::aovs` takes, in the order of the EXR file; without `ambient_occlusion` in a library
    /// without shadows.
    static std::vector<std::string> aovNames();

  private:
    friend class Accumulator;
    friend class Frame;
    struct State;
    std::shared_ptr<State> state_;
};

/// Shows radiance that a host has in memory, such as a panorama: 8-bit RGBA, rows from the top, with half a
/// code value of dither, as `Frame::displayPicture` shows a frame on a software device. Needs no context.
/// Throws `Error` (badInput) when there are not four numbers a pixel.
CANDELA_API std::vector<std::uint8_t> displayPicture(const HdrImage& radiance,
                                                     const DisplayTransform& transform);

/// A frame that was drawn. It refers to the targets of its renderer, which the renderer's next frame
/// overwrites: from then on every function throws `Error` (badInput). Functions that draw parts of the scene
/// again say so; they throw `Error` (badInput) when the scene has been destroyed. The context has to be
/// current.
class CANDELA_API Frame {
  public:
    Frame(Frame&&) noexcept;
    Frame& operator=(Frame&&) noexcept;
    ~Frame();

    int width() const;
    int height() const;
    /// The technique that drew it, never `automatic`.
    Technique technique() const;
    /// What ran the technique `tiles`, never `automatic`; none where another technique or a debug view drew
    /// it.
    std::optional<TileBackend> tileBackend() const;

    /// Shows the frame through `transform`, with half a code value of dither, in the host's framebuffer; a
    /// debug view without either. Overlays lie over it. Throws `Error` (badInput) when the framebuffer does
    /// not exist or is incomplete.
    void display(const DisplayTransform& transform, const FrameTarget& target) const;
    /// Shows the frame and reads it back: 8-bit RGBA, rows from the top.
    std::vector<std::uint8_t> displayPicture(const DisplayTransform& transform) const;

    /// How many layers of transparent surfaces the frame has, and what they leave out. All 0 of a debug view.
    LayerCounts layerCounts() const;

    /// Reads the radiance back, without overlays; of a debug view its code values.
    HdrImage radiance() const;
    /// `displayPicture` without waiting for it: through a pixel buffer behind a fence, or, where the radiance
    /// is in memory, on another thread.
    PendingPicture readDisplayPicture(const DisplayTransform& transform) const;
    /// `radiance` without waiting for it.
    PendingRadiance readRadiance() const;

    /// The textures of the frame, by name: radiance, depth and the words of the G-buffer. They are the
    /// renderer's: their content is the frame's until the renderer draws again, and their names are valid
    /// until it draws with another size or other parts of the G-buffer, or is destroyed. Hosts read them
    /// only, after candela's calls in the same context (in a context that shares objects with this one, after
    /// a fence). Radiance that lighting has left in memory is uploaded once.
    std::vector<FrameTexture> textures() const;
    /// Shows the frame as `display` does in a texture of its size, "display": GL_RGBA8, code values of the
    /// display. Its content is valid until the next frame or the next call of a function that shows one.
    FrameTexture displayTexture(const DisplayTransform& transform) const;
    /// Writes the depth of the opaque surfaces into the depth buffer of a framebuffer, which may be
    /// multisampled, as the host's projection has it; the far plane where there is no surface. Depths beyond
    /// the host's planes are clamped. Other buffers keep their content. Throws `Error` (badInput) when the
    /// framebuffer does not exist or is incomplete, or a plane is out of its range.
    void writeDepth(const FrameTarget& target, const DepthConvention& convention) const;
    /// Reads AOVs back. Of transparent surfaces they show those with an alpha over a half, as masks; a frame
    /// that has some is drawn again for it. Emission, counts of lights and the light of the environment are
    /// drawn again, ambient occlusion is traced. Throws `Error` (badInput) when a name is unknown or given
    /// twice, and (environment) when `ambient_occlusion` is asked of a library without shadows
    /// (`hasShadows`).
    std::vector<Aov> aovs(const std::vector<std::string>& names) const;

    /// What the pixel of column `x` and row `y` (from the top) shows: the same surface as of the AOVs; none
    /// on the background. Draws the pixel again. Throws `Error` (badInput) when there is no such pixel.
    std::optional<PixelProbe> probe(int x, int y) const;
    /// The surfaces that a rectangle shows, by node and material: those of more pixels first. Draws these
    /// pixels again. Throws `Error` (badInput) when the rectangle is empty or not within the picture.
    std::vector<PickedSurface> pick(const PictureRectangle& rectangle) const;
    /// The largest number of lights at any pixel, where the frame shows `DebugView::lightCount` or
    /// `DebugView::shadowedCount`, as the end of the heat map; 0 otherwise.
    std::uint32_t maxLightCount() const;

    /// Counts light-pixel pairs of the opaque surfaces by drawing again. Of a debug view none was evaluated.
    PairCounts countPairs() const;
    /// Occlusion rays of the frame's opaque surfaces; all 0 without shadows and of a debug view. Where
    /// shaders have traced them, they are counted by drawing again, and `raysTraced` is `raysAsked`: shaders
    /// test no blocks.
    ShadowCounts shadowCounts() const;
    /// What each pass took, in the order they ran. Waits for the frame to end. Of samples that were drawn
    /// together on a software device (`Accumulator::addSamples`) it is the sum over these, where what runs
    /// at the same time counts once.
    std::vector<PassTime> passTimes() const;

  private:
    friend class Accumulator;
    friend class Renderer;
    Frame(std::shared_ptr<Renderer::State> renderer, std::weak_ptr<GpuScene::State> scene,
          std::uint64_t number);

    /// The renderer's state, which still holds this frame.
    Renderer::State& state() const;
    std::shared_ptr<GpuScene::State> scene() const;

    std::shared_ptr<Renderer::State> renderer_;
    std::weak_ptr<GpuScene::State> scene_;
    std::uint64_t number_ = 0;
};

}  // namespace candela
