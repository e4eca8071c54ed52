#include "render/debug/aovs.h"

#include <candela/error.h>
#include <candela/nearest_name.h>

#include <algorithm>

namespace candela {

namespace {

/// The names that there are, and which of them `name` was probably meant to be.
std::string knownNames(const std::string& name) {
    std::vector<std::string> names;
    std::string text;
    for (const ChannelRow& row : channelRows()) {
        names.emplace_back(row.channel.name);
        text += (text.empty() ? "" : ", ") + names.back();
    }
    return text + didYouMean(name, names);
}

const ChannelRow& findAov(const std::string& name) {
    const auto row = std::ranges::find(channelRows(), name,
                                       [](const ChannelRow& channelRow) { return channelRow.channel.name; });
    if (row != channelRows().end()) return *row;
    throw Error(ErrorKind::badInput, "", "there is no AOV '" + name + "'; there are " + knownNames(name));
}

/// Whether a channel has a value at the pixel; 0 stands for none.
bool hasValue(const ChannelRow& row, const AovSources& sources, std::size_t i) {
    switch (row.source) {
        case ChannelSource::depth:
            return sources.depth[i] > 0.0f;
        case ChannelSource::surface:
            return sources.surfaces[i].y != 0;
        default:
            return true;
    }
}

/// The colours of a channel's source; empty for a source of other kinds.
std::span<const float> colorsOf(ChannelSource source, const AovSources& sources) {
    switch (source) {
        case ChannelSource::emission:
            return sources.emission;
        case ChannelSource::environment:
            return sources.environment;
        case ChannelSource::environmentDiffuse:
            return sources.environmentDiffuse;
        case ChannelSource::environmentSpecular:
            return sources.environmentSpecular;
        case ChannelSource::motion:
            return sources.motion;
        default:
            return {};
    }
}

/// The numbers of a channel's source; empty for a source of other kinds.
std::span<const float> numbersOf(ChannelSource source, const AovSources& sources) {
    switch (source) {
        case ChannelSource::lightCount:
            return sources.lightCount;
        case ChannelSource::shadowedCount:
            return sources.shadowedCount;
        case ChannelSource::ambientOcclusion:
            return sources.ambientOcclusion;
        case ChannelSource::nodeId:
            return sources.nodeId;
        case ChannelSource::materialId:
            return sources.materialId;
        case ChannelSource::instanceId:
            return sources.instanceId;
        default:
            return {};
    }
}

/// The value at a pixel; `y` counts from the bottom.
glm::vec3 valueAt(const ChannelRow& row, const AovSources& sources, int x, int y) {
    const std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(sources.width) + static_cast<std::size_t>(x);
    if (!hasValue(row, sources, i)) return glm::vec3(0.0f);
    ChannelPixel pixel{sources.frame, sources.origin, x, y, sources.depth[i], {}};
    if (row.source == ChannelSource::surface) pixel.surface = unpackSurface(sources.surfaces[i]);
    if (const std::span<const float> numbers = numbersOf(row.source, sources); !numbers.empty())
        pixel.number = numbers[i];
    if (const std::span<const float> colors = colorsOf(row.source, sources); !colors.empty())
        pixel.color = {colors[4 * i], colors[4 * i + 1], colors[4 * i + 2]};
    return row.decode(pixel);
}

}  // namespace

std::vector<const ChannelRow*> findAovs(const std::vector<std::string>& names) {
    std::vector<const ChannelRow*> rows;
    for (const std::string& name : names) {
        const ChannelRow* row = &findAov(name);
        if (std::ranges::find(rows, row) != rows.end())
            throw Error(ErrorKind::badInput, "", "the AOV '" + name + "' is asked for twice");
        rows.push_back(row);
    }
    if (usesSource(rows, ChannelSource::ambientOcclusion) && !hasShadows()) {
        throw Error(ErrorKind::environment, "",
                    "the AOV 'ambient_occlusion' is asked for, but this candela was built without shadows "
                    "(CMake option CANDELA_SHADOWS), whose rays it needs");
    }
    return rows;
}

bool usesSource(std::span<const ChannelRow* const> rows, ChannelSource source) {
    return std::ranges::any_of(rows, [&](const ChannelRow* row) { return row->source == source; });
}

Aov makeAov(const ChannelRow& row, const AovSources& sources) {
    Aov aov{row.channel.name, exrChannelNames(row.channel), {}};
    const auto width = static_cast<std::size_t>(sources.width),
               height = static_cast<std::size_t>(sources.height);
    aov.values.assign(aov.channels.size(), std::vector<float>(width * height));
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const glm::vec3 value =
                valueAt(row, sources, static_cast<int>(x), static_cast<int>(height - 1 - y));
            for (std::size_t c = 0; c < aov.values.size(); ++c)
                aov.values[c][y * width + x] = value[static_cast<int>(c)];
        }
    }
    return aov;
}

}  // namespace candela
