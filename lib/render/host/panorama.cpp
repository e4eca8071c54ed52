#include <candela/panorama.h>

#include "base/thread_pool.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace candela {

namespace {

/// Pixels of a face beyond the cube's edge. Interpolation reads half a pixel beyond, and what neighbouring
/// pixels share of occlusion four more.
constexpr int border = 8;

void requireWidth(int width) {
    if (width >= 4 && width % 2 == 0) return;
    throw Error(ErrorKind::badInput, "",
                "a panorama of " + std::to_string(width) +
                    " pixels is asked for; its width has to be even, and 4 or more");
}

/// The pixels across 90 degrees. In the middle of a face a pixel is 2 / pixels wide, and one of the panorama
/// 2 pi / width. Faces are larger than their borders.
int innerSize(int width) {
    return std::max(2 * border, static_cast<int>(std::ceil(width / std::numbers::pi)));
}

glm::vec4 pixelOf(const HdrImage& face, int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(face.width) +
                               static_cast<std::size_t>(x));
    return {face.rgba[i], face.rgba[i + 1], face.rgba[i + 2], face.rgba[i + 3]};
}

/// Between the middles of four pixels; `x` and `y` in pixels from the upper left corner.
glm::vec4 interpolated(const HdrImage& face, double x, double y) {
    const double last = face.width - 1.0;
    const double left = std::clamp(x - 0.5, 0.0, last), top = std::clamp(y - 0.5, 0.0, last);
    const int column = std::min(static_cast<int>(left), face.width - 2);
    const int row = std::min(static_cast<int>(top), face.height - 2);
    const auto s = static_cast<float>(left - column), t = static_cast<float>(top - row);
    return (1.0f - t) * ((1.0f - s) * pixelOf(face, column, row) + s * pixelOf(face, column + 1, row)) +
           t * ((1.0f - s) * pixelOf(face, column, row + 1) + s * pixelOf(face, column + 1, row + 1));
}

/// The face of a direction in camera space, and where on it: x to the right and y up, -1 to 1 on the cube.
struct FacePlace {
    std::size_t face;
    double x, y;
};

FacePlace placeOf(const glm::dvec3& d) {
    const glm::dvec3 size = glm::abs(d);
    // As `cubeViews` orders and turns the faces.
    if (size.x >= size.y && size.x >= size.z)
        return d.x > 0.0 ? FacePlace{0, d.z / d.x, d.y / d.x} : FacePlace{1, -d.z / -d.x, d.y / -d.x};
    if (size.y >= size.z)
        return d.y > 0.0 ? FacePlace{2, d.x / d.y, d.z / d.y} : FacePlace{3, d.x / -d.y, -d.z / -d.y};
    return d.z < 0.0 ? FacePlace{4, d.x / -d.z, d.y / -d.z} : FacePlace{5, -d.x / d.z, d.y / d.z};
}

}  // namespace

PanoramaFaces panoramaFaces(const CameraView& view, int width) {
    requireWidth(width);
    const int inner = innerSize(width);
    return {inner + 2 * border, cubeViews(view, static_cast<float>(border) / static_cast<float>(inner))};
}

HdrImage panorama(std::span<const HdrImage, 6> faces, int width) {
    requireWidth(width);
    const int inner = innerSize(width), size = inner + 2 * border, height = width / 2;
    for (const HdrImage& face : faces) {
        if (face.width == size && face.height == size &&
            face.rgba.size() == 4 * std::size_t(size) * std::size_t(size))
            continue;
        throw Error(ErrorKind::badInput, "",
                    "a face of a panorama of " + std::to_string(width) + " pixels has " +
                        std::to_string(face.width) + "x" + std::to_string(face.height) + " of them; " +
                        std::to_string(size) + "x" + std::to_string(size) + " are expected");
    }
    HdrImage picture{width, height, std::vector<float>(4 * std::size_t(width) * std::size_t(height))};
    const double half = 0.5 * inner;
    ThreadPool::shared()->run(std::size_t(height), [&](std::size_t y, unsigned) {
        const double latitude = std::numbers::pi * (0.5 - (static_cast<double>(y) + 0.5) / height);
        for (std::size_t x = 0; x < std::size_t(width); ++x) {
            const double longitude = 2.0 * std::numbers::pi * ((static_cast<double>(x) + 0.5) / width - 0.5);
            const double across = std::cos(latitude);
            const FacePlace place =
                placeOf({across * std::sin(longitude), std::sin(latitude), -across * std::cos(longitude)});
            const glm::vec4 color = interpolated(faces[place.face], border + half * (1.0 + place.x),
                                                 border + half * (1.0 - place.y));
            for (int c = 0; c < 4; ++c)
                picture.rgba[4 * (y * std::size_t(width) + x) + std::size_t(c)] = color[c];
        }
    });
    return picture;
}

}  // namespace candela
