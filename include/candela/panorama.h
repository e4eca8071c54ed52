#pragma once

#include <candela/camera.h>
#include <candela/export.h>
#include <candela/frame_data.h>

#include <array>
#include <span>
#include <vector>

namespace candela {

/// Panoramas: equirectangular pictures of all directions around an eye, which are resampled from the faces of
/// a cube that are larger than they have to be.

/// How the faces of a panorama are drawn.
struct PanoramaFaces {
    int size = 0;                          ///< Pixels a side of each face.
    std::array<CameraView, 6> views = {};  ///< In the order of `cubeViews`.
};

/// The faces of a panorama that is `width` pixels wide, 4 or more and even, and half as high, around the eye
/// of `view`. Their pixels are at most as wide as the panorama's, and they extend beyond the cube's edges by
/// what resampling reads there, so that edges leave no seam. Throws `Error` (badInput) when the width is
/// another one or the view is orthographic.
CANDELA_API PanoramaFaces panoramaFaces(const CameraView& view, int width);

/// The panorama of these faces' pictures. The middle of its rows looks along the view axis, up is the view's
/// own, and it goes right to what is right of the eye; the middle of pixel (x, y) has the longitude
/// 2 pi ((x + 0.5) / width - 0.5) from the axis and the latitude pi (0.5 - (y + 0.5) / height). Radiance and
/// coverage are interpolated by the four nearest pixels of a face. Throws `Error` (badInput) when a picture
/// has not the size of a face.
CANDELA_API HdrImage panorama(std::span<const HdrImage, 6> faces, int width);

/// The AOVs of that panorama, from those of the faces. Channels whose samples are averaged
/// (`GBufferChannel::filter`) are interpolated as radiance is, others are those of the nearest pixel. Z is
/// the distance from the eye, in metres, and 0 on the background. Throws `Error` (badInput) when the faces do
/// not have the same AOVs, a channel has not the size of a face, or one is `motion`, which is of a plane.
CANDELA_API std::vector<Aov> panoramaAovs(std::span<const std::vector<Aov>, 6> faces, int width);

}  // namespace candela
