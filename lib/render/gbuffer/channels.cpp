#include "render/gbuffer/channels.h"

#include "render/frame_uniforms.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace candela {

namespace {

using enum ChannelSource;
using Scale = DebugViewRow::Scale;

constexpr std::array rows{
    ChannelRow{
        {"Z", "", "distance along the view axis in metres, 0 on the background",
         "reversed depth: near plane / Z without a far plane", "32-bit float", SampleFilter::first},
        depth,
        [](const ChannelPixel& pixel) { return glm::vec3(viewDistance(pixel.frame, pixel.depth), 0, 0); },
        // Nearest / (nearest + distance), by the distance of the closest surface.
        {DebugView::depth, "depth", depth, Scale::maximum, "vec3(depthCode(depth, maximum))"}},
    ChannelRow{{"P", "XYZ", "position in metres, in the space of the scene's file",
                "follows from Z and the camera", "none of its own", SampleFilter::first},
               depth,
               [](const ChannelPixel& pixel) {
                   const glm::dvec3 position(worldPosition(pixel.frame, pixel.x, pixel.y, pixel.depth));
                   return glm::vec3(pixel.origin + position);
               },
               {}},
    ChannelRow{
        {"N", "XYZ", "world normal, unit length", "octahedral, codes 1 to 4095 an axis", "2 × 12 bits"},
        surface,
        [](const ChannelPixel& pixel) { return pixel.surface.normal; },
        {DebugView::normals, "normals", surface, Scale::fixed, "0.5 + 0.5 * surface.normal"}},
    ChannelRow{
        {"base_color", "RGB", "base colour, linear in the working space", "sRGB curve", "3 × 8 bits"},
        surface,
        [](const ChannelPixel& pixel) { return pixel.surface.lobes.baseColor; },
        {DebugView::baseColor, "base_color", surface, Scale::fixed, "srgbEncode(surface.lobes.baseColor)"}},
    ChannelRow{{"metallic", "", "metallic, 0 to 1", "linear", "8 bits"},
               surface,
               [](const ChannelPixel& pixel) { return glm::vec3(pixel.surface.lobes.metallic, 0, 0); },
               {DebugView::metallic, "metallic", surface, Scale::fixed, "vec3(surface.lobes.metallic)"}},
    ChannelRow{
        {"roughness", "", "perceptual roughness, 0 to 1", "fourth root, from 0.032 on, and 0", "8 bits"},
        surface,
        [](const ChannelPixel& pixel) { return glm::vec3(pixel.surface.lobes.roughness, 0, 0); },
        {DebugView::roughness, "roughness", surface, Scale::fixed, "vec3(surface.lobes.roughness)"}},
    ChannelRow{
        {"emission", "RGB", "emitted radiance, linear in the working space", "linear, in the radiance target",
         "3 × 32-bit float"},
        emission,
        [](const ChannelPixel& pixel) { return pixel.color; },
        {DebugView::emission, "emission", emission, Scale::fixed, "srgbEncode(clamp(emission, 0.0, 1.0))"}},
    ChannelRow{{"environment", "RGB",
                "radiance that the surface reflects of the environment, linear in the working space",
                "drawn when it is asked for", "none of its own"},
               environment,
               [](const ChannelPixel& pixel) { return pixel.color; },
               {}},
    ChannelRow{{"environment_diffuse", "RGB", "the part of it by diffuse reflection",
                "drawn when it is asked for", "none of its own"},
               environmentDiffuse,
               [](const ChannelPixel& pixel) { return pixel.color; },
               {}},
    ChannelRow{{"environment_specular", "RGB", "the part of it by specular reflection",
                "drawn when it is asked for", "none of its own"},
               environmentSpecular,
               [](const ChannelPixel& pixel) { return pixel.color; },
               {}},
    ChannelRow{{"light_count", "", "point and spot lights in whose range the pixel lies",
                "counted when it is asked for", "none of its own"},
               lightCount,
               [](const ChannelPixel& pixel) { return glm::vec3(pixel.number, 0, 0); },
               {DebugView::lightCount, "light_count", lightCount, Scale::maximum,
                "heatColor(count / max(maximum, 1.0))"}},
    ChannelRow{
        {"shadowed_count", "",
         "lights in whose range and in front of which the pixel lies, but that something hides; 0 in a "
         "frame without shadows",
         "traced when it is asked for", "none of its own"},
        shadowedCount,
        [](const ChannelPixel& pixel) { return glm::vec3(pixel.number, 0, 0); },
        {DebugView::shadowedCount, "shadowed_count", shadowedCount, Scale::maximum,
         "heatColor(count / max(maximum, 1.0))"}},
    ChannelRow{
        {"ambient_occlusion", "",
         "share of the hemisphere around the normal, weighted by the cosine, in which nothing is nearer "
         "than a distance: 1 is open",
         "traced when it is asked for", "none of its own"},
        ambientOcclusion,
        [](const ChannelPixel& pixel) { return glm::vec3(pixel.number, 0, 0); },
        {}},
    ChannelRow{{"node_id", "", "index of the node in the scene and 1, 0 on the background",
                "drawn when it is asked for", "none of its own", SampleFilter::first},
               nodeId,
               [](const ChannelPixel& pixel) { return glm::vec3(pixel.number, 0, 0); },
               {}},
    ChannelRow{{"material_id", "", "index of the material in the scene and 1, 0 without one",
                "drawn when it is asked for", "none of its own", SampleFilter::first},
               materialId,
               [](const ChannelPixel& pixel) { return glm::vec3(pixel.number, 0, 0); },
               {}},
    ChannelRow{
        {"instance_id", "",
         "number of the mesh or cage of a node, from 1: all meshes in the order of the nodes, then all "
         "cages; 0 on the background",
         "drawn when it is asked for", "none of its own", SampleFilter::first},
        instanceId,
        [](const ChannelPixel& pixel) { return glm::vec3(pixel.number, 0, 0); },
        {}},
    ChannelRow{{"motion", "XY",
                "way of the surface in the picture since the frame before, pixels, X to the right and Y down",
                "computed when it is asked for", "none of its own", SampleFilter::first},
               motion,
               [](const ChannelPixel& pixel) { return pixel.color; },
               {}},
};

/// The debug views that show no channel.
constexpr DebugViewRow levelRow{DebugView::level, "level", instance, Scale::fixed, "instanceColor"};

constexpr auto channels = [] {
    std::array<GBufferChannel, rows.size()> result{};
    std::ranges::transform(rows, result.begin(), &ChannelRow::channel);
    return result;
}();

}  // namespace

std::span<const ChannelRow> channelRows() {
    return rows;
}

std::span<const GBufferChannel> gbufferChannels() {
    return channels;
}

std::vector<std::string> exrChannelNames(const GBufferChannel& channel) {
    const std::string name = channel.name;
    std::vector<std::string> names;
    for (const char* component = channel.components; *component != '\0'; ++component)
        names.push_back(name + "." + *component);
    if (names.empty()) names.push_back(name);
    return names;
}

const DebugViewRow& debugViewRow(DebugView view) {
    assert(view != DebugView::none);
    const auto row =
        std::ranges::find(rows, view, [](const ChannelRow& channel) { return channel.debugView.view; });
    return row != rows.end() ? row->debugView : levelRow;
}

const char* toString(DebugView view) {
    return view == DebugView::none ? "picture" : debugViewRow(view).name;
}

std::span<const DebugView> debugViews() {
    static const std::vector<DebugView> views = [] {
        std::vector<DebugView> result;
        for (const ChannelRow& row : rows)
            if (row.debugView.view != DebugView::none) result.push_back(row.debugView.view);
        result.push_back(levelRow.view);
        std::ranges::sort(result);
        return result;
    }();
    return views;
}

}  // namespace candela
