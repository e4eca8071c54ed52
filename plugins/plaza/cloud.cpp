// The layout of Bevy's stress test of many lights: small lights far from the camera, each a few pixels wide.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

constexpr double cloudRadius = 50.0;  // metres
// Half a light's range behind the lights. The facets of the shell lie up to 0.008 m nearer than its corners.
constexpr float shellRadius = 50.15f;
constexpr std::uint32_t shellSegments = 256;
constexpr float lightCandela = 0.05f;
constexpr float lightRange = 0.3f;  // metres
constexpr double twoPi = 6.28318530717958647692;
constexpr double goldenFraction = 0.61803398874989484820;  // of a revolution, from one light to the next

void addShell(const Host& host) {
    const std::string name = "shell";
    Geometry shell = makeSphere(shellRadius, shellSegments, shellSegments / 2);
    flipFaces(shell);
    addGeometry(host, shell, addGreyMaterial(host, name, 0.75f, 0.6f), name);
}

// A Fibonacci sphere: equal steps in height, with the golden fraction of a revolution between them.
candela_light lightAt(std::uint32_t index, std::uint32_t count) {
    const double y = 1.0 - 2.0 * (index + 0.5) / count;
    const double around = std::sqrt(1.0 - y * y);
    const double revolutions = index * goldenFraction,
                 angle = twoPi * (revolutions - std::floor(revolutions));
    candela_light light = plainLight(lightCandela, lightRange);
    light.position[0] = static_cast<float>(cloudRadius * around * gridSine(angle));
    light.position[1] = static_cast<float>(cloudRadius * y);
    light.position[2] = static_cast<float>(cloudRadius * around * gridCosine(angle));
    const std::array<float, 3> color = hueColor(hashedFraction(index, 0));
    std::copy(color.begin(), color.end(), light.color);
    return light;
}

}  // namespace

void makeCloud(const Host& host, const std::string& arguments) {
    const std::uint32_t lights = parseCount(arguments, "number of lights", "cloud:100000");
    addShell(host);
    const std::string name = "camera";
    addCamera(host, plainNode(name, -1));
    addLights(host, lights, [&](std::uint32_t index) { return lightAt(index, lights); });
}

}  // namespace candela_plugins::plaza
