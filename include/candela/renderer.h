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
CANDELA_API const char* toString(DebugView show);

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

struct FrameInputs {
    int width = 1280, height = 720;  ///< Pixels, 1 or more each.
    CameraView view;
    BrdfModel brdf = BrdfModel::course;
    Technique technique = Technique::automatic;
    DebugView show = DebugView::none;
    Overlays overlays = {};
    TileBackend tileBackend = TileBackend::automatic;  ///< Read for `tiles` only.
};

struct PassTime {
    std::string name;
    double milliseconds = 0.0;
};

/// Pairs of one pixel with one light; see `Renderer::countPairs`.
struct PairCounts {
    std::uint64_t lightsVisible = 0;   ///< Lights whose reach meets the view frustum.
    std::uint64_t pairsLit = 0;        ///< The pixel lies within the light's range.
    std::uint64_t pairsEvaluated = 0;  ///< The shader ran its BRDF.
    std::uint64_t lightsDropped = 0;   ///< Lights that did not fit and were left out.
    std::uint64_t lightListBytes = 0;  ///< Memory of the lists that bring lights to pixels.
};

/// A picture in the working space: RGBA, rows from the top. A is 1 where a surface is and 0 on the
/// background.
struct HdrImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

/// The frame's arbitrary output variables: width × height × components floats, rows from the top.
struct Aov {
    std::string name;                        ///< As in `gbufferChannels`, and "Z", "P", "light_count".
    std::vector<std::string> channels;       ///< Names as in the EXR file.
    std::vector<std::vector<float>> values;  ///< One array a channel.
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
    glm::vec3 radiance{0.0f};      ///< As `Renderer::radiance` has it: of a data view its code values.
    std::uint32_t lightCount = 0;  ///< Lights in whose range it lies.
};

/// Draws frames of a `GpuScene`. Holds every buffer and program; makes none anew while the size stays. Leaves
/// the context's bound state as it found it.
class CANDELA_API Renderer {
  public:
    explicit Renderer(const Context& context);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws radiance: geometry pass, then lighting pass. A data view is drawn instead of the lighting pass,
    /// and no light is evaluated. Throws `Error` (limit) when the size is beyond the device.
    void render(const GpuScene& scene, const FrameInputs& inputs);

    /// Shows the last frame through `transform`, with half a code value of dither, in the host's framebuffer;
    /// a data view without either. Overlays lie over it.
    void display(const DisplayTransform& transform, const FrameTarget& target);
    /// Shows the last frame and reads it back: 8-bit RGBA, rows from the top.
    std::vector<std::uint8_t> displayPicture(const DisplayTransform& transform);

    /// Reads the last frame's radiance back, without overlays; of a data view its code values.
    HdrImage radiance();
    /// Reads AOVs of the last frame back. Throws `Error` (badInput) naming those there are when a name is
    /// unknown.
    std::vector<Aov> aovs(const GpuScene& scene, const std::vector<std::string>& names);
    /// The names `aovs` takes, in the order of the EXR file.
    static std::vector<std::string> aovNames();

    /// What the pixel of column `x` and row `y` (from the top) of the last frame shows; none on the
    /// background. Throws `Error` (badInput) when there is no such pixel.
    std::optional<PixelProbe> probe(const GpuScene& scene, int x, int y);
    /// The most lights of any pixel of the last frame, if that showed `DebugView::lightCount`: what the heat
    /// map's end stands for.
    std::uint32_t maxLightCount() const;

    /// Counts the last frame's pairs in a drawing of its own, outside timed frames. Of a data view none was
    /// evaluated.
    PairCounts countPairs(const GpuScene& scene);
    /// What each pass of the last frame took, in the order they ran. Waits for the frame to end.
    std::vector<PassTime> passTimes();
    /// The technique the last frame used, never `automatic`.
    Technique technique() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace candela
