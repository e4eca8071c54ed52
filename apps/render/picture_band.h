#pragma once

#include "picture_file.h"

#include <candela/exposure.h>
#include <candela/frame_data.h>
#include <candela/picture_parts.h>

#include <utility>

/// Puts a row of parts of a picture together.
class PictureBand {
  public:
    /// `width` is that of the picture, `first` any part of the row.
    PictureBand(int width, const candela::PicturePart& first);

    /// `drawn` is the frame of the part, margins included. All parts have the same channels.
    void add(const candela::PicturePart& part, const DrawnPicture& drawn);
    /// The rows of the picture, once, after all parts.
    DrawnPicture take() { return std::move(picture_); }

  private:
    DrawnPicture picture_;
    int top_;  ///< In the picture.
};

/// A part of radiance without its margins.
candela::HdrImage withoutMargins(const candela::PicturePart& part, const candela::HdrImage& frame);

candela::ExposureCounts sum(const candela::ExposureCounts& a, const candela::ExposureCounts& b);
