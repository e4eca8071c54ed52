#include <candela/panorama.h>

#include "base/thread_pool.h"

#include <candela/error.h>
#include <candela/gbuffer.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
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

std::size_t pixelIndex(int size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
}

/// Interpolates `at(x, y)`, of the pixels of a face, between the middles of four; `x` and `y` in pixels from
/// the upper left corner.
template <typename At>
auto interpolated(int size, double x, double y, const At& at) {
    const double last = size - 1.0;
    const double left = std::clamp(x - 0.5, 0.0, last), top = std::clamp(y - 0.5, 0.0, last);
    const int column = std::min(static_cast<int>(left), size - 2);
    const int row = std::min(static_cast<int>(top), size - 2);
    const auto s = static_cast<float>(left - column), t = static_cast<float>(top - row);
    return (1.0f - t) * ((1.0f - s) * at(column, row) + s * at(column + 1, row)) +
           t * ((1.0f - s) * at(column, row + 1) + s * at(column + 1, row + 1));
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

namespace {

/// Of a face, borders included.
int faceSize(int width) {
    return innerSize(width) + 2 * border;
}

/// Where a pixel of the panorama lies on a face, in pixels from its upper left corner.
struct PixelPlace {
    std::size_t face;
    double x, y;
};

/// Calls `body(pixel, place)` for each pixel of the panorama.
template <typename Body>
void forEachPixel(int width, const Body& body) {
    const int height = width / 2;
    const double half = 0.5 * innerSize(width);
    ThreadPool::shared()->run(std::size_t(height), [&](std::size_t y, unsigned) {
        const double latitude = std::numbers::pi * (0.5 - (static_cast<double>(y) + 0.5) / height);
        for (std::size_t x = 0; x < std::size_t(width); ++x) {
            const double longitude = 2.0 * std::numbers::pi * ((static_cast<double>(x) + 0.5) / width - 0.5);
            const double across = std::cos(latitude);
            const FacePlace place =
                placeOf({across * std::sin(longitude), std::sin(latitude), -across * std::cos(longitude)});
            body(y * std::size_t(width) + x,
                 PixelPlace{place.face, border + half * (1.0 + place.x), border + half * (1.0 - place.y)});
        }
    });
}

[[noreturn]] void refuse(const std::string& text) {
    throw Error(ErrorKind::badInput, "", text);
}

}  // namespace

HdrImage panorama(std::span<const HdrImage, 6> faces, int width) {
    requireWidth(width);
    const int size = faceSize(width);
    for (const HdrImage& face : faces) {
        if (face.width == size && face.height == size &&
            face.rgba.size() == 4 * std::size_t(size) * std::size_t(size))
            continue;
        refuse("a face of a panorama of " + std::to_string(width) + " pixels has " +
               std::to_string(face.width) + "x" + std::to_string(face.height) + " of them; " +
               std::to_string(size) + "x" + std::to_string(size) + " are expected");
    }
    HdrImage picture{width, width / 2, std::vector<float>(2 * std::size_t(width) * std::size_t(width))};
    forEachPixel(width, [&](std::size_t pixel, const PixelPlace& place) {
        const std::vector<float>& rgba = faces[place.face].rgba;
        const glm::vec4 color = interpolated(size, place.x, place.y, [&](int x, int y) {
            const float* from = &rgba[4 * pixelIndex(size, x, y)];
            return glm::vec4(from[0], from[1], from[2], from[3]);
        });
        for (std::size_t c = 0; c < 4; ++c) picture.rgba[4 * pixel + c] = color[static_cast<int>(c)];
    });
    return picture;
}

namespace {

using FaceValues = std::array<std::span<const float>, 6>;

/// How much farther from the eye the middle of a face's pixel is than its depth along the face's axis.
float farther(int width, int x, int y) {
    const double half = 0.5 * innerSize(width);
    return static_cast<float>(
        std::hypot(1.0, (x + 0.5 - border) / half - 1.0, (y + 0.5 - border) / half - 1.0));
}

std::vector<float> panoramaValues(const FaceValues& faces, int width, const GBufferChannel& channel) {
    const int size = faceSize(width);
    const bool isDepth = channel.name == std::string_view("Z");
    std::vector<float> result(std::size_t(width) * std::size_t(width) / 2);
    forEachPixel(width, [&](std::size_t pixel, const PixelPlace& place) {
        const std::span<const float> values = faces[place.face];
        if (channel.filter == SampleFilter::average) {
            result[pixel] = interpolated(size, place.x, place.y,
                                         [&](int x, int y) { return values[pixelIndex(size, x, y)]; });
            return;
        }
        const int x = std::clamp(static_cast<int>(place.x), 0, size - 1),
                  y = std::clamp(static_cast<int>(place.y), 0, size - 1);
        result[pixel] = values[pixelIndex(size, x, y)] * (isDepth ? farther(width, x, y) : 1.0f);
    });
    return result;
}

const GBufferChannel& channelOf(const Aov& aov) {
    const auto found = std::ranges::find(gbufferChannels(), aov.name, &GBufferChannel::name);
    if (found == gbufferChannels().end()) refuse("there is no AOV \"" + aov.name + "\"");
    if (aov.name == "motion") refuse("a panorama has no AOV \"motion\": the ways are of a plane");
    return *found;
}

/// Channel `channel` of AOV `index` of the faces.
FaceValues valuesOf(std::span<const std::vector<Aov>, 6> faces, std::size_t index, std::size_t channel,
                    int size) {
    FaceValues values;
    for (std::size_t face = 0; face < values.size(); ++face) {
        const std::string& name = faces[0][index].name;
        if (index >= faces[face].size() || faces[face][index].name != name ||
            channel >= faces[face][index].values.size())
            refuse("the faces of a panorama have different AOVs");
        values[face] = faces[face][index].values[channel];
        if (values[face].size() == std::size_t(size) * std::size_t(size)) continue;
        refuse("the AOV \"" + name + "\" of a face has " + std::to_string(values[face].size()) +
               " values; expected " + std::to_string(size) + "x" + std::to_string(size));
    }
    return values;
}

}  // namespace

std::vector<Aov> panoramaAovs(std::span<const std::vector<Aov>, 6> faces, int width) {
    requireWidth(width);
    std::vector<Aov> aovs;
    for (std::size_t i = 0; i < faces[0].size(); ++i) {
        const GBufferChannel& channel = channelOf(faces[0][i]);
        Aov& aov = aovs.emplace_back(Aov{faces[0][i].name, faces[0][i].channels, {}});
        for (std::size_t c = 0; c < faces[0][i].values.size(); ++c)
            aov.values.push_back(panoramaValues(valuesOf(faces, i, c, faceSize(width)), width, channel));
    }
    return aovs;
}

}  // namespace candela
