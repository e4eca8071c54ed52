#include <candela/environment.h>

#include "scene/environment/equirect.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// The same picture on every machine: see portable_math.h.

namespace candela {

namespace {

constexpr std::uint32_t width = 512, height = 256;

/// A rectangle of even radiance that faces the middle of the room.
struct SoftBox {
    glm::dvec3 towards;  ///< From the middle of the room, of any length.
    double halfWidth;    ///< At a distance of 1.
    double halfHeight;   ///< At a distance of 1.
    double radiance;
};

/// The camera that frames a scene by itself looks along -Z: the key is at its left.
constexpr std::array boxes{
    SoftBox{{-0.70, 0.65, 0.80}, 0.50, 0.50, 2.5},   // key
    SoftBox{{0.95, 0.20, 0.55}, 0.35, 0.65, 1.3},    // fill
    SoftBox{{0.00, 1.00, 0.00}, 0.60, 0.45, 1.0},    // top
    SoftBox{{0.65, 0.35, -0.90}, 0.12, 0.75, 3.2},   // rim, right
    SoftBox{{-0.85, 0.30, -0.75}, 0.12, 0.75, 2.0},  // rim, left
};

/// Radiance of the room: its walls above the horizon, its floor straight below.
constexpr double wallRadiance = 0.32, floorRadiance = 0.28;
/// Width of a box's edge at a distance of 1: two texels, so that reflections show no steps.
constexpr double edge = 0.025;

double smoothStep(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The axes of a box: across, up, and towards it.
struct BoxFrame {
    explicit BoxFrame(const SoftBox& box) : forward(glm::normalize(box.towards)) {
        const glm::dvec3 helper = std::abs(forward.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
        across = glm::normalize(glm::cross(helper, forward));
        up = glm::cross(forward, across);
    }
    glm::dvec3 forward, across, up;
};

double boxRadiance(const SoftBox& box, const BoxFrame& frame, const glm::dvec3& direction) {
    const double distance = glm::dot(direction, frame.forward);
    if (distance <= 0.0) return 0.0;
    const auto cover = [&](const glm::dvec3& axis, double half) {
        return smoothStep((half - std::abs(glm::dot(direction, axis) / distance)) / edge + 0.5);
    };
    return box.radiance * cover(frame.across, box.halfWidth) * cover(frame.up, box.halfHeight);
}

/// The room darkens from the horizon down to the floor.
double roomRadiance(const glm::dvec3& direction) {
    const double down = smoothStep(-direction.y);
    return wallRadiance + (floorRadiance - wallRadiance) * down;
}

}  // namespace

Environment studioEnvironment() {
    std::array<BoxFrame, boxes.size()> frames{BoxFrame(boxes[0]), BoxFrame(boxes[1]), BoxFrame(boxes[2]),
                                              BoxFrame(boxes[3]), BoxFrame(boxes[4])};
    Environment studio;
    studio.picture = blackPicture("studio", width, height);
    studio.isBackground = false;
    const Equirect equirect(width, height);
    float* texel = numbersOf(studio.picture).data();
    for (std::uint32_t y = 0; y < height; ++y) {
        const Equirect::Row row = equirect.row(y);
        for (std::uint32_t x = 0; x < width; ++x, texel += 4) {
            const glm::dvec3 direction = equirect.direction(x, row);
            double radiance = roomRadiance(direction);
            for (std::size_t i = 0; i < boxes.size(); ++i)
                radiance = std::max(radiance, boxRadiance(boxes[i], frames[i], direction));
            std::fill_n(texel, 3, static_cast<float>(radiance));
            texel[3] = 1.0f;
        }
    }
    return studio;
}

}  // namespace candela
