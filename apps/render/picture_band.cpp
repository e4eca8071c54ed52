#include "picture_band.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

/// Copies the pixels of a part, each of `channels` values, from its frame to a picture `width` pixels wide.
template <typename Value>
void copyPart(const candela::PicturePart& part, std::size_t channels, const std::vector<Value>& frame,
              int width, std::vector<Value>& picture) {
    for (int row = 0; row < part.height; ++row) {
        const std::size_t from =
            static_cast<std::size_t>(part.top + row) * static_cast<std::size_t>(part.frameWidth) +
            static_cast<std::size_t>(part.left);
        const std::size_t to = static_cast<std::size_t>(part.y + row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(part.x);
        std::copy_n(frame.begin() + static_cast<std::ptrdiff_t>(channels * from),
                    channels * static_cast<std::size_t>(part.width),
                    picture.begin() + static_cast<std::ptrdiff_t>(channels * to));
    }
}

}  // namespace

PictureBand::PictureBand(int width, const candela::PicturePart& first) : top_(first.y) {
    picture_.width = width;
    picture_.height = first.height;
}

void PictureBand::add(const candela::PicturePart& inPicture, const DrawnPicture& drawn) {
    candela::PicturePart part = inPicture;
    part.y -= top_;
    const int width = picture_.width;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(picture_.height);
    picture_.encoding = drawn.encoding;
    picture_.chromaticities = drawn.chromaticities;
    picture_.attributes = drawn.attributes;
    if (!drawn.rgba.empty()) {
        picture_.rgba.resize(4 * pixels);
        copyPart(part, 4, drawn.rgba, width, picture_.rgba);
        return;
    }
    picture_.radiance.width = width;
    picture_.radiance.height = picture_.height;
    picture_.radiance.rgba.resize(4 * pixels);
    copyPart(part, 4, drawn.radiance.rgba, width, picture_.radiance.rgba);
    picture_.aovs.resize(drawn.aovs.size());
    for (std::size_t i = 0; i < drawn.aovs.size(); ++i) {
        candela::Aov& aov = picture_.aovs[i];
        aov.name = drawn.aovs[i].name;
        aov.channels = drawn.aovs[i].channels;
        aov.values.resize(drawn.aovs[i].values.size());
        for (std::size_t c = 0; c < aov.values.size(); ++c) {
            aov.values[c].resize(pixels);
            copyPart(part, 1, drawn.aovs[i].values[c], width, aov.values[c]);
        }
    }
}

candela::HdrImage withoutMargins(const candela::PicturePart& part, const candela::HdrImage& frame) {
    candela::HdrImage cut{part.width, part.height, {}};
    cut.rgba.resize(4 * static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
    candela::PicturePart alone = part;
    alone.x = alone.y = 0;
    copyPart(alone, 4, frame.rgba, part.width, cut.rgba);
    return cut;
}

candela::ExposureCounts sum(const candela::ExposureCounts& a, const candela::ExposureCounts& b) {
    return {a.surfaces + b.surfaces, a.lit + b.lit, a.overBlack + b.overBlack, a.overWhite + b.overWhite};
}
