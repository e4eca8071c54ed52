#pragma once

#include <candela/export.h>
#include <candela/image_file.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

struct PassTime {
    std::string name = {};
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

/// Occlusion rays of a frame, one for each lit pair of a pixel and a light that casts a shadow; see
/// `Frame::shadowCounts`.
struct ShadowCounts {
    std::uint64_t raysAsked = 0;   ///< Pairs whose light may be hidden.
    std::uint64_t raysTraced = 0;  ///< Rays that the occlusion structure has answered one by one.
    std::uint64_t raysSaved = 0;   ///< Rays answered together, for a block of pixels: asked - traced.
};

/// The layers of transparent surfaces of a frame; see `Frame::layerCounts`.
struct LayerCounts {
    std::uint32_t layers = 0;  ///< Drawn; at most `FrameSettings::layers`.
    /// Fragments of transparent surfaces in front of the opaque ones that lie beyond the layers drawn.
    std::uint64_t fragmentsBeyond = 0;
};

/// Radiance in the working space: RGBA, rows from the top. A is the share of the pixel that surfaces cover: 1
/// where an opaque one is, 0 on the background, 1 - the product of 1 - alpha of transparent ones.
struct HdrImage {
    int width = 0, height = 0;
    std::vector<float> rgba = {};  ///< 4 × width × height.
};

/// An arbitrary output variable of a frame.
struct Aov {
    std::string name = {};                   ///< As in `gbufferChannels`.
    std::vector<std::string> channels = {};  ///< Names as in the EXR file.
    /// One array per channel: width × height, rows from the top.
    std::vector<std::vector<float>> values = {};
};

/// A texture that a frame has been drawn into; see `Frame::textures`.
struct FrameTexture {
    std::string name = {};             ///< "radiance", "depth", "surface", "shadow", ...: docs/embedding.md.
    std::uint32_t texture = 0;         ///< Its OpenGL name.
    std::uint32_t target = 0;          ///< GL_TEXTURE_2D.
    std::uint32_t internalFormat = 0;  ///< Such as GL_RGBA32F.
    int width = 0, height = 0;         ///< Pixels; rows from the bottom.
    std::string meaning = {};          ///< Of its values.
};

/// Pixels of a frame: columns from `x` and rows from `y` (from the top).
struct PictureRectangle {
    int x = 0, y = 0, width = 1, height = 1;
};

/// What `Frame::pick` finds.
struct PickedSurface {
    std::uint32_t node = 0;                      ///< The node whose mesh or cage it is.
    std::optional<std::uint32_t> material = {};  ///< Index into `Scene::materials`.
    std::uint64_t pixels = 0;                    ///< How many of the rectangle show it.
    float z = 0.0f;                              ///< The least distance along the view axis of these, metres.
};

/// What a pixel of a frame shows.
struct PixelProbe {
    std::uint32_t node = 0;     ///< The node whose mesh or cage it is.
    float z = 0.0f;             ///< Distance along the view axis, metres.
    glm::vec3 position{0.0f};   ///< World, metres: relative to `Scene::origin`.
    glm::vec3 normal{0.0f};     ///< World, unit length; (0, 0, 0) on an unlit surface.
    glm::vec3 baseColor{0.0f};  ///< Linear, working space.
    float metallic = 0.0f, roughness = 0.0f;
    glm::vec3 emission{0.0f};      ///< Radiance, working space.
    glm::vec3 radiance{0.0f};      ///< As `Frame::radiance`: of a debug view its code values.
    std::uint32_t lightCount = 0;  ///< Lights in whose range it lies.
};

/// Writes radiance as channels R, G, B and A, and AOVs behind them, as one EXR file (candela/image_file.h);
/// `chromaticities` are those of the working space (`ColorConfig::chromaticities`). Throws `Error` as that
/// function does, and badInput when an AOV has another size.
CANDELA_API void writeExr(const std::filesystem::path& path, const HdrImage& radiance,
                          std::span<const Aov> aovs, const Chromaticities& chromaticities,
                          std::span<const ExrAttribute> attributes = {});

}  // namespace candela
