#pragma once

#include <candela/brdf.h>
#include <candela/camera.h>
#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/gpu_scene.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// How lights are brought to pixels. All give the same picture; see docs/lighting.md.
enum class Technique {
    automatic,   ///< The fastest on all devices: `tiles`.
    volumes,     ///< Each light's bounding volume is rasterised against the depth buffer.
    tiles,       ///< Lights are binned to screen tiles cut by depth, and each pixel iterates over its list.
    fullscreen,  ///< Every light at every pixel: the reference.
};

/// The technique's name on the command line: "auto", "volumes", "tiles", "fullscreen".
CANDELA_API const char* toString(Technique technique);

/// What runs the technique `tiles`. All give the same picture.
enum class TileBackend {
    automatic,  ///< `cpu` where `Context::isSoftware`, else `compute`.
    cpu,        ///< Vector code on the processor's cores.
    compute,    ///< Compute shaders.
};

/// The name on the command line: "auto", "cpu", "compute".
CANDELA_API const char* toString(TileBackend backend);

/// What a frame shows.
enum class DebugView {
    none,  ///< The lit scene.
    // The rest are data: numbers as colours. They are drawn as the display's code values, so that no display
    // transform and no exposure changes them.
    normals,    ///< World-space normals: 0.5 + 0.5 n.
    level,      ///< The level to which each cage is refined, see `levelColor`; meshes are grey.
    baseColor,  ///< Clamped to 0..1, sRGB-encoded.
    metallic,   ///< As grey.
    roughness,  ///< Perceptual roughness as grey.
    depth,      ///< Grey, near is bright: near / (near + distance), near the distance of the closest surface.
    emission,   ///< Clamped to 0..1, sRGB-encoded.
    lightCount,  ///< Lights in whose range the pixel lies, see `heatColor`; full scale is the frame's most.
};

/// The name on the command line: "picture", "normals", "level", "base_color", "metallic", "roughness",
/// "depth", "emission", "light_count".
CANDELA_API const char* toString(DebugView debugView);

/// The colour of a level of subdivision, display code values. 0 (polygons) to `maxSubdivisionLevel`.
CANDELA_API glm::vec3 levelColor(std::uint32_t level);
/// The heat map: from black at 0 over blue, green and yellow to red at 1. Display code values.
CANDELA_API glm::vec3 heatColor(float share);

/// Lines drawn over the finished picture where the surface does not hide them.
struct Overlays {
    bool wireframe = false;  ///< Edges of all triangles; of refined cages the edges of their faces.
    bool cage = false;       ///< Edges of the control polyhedra.
};

/// Where a finished picture goes.
struct FrameTarget {
    std::uint32_t framebuffer = 0;  ///< A framebuffer name of the current context; 0 is the window's.
    int x = 0, y = 0;               ///< Lower left corner of the picture in it, pixels.
};

/// How a frame is drawn.
struct FrameSettings {
    int width = 1280, height = 720;  ///< Pixels, 1 or more each.
    BrdfModel brdf = BrdfModel::course;
    Technique technique = Technique::automatic;
    DebugView debugView = DebugView::none;
    Overlays overlays = {};
    TileBackend tileBackend = TileBackend::automatic;  ///< Read for `tiles` only.
};

struct PassTime {
    std::string name;
    double milliseconds = 0.0;
};

/// Light-pixel pairs; see `Frame::countPairs`.
struct PairCounts {
    std::uint64_t lightsVisible = 0;   ///< Lights whose range meets the view frustum.
    std::uint64_t pairsLit = 0;        ///< The pixel lies within the light's range.
    std::uint64_t pairsEvaluated = 0;  ///< The shader evaluated the BRDF.
    std::uint64_t lightsDropped = 0;   ///< Lights that did not fit and were left out.
    std::uint64_t lightListBytes = 0;  ///< Memory of the lists that bring lights to pixels.
};

/// Radiance in the working space: RGBA, rows from the top. A is 1 where a surface is and 0 on the background.
struct HdrImage {
    int width = 0, height = 0;
    std::vector<float> rgba;  ///< 4 × width × height.
};

/// An arbitrary output variable of a frame.
struct Aov {
    std::string name;                        ///< As in `gbufferChannels`, and "Z", "P", "light_count".
    std::vector<std::string> channels;       ///< Names as in the EXR file.
    std::vector<std::vector<float>> values;  ///< One array a channel: width × height, rows from the top.
};

/// What a pixel of a frame shows.
struct PixelProbe {
    std::uint32_t node = 0;     ///< The node whose mesh or cage it is.
    float z = 0.0f;             ///< Distance along the view axis, metres.
    glm::vec3 position{0.0f};   ///< World, metres.
    glm::vec3 normal{0.0f};     ///< World, unit length; (0, 0, 0) on an unlit surface.
    glm::vec3 baseColor{0.0f};  ///< Linear, working space.
    float metallic = 0.0f, roughness = 0.0f;
    glm::vec3 emission{0.0f};      ///< Radiance, working space.
    glm::vec3 radiance{0.0f};      ///< As `Frame::radiance`: of a debug view its code values.
    std::uint32_t lightCount = 0;  ///< Lights in whose range it lies.
};

class Frame;

/// Draws frames of scenes. Holds every target and program, and creates none while the size stays. In a host's
/// context it leaves the bound state as it found it. Every function throws `Error` (environment) when the
/// context is not current on the calling thread, and (badInput) after a move.
class CANDELA_API Renderer {
  public:
    explicit Renderer(const Context& context);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws `scene` from `view`: geometry pass, then lighting pass, or the debug view instead of it. Applies
    /// the edits made to the scene since its last frame. Throws `Error`: badInput when the view or the settings
    /// break what they state or the scene belongs to another context, limit when the size or the lists of
    /// lights are beyond the device.
    Frame render(GpuScene& scene, const CameraView& view, const FrameSettings& settings = {});

    /// The names `Frame::aovs` takes, in the order of the EXR file.
    static std::vector<std::string> aovNames();

  private:
    friend class Frame;
    struct State;
    std::shared_ptr<State> state_;
};

/// A frame that was drawn. It refers to the targets of its renderer, which the renderer's next frame
/// overwrites: from then on every function throws `Error` (badInput). Functions that draw parts of the scene
/// again say so; they throw `Error` (badInput) when the scene has been destroyed. The context has to be current.
class CANDELA_API Frame {
  public:
    Frame(Frame&&) noexcept;
    Frame& operator=(Frame&&) noexcept;
    ~Frame();

    int width() const;
    int height() const;
    /// The technique that drew it, never `automatic`.
    Technique technique() const;

    /// Shows the frame through `transform`, with half a code value of dither, in the host's framebuffer; a
    /// debug view without either. Overlays lie over it. Throws `Error` (badInput) when the framebuffer does not
    /// exist or is incomplete.
    void display(const DisplayTransform& transform, const FrameTarget& target) const;
    /// Shows the frame and reads it back: 8-bit RGBA, rows from the top.
    std::vector<std::uint8_t> displayPicture(const DisplayTransform& transform) const;

    /// Reads the radiance back, without overlays; of a debug view its code values.
    HdrImage radiance() const;
    /// Reads AOVs back. Emission and light counts are drawn again. Throws `Error` (badInput) when a name is
    /// unknown or given twice.
    std::vector<Aov> aovs(const std::vector<std::string>& names) const;

    /// What the pixel of column `x` and row `y` (from the top) shows; none on the background. Draws the pixel
    /// again. Throws `Error` (badInput) when there is no such pixel.
    std::optional<PixelProbe> probe(int x, int y) const;
    /// The largest number of lights at any pixel, where the frame shows `DebugView::lightCount`, as the end of
    /// the heat map; 0 otherwise.
    std::uint32_t maxLightCount() const;

    /// Counts light-pixel pairs by drawing again. Of a debug view none was evaluated.
    PairCounts countPairs() const;
    /// What each pass took, in the order they ran. Waits for the frame to end.
    std::vector<PassTime> passTimes() const;

  private:
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
