#include <candela/frame_data.h>

#include <candela/error.h>

#include <array>
#include <string>

namespace candela {

void writeExr(const std::filesystem::path& path, const HdrImage& radiance, std::span<const Aov> aovs,
              const Chromaticities& chromaticities, std::span<const ExrAttribute> attributes) {
    constexpr std::array names{"R", "G", "B", "A"};
    std::array<std::vector<float>, names.size()> planes;
    std::vector<ExrChannel> channels;
    for (std::size_t c = 0; c < planes.size(); ++c) {
        planes[c].reserve(radiance.rgba.size() / planes.size());
        for (std::size_t i = c; i < radiance.rgba.size(); i += planes.size())
            planes[c].push_back(radiance.rgba[i]);
        channels.push_back({names[c], planes[c]});
    }
    for (const Aov& aov : aovs) {
        if (aov.channels.size() != aov.values.size())
            throw Error(ErrorKind::badInput, path.string(),
                        "the AOV '" + aov.name + "' has not one array of values for each channel");
        for (std::size_t i = 0; i < aov.channels.size(); ++i)
            channels.push_back({aov.channels[i], aov.values[i]});
    }
    writeExr(path, static_cast<std::uint32_t>(radiance.width), static_cast<std::uint32_t>(radiance.height),
             channels, chromaticities, attributes);
}

}  // namespace candela
