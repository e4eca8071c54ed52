#include <candela/picture_parts.h>

#include <candela/error.h>

#include <algorithm>
#include <string>

namespace candela {

namespace {

/// What is shared by neighbouring pixels: their quads, the pattern of occlusion rays and its filter, tiles of
/// lights.
constexpr int alignment = 16;
constexpr int margin = 16;

/// A range of pixels along a side, and that of the frame around it.
struct Span {
    int first, end, frameFirst, frameEnd;
};

/// From the side where pixels are counted from in the frame's own pattern: left, and bottom.
std::vector<Span> spansOf(int size, int maxSide) {
    if (size <= maxSide) return {{0, size, 0, size}};
    const int step = (maxSide - 2 * margin) / alignment * alignment;
    std::vector<Span> spans;
    for (int first = 0; first < size; first += step) {
        const int end = std::min(first + step, size);
        spans.push_back({first, end, std::max(first - margin, 0), std::min(end + margin, size)});
    }
    return spans;
}

}  // namespace

FrameSettings PicturePart::settings(const FrameSettings& picture) const {
    FrameSettings settings = picture;
    settings.region = PictureRegion{picture.width, picture.height, x - left, y - top};
    settings.width = frameWidth;
    settings.height = frameHeight;
    return settings;
}

std::vector<PicturePart> pictureParts(int width, int height, int maxSide) {
    return pictureParts(width, height, maxSide, maxSide);
}

std::vector<PicturePart> pictureParts(int width, int height, int maxWidth, int maxHeight) {
    constexpr int most = 1 << 20;
    if (width < 1 || height < 1 || width > most || height > most) {
        throw Error(ErrorKind::badInput, "",
                    "parts of a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                        " pixels are asked for; sides have to be 1 to " + std::to_string(most));
    }
    if (const int least = std::min(maxWidth, maxHeight); least < minPartSide) {
        throw Error(ErrorKind::badInput, "",
                    "parts of " + std::to_string(least) + " pixels a side are asked for; expected " +
                        std::to_string(minPartSide) + " or more");
    }
    const std::vector<Span> columns = spansOf(width, maxWidth);
    std::vector<Span> rows = spansOf(height, maxHeight);
    std::ranges::reverse(rows);  // from the top
    std::vector<PicturePart> parts;
    for (const Span& row : rows) {
        for (const Span& column : columns) {
            parts.push_back({column.first, height - row.end, column.end - column.first, row.end - row.first,
                             column.first - column.frameFirst, row.frameEnd - row.end,
                             column.frameEnd - column.frameFirst, row.frameEnd - row.frameFirst});
        }
    }
    return parts;
}

}  // namespace candela
