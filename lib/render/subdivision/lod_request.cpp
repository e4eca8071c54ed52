#include "render/subdivision/lod_request.h"

#include <candela/error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace candela {

namespace {

constexpr float hysteresis = 0.25f;

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
    constexpr float least = 1e-18f, most = 1e18f;
    return std::log2(std::clamp(longestEdge, least, most)) - std::log2(std::clamp(edgePixels, least, most));
}

std::uint32_t nextLevel(std::optional<std::uint32_t> current, float ideal, std::uint32_t greatest) {
    const auto asked =
        static_cast<std::uint32_t>(std::clamp(std::ceil(ideal), 1.0f, static_cast<float>(greatest)));
    if (!current || *current > greatest) return asked;
    const auto level = static_cast<float>(*current);
    const bool served = ideal <= level + hysteresis && ideal >= level - 1.0f - hysteresis;
    return served ? *current : asked;
}

void checkSettings(const SubdivisionSettings& settings) {
    if (settings.level) checkLevel(*settings.level, "the subdivision level");
    checkLevel(settings.maxLevel, "the greatest subdivision level");
    if (settings.edgePixels > 0.0f && std::isfinite(settings.edgePixels)) return;
    throw Error(ErrorKind::badInput, "",
                "the length of subdivided edges is " + std::to_string(settings.edgePixels) +
                    " pixels; it has to be a finite number over 0");
}

}  // namespace candela
