#include "scene/model/key_values.h"

#include <algorithm>
#include <cassert>

namespace candela {

std::size_t KeyValues::numbersPerValue() const {
    const std::size_t parts = interpolation == Interpolation::cubicSpline ? 3 : 1;
    return values.size() / (times.size() * parts);
}

const float* KeyValues::value(std::size_t key, Part part) const {
    const bool cubic = interpolation == Interpolation::cubicSpline;
    const std::size_t index = cubic ? key * 3 + static_cast<std::size_t>(part) : key;
    return values.data() + index * numbersPerValue();
}

double KeyValues::number(std::size_t index, std::size_t key, Part part) const {
    return value(key, part)[index];
}

Moment KeyValues::momentAt(double time) const {
    assert(!times.empty());
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    const auto index = static_cast<std::size_t>(after - times.begin());
    const std::size_t key = index == 0 ? 0 : index - 1;
    const bool outside = index == 0 || index == times.size();
    if (outside || interpolation == Interpolation::step) return {key};
    const double start = times[key];
    const double duration = times[key + 1] - start;
    return {key, (time - start) / duration, duration};
}

// glTF 2.0, C.5: tangents are slopes per second.
double KeyValues::cubicSpline(std::size_t index, const Moment& moment) const {
    const double t = moment.t, t2 = t * t, t3 = t2 * t;
    return number(index, moment.key) * (2.0 * t3 - 3.0 * t2 + 1.0) +
           number(index, moment.key, Part::outTangent) * moment.duration * (t3 - 2.0 * t2 + t) +
           number(index, moment.key + 1) * (3.0 * t2 - 2.0 * t3) +
           number(index, moment.key + 1, Part::inTangent) * moment.duration * (t3 - t2);
}

double KeyValues::numberAt(std::size_t index, const Moment& moment) const {
    if (moment.duration == 0.0) return number(index, moment.key);
    if (interpolation == Interpolation::cubicSpline) return cubicSpline(index, moment);
    return number(index, moment.key) * (1.0 - moment.t) + number(index, moment.key + 1) * moment.t;
}

}  // namespace candela
