#include "exr_metadata.h"

#include <candela/version.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace {

/// Beyond it nothing of an orthographic view is placed; depth is not part of NDC.
constexpr float someFarPlane = 1.0e6f;

struct InteropSpace {
    const char* id;
    candela::Chromaticities primaries;
};

/// Linear spaces. Source: Color Interop Forum, "Color Space Encodings for Textures and CG Rendering".
const std::array<InteropSpace, 5> interopSpaces{{
    {"lin_rec709_scene", {}},
    {"lin_ap1_scene", {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}}},
    {"lin_ap0_scene", {{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, {0.32168, 0.33767}}},
    {"lin_rec2020_scene", {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}}},
    {"lin_p3d65_scene", {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}}},
}};

/// Coordinates are published with four or five digits.
constexpr double sameCoordinate = 2.0e-4;

bool isNear(const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(a.x - b.x) < sameCoordinate && std::abs(a.y - b.y) < sameCoordinate;
}

std::optional<std::string> interopId(const candela::Chromaticities& primaries) {
    for (const InteropSpace& space : interopSpaces)
        if (isNear(space.primaries.red, primaries.red) && isNear(space.primaries.green, primaries.green) &&
            isNear(space.primaries.blue, primaries.blue) && isNear(space.primaries.white, primaries.white))
            return space.id;
    return std::nullopt;
}

/// Camera space of the library, which looks along -Z, from the space of the scene's file.
glm::dmat4 cameraFromFile(const ExrMetadata& metadata) {
    return glm::inverse(glm::dmat4(metadata.view.worldFromCamera)) *
           glm::translate(glm::dmat4(1.0), -metadata.origin);
}

/// Clip space of the library from its camera space.
glm::dmat4 clipFromCamera(candela::CameraView view, float aspect) {
    if (view.orthographicHeight && !view.farPlane) view.farPlane = view.nearPlane + someFarPlane;
    return glm::dmat4(candela::projection(view, aspect));
}

/// From -1 to 1 with y up to 0 to 1 with y down.
glm::dmat4 ndcFromClip() {
    glm::dmat4 window(1.0);
    window[0][0] = 0.5;
    window[1][1] = -0.5;
    window[3] = {0.5, 0.5, 0.0, 1.0};
    return window;
}

/// What the picture shows of the plane onto which the camera projects. The width of the screen window is that
/// of the plane at distance 1. Source: OpenEXR, "Technical Introduction", Projection, Camera Coordinate
/// System and Screen Window.
void addProjection(const ExrMetadata& metadata, std::vector<candela::ExrAttribute>& attributes) {
    const glm::dmat4 clip = clipFromCamera(metadata.view, *metadata.aspect);
    attributes.push_back({"worldToNDC", glm::mat4(ndcFromClip() * clip * cameraFromFile(metadata))});
    attributes.push_back({"screenWindowWidth", static_cast<float>(2.0 / clip[0][0])});
}

}  // namespace

candela::ExrRational toRational(double number) {
    // Continued fractions give the best approximations in the order of their denominators.
    double rest = number;
    std::int64_t n = 1, d = 0, lastN = 0, lastD = 1;
    constexpr std::int64_t limit = std::numeric_limits<std::int32_t>::max();
    for (int step = 0; step < 32; ++step) {
        const double whole = std::floor(rest);
        if (whole > static_cast<double>(limit)) break;
        const std::int64_t nextN = static_cast<std::int64_t>(whole) * n + lastN;
        const std::int64_t nextD = static_cast<std::int64_t>(whole) * d + lastD;
        if (nextN > limit || nextD > limit) break;
        lastN = std::exchange(n, nextN);
        lastD = std::exchange(d, nextD);
        const double value = static_cast<double>(n) / static_cast<double>(d);
        if (std::abs(value - number) <= std::numeric_limits<double>::epsilon() * number) break;
        rest = 1.0 / (rest - whole);
    }
    if (d == 0) return {static_cast<std::int32_t>(limit), 1};
    return {static_cast<std::int32_t>(n), static_cast<std::uint32_t>(d)};
}

std::vector<candela::ExrAttribute> exrMetadata(const ExrMetadata& metadata) {
    const glm::dmat4 camera = cameraFromFile(metadata);
    const glm::dmat4 forward = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, -1.0));
    std::vector<candela::ExrAttribute> attributes{
        {"worldToCamera", glm::mat4(forward * camera)},
        {"framesPerSecond", toRational(metadata.framesPerSecond)},
        {"imageCounter", metadata.frame},
        {"cameraLabel", metadata.camera},
        {"software", "candela " CANDELA_VERSION},
        {"workingSpace", metadata.workingSpace},
    };
    if (metadata.aspect) addProjection(metadata, attributes);
    if (const auto id = interopId(metadata.chromaticities)) attributes.push_back({"colorInteropID", *id});
    return attributes;
}
