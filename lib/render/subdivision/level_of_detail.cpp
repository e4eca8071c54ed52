#include "render/subdivision/level_of_detail.h"

#include <candela/error.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace candela {

namespace {

constexpr float hysteresis = 0.25f;  // Levels.

void checkLevel(std::uint32_t level, const char* name) {
    if (level >= 1 && level <= maxSubdivisionLevel) return;
    throw Error(ErrorKind::badInput, "",
                std::string(name) + " is " + std::to_string(level) + "; it has to lie between 1 and " +
                    std::to_string(maxSubdivisionLevel));
}

}  // namespace

std::uint64_t refinedPoints(SubdivisionScheme scheme, const CageSize& size, std::uint32_t level) {
    CageSize refined = size;
    for (std::uint32_t i = 0; i < level; ++i) {
        if (scheme == SubdivisionScheme::loop) {
            refined = {refined.vertices + refined.edges, 2 * refined.edges + 3 * refined.faces,
                       4 * refined.faces, 12 * refined.faces};
        } else {
            refined = {refined.vertices + refined.edges + refined.faces, 2 * refined.edges + refined.corners,
                       refined.corners, 4 * refined.corners};
        }
    }
    return refined.vertices;
}

std::uint32_t maxLevel(SubdivisionScheme scheme, const CageSize& size, const SubdivisionSettings& settings) {
    std::uint32_t level = 1;
    while (level < settings.maxLevel && refinedPoints(scheme, size, level + 1) <= settings.maxVertices)
        ++level;
    return level;
}

float idealLevel(float longestEdge, float edgePixels) {
    // Within this range the logarithm of any ratio of floats is finite.
    constexpr float min = 1e-18f, max = 1e18f;
    return std::log2(std::clamp(longestEdge, min, max)) - std::log2(std::clamp(edgePixels, min, max));
}

std::uint32_t nextLevel(std::optional<std::uint32_t> current, float ideal, std::uint32_t maxLevel) {
    const auto requested =
        static_cast<std::uint32_t>(std::clamp(std::ceil(ideal), 1.0f, static_cast<float>(maxLevel)));
    if (!current || *current > maxLevel) return requested;
    const auto level = static_cast<float>(*current);
    const bool isServed = ideal <= level + hysteresis && ideal >= level - 1.0f - hysteresis;
    return isServed ? *current : requested;
}

void checkSettings(const SubdivisionSettings& settings) {
    if (settings.level) checkLevel(*settings.level, "the subdivision level");
    checkLevel(settings.maxLevel, "the maximum subdivision level");
    if (settings.maxVertices == 0)
        throw Error(ErrorKind::badInput, "", "the maximum number of refined vertices has to be over 0");
    if (settings.edgePixels > 0.0f && std::isfinite(settings.edgePixels)) return;
    throw Error(ErrorKind::badInput, "",
                "the length of subdivided edges is " + std::to_string(settings.edgePixels) +
                    " pixels; it has to be a finite number over 0");
}

LodView lodView(const CameraView& view, int width, int height) {
    const auto pixels = static_cast<float>(height);
    const float pixelsAtOneMetre = view.orthographicHeight
                                       ? pixels / *view.orthographicHeight
                                       : 0.5f * pixels / std::tan(0.5f * view.verticalFov);
    return {Frustum(view, static_cast<float>(width) / pixels), view.eye(), view.nearPlane,
            view.orthographicHeight.has_value(), pixelsAtOneMetre};
}

std::optional<float> longestEdge(const LodView& view, std::span<const glm::vec3> points,
                                 std::span<const CageEdge> edges) {
    std::optional<float> longest;
    for (const auto& [first, second] : edges) {
        const glm::vec3 &a = points[first], &b = points[second];
        const float length = glm::distance(a, b);
        const float nearest = std::min(glm::distance(a, view.eye), glm::distance(b, view.eye));
        const float pixels = view.pixels(length, nearest);
        if (longest && pixels <= *longest) continue;
        if (view.frustum.meets(0.5f * (a + b), 0.5f * length)) longest = pixels;
    }
    return longest;
}

}  // namespace candela
