#pragma once

#include <candela/environment.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace candela::test {

/// The picture of a sky of width × width / 2 texels, whose radiance `radiance` gives for each direction.
Image makeSky(std::uint32_t width, const std::function<glm::vec3(const glm::dvec3& direction)>& radiance);

/// A texel of a sky as a source of light.
struct SkyTexel {
    glm::dvec3 direction;  ///< Unit length, in the picture's frame.
    double solidAngle;
    glm::dvec3 radiance;
};

/// All texels of a sky, for integration in double precision.
std::vector<SkyTexel> texelsOf(const Image& picture);

struct NamedSky {
    std::string name;
    Image picture;
};

/// A constant sky, a gradient over a dark ground, the same with a sun a thousand times as bright, a checker
/// of 16 × 8 fields, and three soft boxes in a dark room.
std::vector<NamedSky> skies(std::uint32_t width);

/// A sun of radius 0.009 (twice the real one) for a width of 2048: 50,000 times as bright as the sky, of
/// three times its irradiance.
NamedSky hardSun(std::uint32_t width);

/// Directions that cover the sphere evenly.
std::vector<glm::dvec3> sphereDirections(int count);

}  // namespace candela::test
