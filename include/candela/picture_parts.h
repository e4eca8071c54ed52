#pragma once

#include <candela/export.h>
#include <candela/frame_settings.h>

#include <vector>

namespace candela {

/// A part of a picture that is drawn in parts, because it is larger than the device's textures or its memory.
/// Its frame has a margin, so that what a pixel shares with its neighbours is whole at the part's edges.
struct PicturePart {
    int x = 0, y = 0, width = 0, height = 0;  ///< The part in the picture, pixels, y from the top.
    int left = 0, top = 0;                    ///< Where it begins in its frame.
    int frameWidth = 0, frameHeight = 0;

    /// The settings of its frame: those of the whole picture with size and region replaced.
    CANDELA_API FrameSettings settings(const FrameSettings& picture) const;
};

/// The least side of the frames of `pictureParts`, pixels.
inline constexpr int minPartSide = 64;

/// The parts of a picture of `width` × `height` pixels, in rows from the top, whose frames have sides of at
/// most `maxSide` pixels; one without margins where the picture is no larger. Throws `Error` (badInput) when
/// a side is not 1 to 2^20 or `maxSide` is below `minPartSide`.
CANDELA_API std::vector<PicturePart> pictureParts(int width, int height, int maxSide);
/// The same with limits for both sides: wide and low parts make the bands low in which a picture is encoded
/// (candela/image_stream.h).
CANDELA_API std::vector<PicturePart> pictureParts(int width, int height, int maxWidth, int maxHeight);

}  // namespace candela
