#include "render/debug/aovs.h"

#include "render/frame_uniforms.h"

#include <candela/error.h>

#include <algorithm>
#include <array>

namespace candela {

namespace {

using Pixel = std::array<float, 3>;

Pixel toPixel(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

/// The AOV's value at a pixel; `y` counts from the bottom.
Pixel valueAt(const std::string& name, const AovSources& sources, int x, int y) {
    const std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(sources.width) + static_cast<std::size_t>(x);
    if (name == "light_count") return {sources.lightCount[i], 0.0f, 0.0f};
    if (name == "emission")
        return {sources.emission[4 * i], sources.emission[4 * i + 1], sources.emission[4 * i + 2]};
    const float depth = sources.depth[i];
    if (depth <= 0.0f) return {};
    if (name == "Z") return {sources.frame.eye.w / depth, 0.0f, 0.0f};
    if (name == "P") return toPixel(worldPosition(sources.frame, x, y, depth));
    const GBufferTexel texel = sources.surfaces[i];
    if (texel.y == 0) return {};
    const GBufferSurface surface = unpackSurface(texel);
    if (name == "N") return toPixel(surface.normal);
    if (name == "base_color") return toPixel(surface.lobes.baseColor);
    if (name == "metallic") return {surface.lobes.metallic, 0.0f, 0.0f};
    return {surface.lobes.roughness, 0.0f, 0.0f};
}

std::vector<std::string> channelsOf(const std::string& name) {
    for (const GBufferChannel& channel : gbufferChannels()) {
        if (channel.name == name) return {channel.exrChannels.begin(), channel.exrChannels.end()};
    }
    return {name};
}

}  // namespace

std::vector<std::string> Renderer::aovNames() {
    std::vector<std::string> names;
    for (const GBufferChannel& channel : gbufferChannels()) names.emplace_back(channel.name);
    names.emplace_back("light_count");
    return names;
}

void checkAovNames(const std::vector<std::string>& names) {
    const std::vector<std::string> known = Renderer::aovNames();
    for (const std::string& name : names) {
        if (std::ranges::count(names, name) > 1)
            throw Error(ErrorKind::badInput, "", "the AOV '" + name + "' is asked for twice");
        if (std::ranges::find(known, name) != known.end()) continue;
        std::string text = "there is no AOV '" + name + "'; there are";
        for (const std::string& one : known) text += (one == known.front() ? " " : ", ") + one;
        throw Error(ErrorKind::badInput, "", text);
    }
}

Aov makeAov(const std::string& name, const AovSources& sources) {
    Aov aov{name, channelsOf(name), {}};
    const auto width = static_cast<std::size_t>(sources.width),
               height = static_cast<std::size_t>(sources.height);
    aov.values.assign(aov.channels.size(), std::vector<float>(width * height));
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t x = 0; x < width; ++x) {
            const Pixel pixel =
                valueAt(name, sources, static_cast<int>(x), static_cast<int>(height - 1 - row));
            for (std::size_t c = 0; c < aov.values.size(); ++c) aov.values[c][row * width + x] = pixel[c];
        }
    }
    return aov;
}

}  // namespace candela
