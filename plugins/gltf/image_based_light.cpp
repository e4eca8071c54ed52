#include "image_based_light.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "../common/image.h"
#include "document.h"
#include "materials.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

constexpr const char* extensionName = "EXT_lights_image_based";
constexpr double maxIntensity = 1e17;  // times 255, the largest radiance, within what a scene takes
/// Of a face of 2048 × 2048 texels with 16 bits a sample.
constexpr std::uint64_t maxFaceBytes = std::uint64_t{8} * 2048 * 2048;

/// A member of an object; null where it has none.
const Json& memberOf(const Json& object, const char* name) {
    static const Json null;
    if (!object.is_object()) return null;
    const auto found = object.find(name);
    return found == object.end() ? null : *found;
}

std::optional<std::size_t> indexIn(const Json& index, const Json& array) {
    if (!index.is_number_unsigned() || !array.is_array()) return std::nullopt;
    const auto i = index.get<std::size_t>();
    return i < array.size() ? std::optional(i) : std::nullopt;
}

void readRotation(const Json& rotation, ImageBasedLight& light, const Host& host) {
    if (rotation.is_null()) return;
    std::array<double, 4> numbers{};
    double square = 0.0;
    const bool isQuaternion = rotation.is_array() && rotation.size() == 4;
    for (std::size_t i = 0; isQuaternion && i < 4; ++i) {
        if (rotation[i].is_number()) numbers[i] = rotation[i].get<double>();
        square += numbers[i] * numbers[i];
    }
    if (!(square > 0.0) || !std::isfinite(square)) {
        host.note(CANDELA_NOTE_REPAIRED, light.element, "\"rotation\" is no quaternion: it is not rotated");
        return;
    }
    for (std::size_t i = 0; i < 4; ++i)
        light.rotation[i] = static_cast<float>(numbers[i] / std::sqrt(square));
}

void readIntensity(const Json& intensity, ImageBasedLight& light, const Host& host) {
    if (intensity.is_null()) return;
    if (intensity.is_number() && intensity >= 0.0 && intensity <= maxIntensity)
        light.intensity = intensity.get<float>();
    else
        host.note(CANDELA_NOTE_REPAIRED, light.element, "\"intensity\" must be 0 to 1e17: 1 is used");
}

std::array<std::size_t, 6> readFaces(const Json& light, const Json& images, const std::string& element) {
    const Json& levels = memberOf(light, "specularImages");
    const Json faces = levels.is_array() && !levels.empty() ? levels[0] : Json();
    if (!faces.is_array() || faces.size() != 6)
        throw Failure{element, "\"specularImages\" must begin with an array of 6 images"};
    std::array<std::size_t, 6> indices{};
    for (std::size_t i = 0; i < 6; ++i) {
        const std::optional<std::size_t> image = indexIn(faces[i], images);
        if (!image) throw Failure{element, "\"specularImages\" names an image that does not exist"};
        indices[i] = *image;
    }
    return indices;
}

/// sRGB code values of 8 bits to linear light (IEC 61966-2-1).
std::array<float, 256> linearTable() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double code = static_cast<double>(i) / 255.0;
        table[i] = static_cast<float>(code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4));
    }
    return table;
}

/// A cube face of linear light, 3 numbers a texel.
struct Face {
    std::uint32_t size = 0;
    std::vector<float> texels;
};

/// Alpha divides the colours (RGBD); a file without it has 1.
Face decodeFace(const Bytes& file, const std::string& element) {
    static const std::array<float, 256> linear = linearTable();
    if (decodedSize(file) > maxFaceBytes)
        throw Failure{element, "its images are larger than 2048 x 2048 texels"};
    const Image image = decodeImage(file, element);
    if (image.width != image.height) throw Failure{element, "its images must be square"};
    Face face{image.width, std::vector<float>(std::size_t{3} * image.width * image.height)};
    const auto sampleBytes = static_cast<std::size_t>(image.sampleSize);
    const auto code = [&](std::size_t sample) {
        if (sampleBytes == 1) return image.pixels[sample];
        std::uint16_t value = 0;
        std::memcpy(&value, image.pixels.data() + 2 * sample, sizeof value);
        return static_cast<std::uint8_t>(value >> 8);
    };
    for (std::size_t texel = 0; texel < face.texels.size() / 3; ++texel) {
        const float divisor = static_cast<float>(std::max<int>(code(4 * texel + 3), 1)) / 255.0f;
        for (std::size_t i = 0; i < 3; ++i)
            face.texels[3 * texel + i] = linear[code(4 * texel + i)] / divisor;
    }
    return face;
}

using Direction = std::array<double, 3>;

/// The face that a direction meets, and where: 0 to 1 from the left and from the top. The images show the
/// cube as it is seen from its middle, which the extension calls flipped: OpenGL's table 8.19 with the first
/// coordinate reversed.
struct FacePoint {
    std::size_t face;
    double s, t;
};
FacePoint meet(const Direction& d) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
    }
    const double major = std::abs(d[axis]), sign = d[axis] < 0.0 ? -1.0 : 1.0;
    double right = 0.0, down = -d[1];
    if (axis == 0) right = sign * d[2];
    if (axis == 2) right = -sign * d[0];
    if (axis == 1) {
        right = -d[0];
        down = sign * d[2];
    }
    return {2 * axis + (sign < 0.0 ? 1 : 0), 0.5 + 0.5 * right / major, 0.5 + 0.5 * down / major};
}

/// Bilinear within the face.
void sample(const Face& face, const FacePoint& point, float* color) {
    const double last = face.size - 1.0;
    const double x = std::clamp(point.s * face.size - 0.5, 0.0, last);
    const double y = std::clamp(point.t * face.size - 0.5, 0.0, last);
    const auto x0 = static_cast<std::size_t>(x), y0 = static_cast<std::size_t>(y);
    const std::size_t x1 = std::min<std::size_t>(x0 + 1, face.size - 1);
    const std::size_t y1 = std::min<std::size_t>(y0 + 1, face.size - 1);
    const double u = x - static_cast<double>(x0), v = y - static_cast<double>(y0);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = [&](std::size_t column, std::size_t row) {
            return double{face.texels[3 * (row * face.size + column) + i]};
        };
        color[i] = static_cast<float>((1.0 - v) * ((1.0 - u) * at(x0, y0) + u * at(x1, y0)) +
                                      v * ((1.0 - u) * at(x0, y1) + u * at(x1, y1)));
    }
}

/// The picture of `candela_environment`, 4 numbers a texel.
std::vector<float> equirectangular(const std::array<Face, 6>& faces, std::uint32_t width,
                                   std::uint32_t height, const Host& host) {
    constexpr double pi = std::numbers::pi;
    std::vector<float> picture(std::size_t{4} * width * height, 1.0f);
    host.parallelFor(height, [&](std::uint32_t row) {
        const double polar = pi * (row + 0.5) / height;
        for (std::uint32_t column = 0; column < width; ++column) {
            const double azimuth = pi * (2.0 * (column + 0.5) / width - 1.0);
            const FacePoint point = meet(
                {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)});
            sample(faces[point.face], point, &picture[4 * (std::size_t{row} * width + column)]);
        }
    });
    return picture;
}

}  // namespace

std::optional<ImageBasedLight> readImageBasedLight(const Json& document, const Host& host) {
    const Json& scenes = memberOf(document, "scenes");
    const Json& named = memberOf(document, "scene");
    const std::optional<std::size_t> drawn = indexIn(named.is_null() ? Json(0u) : named, scenes);
    if (!drawn) return std::nullopt;
    const Json& instance = memberOf(memberOf(scenes[*drawn], "extensions"), extensionName);
    if (instance.is_null()) return std::nullopt;
    std::optional<ImageBasedLight> light;
    host.leavesOut([&] {
        const std::string scene = elementName("scene", *drawn, "") + ", " + extensionName;
        const Json& lights = memberOf(memberOf(memberOf(document, "extensions"), extensionName), "lights");
        const std::optional<std::size_t> index = indexIn(memberOf(instance, "light"), lights);
        if (!index) throw Failure{scene, "\"light\" names a light that does not exist"};
        const Json& source = lights[*index];
        ImageBasedLight read;
        if (memberOf(source, "name").is_string()) read.name = source["name"].get<std::string>();
        read.element = elementName("image-based light", *index, read.name);
        read.faces = readFaces(source, memberOf(document, "images"), read.element);
        readRotation(memberOf(source, "rotation"), read, host);
        readIntensity(memberOf(source, "intensity"), read, host);
        light = std::move(read);
    });
    return light;
}

void addEnvironment(const Document& document, std::deque<std::vector<std::uint8_t>>& storage,
                    const Host& host) {
    if (!document.imageBasedLight) return;
    const ImageBasedLight& light = *document.imageBasedLight;
    if (!host.takesEnvironments())
        return host.note(CANDELA_NOTE_MISSING, light.element,
                         "left out: this candela is older than version 1.5");
    host.leavesOut([&] {
        std::array<Face, 6> faces;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            faces[i] =
                decodeFace(imageFile(document, light.faces[i], light.element, storage, host), light.element);
            if (faces[i].size != faces[0].size) throw Failure{light.element, "its images differ in size"};
        }
        constexpr std::uint32_t maxHeight = 1024;
        const std::uint32_t height = std::min(2 * faces[0].size, maxHeight), width = 2 * height;
        const std::vector<float> picture = equirectangular(faces, width, height, host);
        candela_environment environment{};
        environment.struct_size = sizeof environment;
        environment.name = light.name.c_str();
        environment.width = width;
        environment.height = height;
        environment.pixels = picture.data();
        environment.pixels_size = picture.size() * sizeof(float);
        std::copy(light.rotation.begin(), light.rotation.end(), environment.rotation);
        environment.intensity = light.intensity;
        host.set(environment);
    });
}

}  // namespace candela_plugins::gltf
