#include "comparison.h"

#include <candela/error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace {

/// Half a step of half floats at the farthest light's coordinates, metres.
double positionRounding(const BenchScene& scene) {
    float farthest = 1.0f;
    for (const candela::WorldLight& light : scene.lights)
        for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(light.position[axis]));
    return std::exp2(std::floor(std::log2(static_cast<double>(farthest))) - 11.0);
}

double shortestRange(const BenchScene& scene) {
    float shortest = 1.0e9f;
    for (const candela::WorldLight& light : scene.lights)
        if (light.range > 0.0f) shortest = std::min(shortest, light.range);
    return static_cast<double>(shortest);
}

}  // namespace

double allowedDifference(const std::string& technique, const BenchScene& scene) {
    if (!technique.starts_with("textbook")) return 1.0e-5;
    return 0.02 + 4.0 * std::sqrt(3.0) * positionRounding(scene) / shortestRange(scene);
}

void compare(Result& result, const std::vector<float>& picture, const Reference& reference, double allowed) {
    double total = 0.0, most = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double other = static_cast<double>(reference.picture[i]);
        const double difference = std::abs(static_cast<double>(picture[i]) - other);
        total += difference;
        most = std::max(most, difference);
        sum += other;
    }
    // A black picture has no mean to compare with: the difference is then absolute.
    const auto values = static_cast<double>(picture.size());
    const double scale = sum > 0.0 ? values / sum : 1.0;
    result.difference = Difference{reference.technique, scale * most, scale * total / values};
    // Not a number is no agreement.
    if (result.difference->mean <= allowed) return;
    std::ostringstream text;
    text << "with " << result.lights << " lights, " << result.technique << " draws another picture than "
         << reference.technique << ": they differ by " << result.difference->mean << " of the mean, "
         << allowed << " is allowed";
    throw candela::Error(candela::ErrorKind::badInput, result.scene, text.str());
}
