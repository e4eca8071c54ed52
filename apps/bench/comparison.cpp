#include "comparison.h"

#include <candela/error.h>

#include <cmath>
#include <sstream>

double allowedDifference(const std::string& technique) {
    return technique.starts_with("textbook") ? 5.0e-2 : 1.0e-5;
}

void compare(Result& result, const std::vector<float>& picture, const Reference& reference) {
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        difference += std::abs(static_cast<double>(picture[i]) - static_cast<double>(reference.picture[i]));
        sum += static_cast<double>(reference.picture[i]);
    }
    result.difference = sum > 0.0 ? difference / sum : difference;
    result.reference = reference.technique;
    if (*result.difference <= allowedDifference(result.technique)) return;
    std::ostringstream text;
    text << "with " << result.lights << " lights, " << result.technique << " draws another picture than "
         << reference.technique << ": they differ by " << *result.difference << " of the mean, "
         << allowedDifference(result.technique) << " is allowed";
    throw candela::Error(candela::ErrorKind::badInput, result.scene, text.str());
}
