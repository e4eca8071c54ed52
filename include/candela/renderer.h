#pragma once

#include <candela/brdf.h>
#include <candela/camera.h>
#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/gpu_scene.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace candela {

/// How lights are brought to pixels. All give the same picture; see docs/lighting.md.
enum class Technique {
    automatic,   ///< The fastest: `tiles`, in the form that a trial at the first frame finds faster on this device.
    volumes,     ///< Each light's bounding volume is rasterised against the depth buffer.
    tiles,       ///< Lights are binned to screen tiles cut by depth, and each pixel walks its list.
    fullscreen,  ///< Every light at every pixel: the reference.
};

/// The technique's name on the command line: "auto", "volumes", "tiles", "fullscreen".
CANDELA_API const char* toString(Technique technique);

/// Where a finished picture goes.
struct FrameTarget {
    std::uint32_t framebuffer = 0;  ///< A framebuffer name of the current context; 0 is the window's.
    int x = 0, y = 0;               ///< Lower left corner of the picture in it, pixels.
};

struct FrameInputs {
    int width = 1280, height = 720;  ///< Pixels, 1 or more each.
    View view;
    BrdfModel brdf = BrdfModel::course;
    Technique technique = Technique::automatic;
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
struct RadiancePicture {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

/// The frame's arbitrary output variables: width × height × components floats, rows from the top.
struct Aov {
    std::string name;                        ///< As in `gbufferChannels`, and "Z", "P", "light_count".
    std::vector<std::string> channels;       ///< Names as in the EXR file.
    std::vector<std::vector<float>> values;  ///< One array a channel.
};

/// Draws frames of a `GpuScene`. Holds every buffer and program; makes none anew while the size stays. Leaves
/// the context's bound state as it found it.
class CANDELA_API Renderer {
  public:
    explicit Renderer(const Context& context);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws radiance: geometry pass, then lighting pass. Throws `Error` (limit) when the size is beyond the
    /// device.
    void render(const GpuScene& scene, const FrameInputs& inputs);

    /// Shows the last frame through `transform`, with half a code value of dither, in the host's framebuffer.
    void display(const DisplayTransform& transform, const FrameTarget& target);
    /// Shows the last frame and reads it back: 8-bit RGBA, rows from the top.
    std::vector<std::uint8_t> displayPicture(const DisplayTransform& transform);

    /// Reads the last frame's radiance back.
    RadiancePicture radiance();
    /// Reads AOVs of the last frame back. Throws `Error` (badInput) naming those there are when a name is
    /// unknown.
    std::vector<Aov> aovs(const GpuScene& scene, const std::vector<std::string>& names);
    /// The names `aovs` takes, in the order of the EXR file.
    static std::vector<std::string> aovNames();

    /// Counts the last frame's pairs in a drawing of its own, outside timed frames.
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
