#pragma once

#include <candela/brdf.h>
#include <candela/camera.h>
#include <candela/export.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

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
    // The rest show data as colours. They are drawn as code values of the display: neither the display
    // transform nor the exposure applies.
    normals,    ///< World-space normals: 0.5 + 0.5 n.
    level,      ///< The subdivision level of each cage, see `levelColor`; meshes are grey.
    baseColor,  ///< Clamped to 0..1, sRGB-encoded.
    metallic,   ///< As grey.
    roughness,  ///< Perceptual roughness as grey.
    depth,      ///< Grey, near is bright: near / (near + distance), near the distance of the closest surface.
    emission,   ///< Clamped to 0..1, sRGB-encoded.
    lightCount,  ///< Lights in whose range the pixel lies, see `heatColor`; full scale is the maximum in the
                 ///< frame.
    shadowedCount,  ///< Lights hidden from the pixel, in the same way: the AOV `shadowed_count`.
};

/// All debug views but `none`, in the order of the enumeration.
CANDELA_API std::span<const DebugView> debugViews();

/// The name on the command line: "picture", "normals", "level", "base_color", "metallic", "roughness",
/// "depth", "emission", "light_count", "shadowed_count".
CANDELA_API const char* toString(DebugView debugView);

/// The colour of a subdivision level, display code values: 0 (polygons) to `maxSubdivisionLevel`. Throws
/// `Error` (badInput) beyond.
CANDELA_API glm::vec3 levelColor(std::uint32_t level);
/// The heat map: from black at 0 over blue, green and yellow to red at 1; clamped, NaN is 0. Display code
/// values.
CANDELA_API glm::vec3 heatColor(float value);

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

/// Whether lights cast shadows.
enum class Shadows {
    automatic,  ///< `on` where `hasShadows`, else `off`.
    off,
    on,  ///< Every light that `castsShadow` is traced at every pixel that it lights.
};

/// The name on the command line: "auto", "off", "on".
CANDELA_API const char* toString(Shadows shadows);

/// Was the library built with shadows (the CMake option CANDELA_SHADOWS)?
CANDELA_API bool hasShadows();

/// The rays of the AOV `ambient_occlusion`.
struct AmbientOcclusionSettings {
    float distance = 1.0f;    ///< Metres, finite and over 0: what is farther from the surface hides nothing.
    std::uint32_t rays = 64;  ///< At each pixel, 1 to 4096.
};

/// The rays that find how much of the scene's environment a pixel sees, in frames with shadows.
struct EnvironmentOcclusionSettings {
    /// At each pixel, 1 to 4096. Neighbouring pixels share what they find, and each `FrameSettings::sample`
    /// has rays of its own.
    std::uint32_t rays = 1;
};

inline constexpr std::uint32_t maxLayers = 64;

/// The part of a larger picture that a frame is. Parts are the same as that picture, to the rounding of their
/// projection, where `x` and the way from the lower edge are multiples of 16; within 16 pixels of a part's
/// edge ambient occlusion of the environment and refraction lack what lies beyond, so that hosts draw a
/// margin and cut it off (docs/embedding.md).
struct PictureRegion {
    int width = 0, height = 0;  ///< Of the whole picture, which the view describes: 1 to 2^20 pixels.
    int x = 0, y = 0;           ///< Of the frame's upper left pixel in it; it may lie outside.
};

/// The values in a depth buffer of a host.
struct DepthConvention {
    enum class Direction {
        reversed,  ///< 1 at the near plane, 0 at the far plane.
        classic,   ///< 0 at the near plane, 1 at the far plane: OpenGL's default, also Vulkan's and
                   ///< Direct3D's.
    };
    Direction direction = Direction::classic;
    /// Planes of the host's projection, metres; none: those of the view, whose far plane may be at infinity.
    std::optional<float> nearPlane = {}, farPlane = {};
};

/// What a host has drawn already, at the frame's size. Surfaces of the scene hide it, and it hides them, by
/// depth. Its pixels are those of an unlit surface: no light falls on them and they cast no shadow. Where its
/// depth is that of the far plane its colour lies behind everything, also behind the environment.
struct HostSurfaces {
    /// Names of textures of type GL_TEXTURE_2D in the current context, which candela reads only.
    std::uint32_t radiance = 0;  ///< Scene-linear, working space; 0: black.
    std::uint32_t depth = 0;  ///< A depth texture or one whose red channel is the depth; 0: no such surfaces.
    DepthConvention convention = {};
};

/// A frame in the middle of being drawn, for a pass of the host (`FrameHooks`).
struct FrameStage {
    std::uint32_t framebuffer = 0;  ///< Bound for drawing and reading; its viewport is set.
    int width = 0, height = 0;      ///< Pixels.
    glm::mat4 clipFromWorld{1.0f};  ///< Reversed depth, 0 to 1, as glClipControl is set; exactly the frame's.
    glm::mat4 worldFromCamera{1.0f};
};

/// Passes of a host within a frame. OpenGL is in its initial state then, but for clip control (lower left,
/// zero to one) and what `FrameStage` says. They may change any of it and need restore nothing; they must
/// leave alone candela's objects, other than what they draw into the framebuffer. Exceptions pass through
/// `render`. docs/embedding.md has examples.
struct FrameHooks {
    /// After the geometry of opaque surfaces, before light. The framebuffer is the G-buffer: outputs as
    /// docs/gbuffer.md has them, radiance (RGBA32F) at 1, and depth. A fragment that writes 0 to both words
    /// of output 0 is an unlit surface, whose radiance is what it writes to output 1.
    std::function<void(const FrameStage&)> afterGeometry = {};
    /// After light, environment and layers, before overlays and `Frame::display`. The framebuffer has the
    /// radiance (RGBA32F, working space, output 0) and depth: what is drawn with a depth test of GL_GREATER
    /// is in front of and behind the scene's opaque surfaces.
    std::function<void(const FrameStage&)> beforeDisplay = {};
};

/// How a frame is drawn.
struct FrameSettings {
    int width = 1280, height = 720;  ///< Pixels, 1 or more each.
    BrdfModel brdf = BrdfModel::course;
    Technique technique = Technique::automatic;
    DebugView debugView = DebugView::none;
    Overlays overlays = {};
    TileBackend tileBackend = TileBackend::automatic;  ///< Read for `tiles` only.
    Shadows shadows = Shadows::automatic;
    AmbientOcclusionSettings ambientOcclusion = {};  ///< Read for its AOV only.
    /// The number of the frame among those that are averaged (candela/sampling.h): what is sampled at random
    /// takes the sample of this number, and lights with a radius stand at a point of their sphere. 0: they
    /// stand at its centre.
    std::uint32_t sample = 0;
    EnvironmentOcclusionSettings environmentOcclusion = {};
    /// Widens roughness where the shading normal varies from pixel to pixel, so that highlights of small
    /// bumps do not sparkle; see docs/lighting.md. Surfaces with one normal stay as they are.
    bool specularAntialiasing = true;
    /// The maximum number of layers of transparent surfaces, 0 to `maxLayers`. What lies beyond is left out
    /// and counted (`Frame::layerCounts`).
    std::uint32_t layers = 8;
    float pointSize = 3.0f;  ///< Side of the square that a point covers, pixels, finite and over 0.
    float lineWidth = 1.0f;  ///< Pixels, finite and over 0.
    /// The frame is this part of a larger picture; none: it is all of it.
    std::optional<PictureRegion> region = {};
    /// The view of the frame before, for the AOV `motion`; none: that of this frame.
    std::optional<CameraView> previousView = {};
    HostSurfaces hostSurfaces = {};
    FrameHooks hooks = {};
};

}  // namespace candela
