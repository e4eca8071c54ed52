#include "animation_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

std::size_t numbersPerKey(const AnimationKeys& keys) {
    return keys.values.size() / keys.times.size();
}

bool isSorted(const std::vector<float>& times) {
    return std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end();
}

void sortByTime(AnimationKeys& keys) {
    std::vector<std::size_t> order(keys.times.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keys.times[a] < keys.times[b]; });
    const std::size_t width = numbersPerKey(keys);
    AnimationKeys sorted;
    for (const std::size_t key : order) {
        sorted.times.push_back(keys.times[key]);
        const auto begin = keys.values.begin() + static_cast<std::ptrdiff_t>(key * width);
        sorted.values.insert(sorted.values.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    }
    keys = std::move(sorted);
}

void separateEqualTimes(std::vector<float>& times) {
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] > times[i - 1]) continue;
        times[i] = std::nextafter(times[i - 1], std::numeric_limits<float>::max());
    }
}

/// The value at time 0 of linear keys, the first of which lies before and the second after it.
void interpolateFirst(AnimationKeys& keys, bool isRotation) {
    const std::size_t width = numbersPerKey(keys);
    const double share = -double{keys.times[0]} / (double{keys.times[1]} - keys.times[0]);
    double cosine = 0.0;
    for (std::size_t i = 0; i < width; ++i) cosine += double{keys.values[i]} * keys.values[width + i];
    // Of the two quaternions of a rotation the nearer one. The way between is straight, as near as it is.
    const double sign = isRotation && cosine < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < width; ++i) {
        const double from = keys.values[i], to = sign * keys.values[width + i];
        keys.values[i] = static_cast<float>(from + (to - from) * share);
    }
}

void startAtZero(candela_interpolation interpolation, bool isRotation, AnimationKeys& keys) {
    const auto firstAfter = std::upper_bound(keys.times.begin(), keys.times.end(), 0.0f);
    const auto last = static_cast<std::ptrdiff_t>(firstAfter - keys.times.begin()) - 1;  // at or before 0
    if (last < 0) return;
    const auto width = static_cast<std::ptrdiff_t>(numbersPerKey(keys));
    keys.values.erase(keys.values.begin(), keys.values.begin() + last * width);
    keys.times.erase(keys.times.begin(), keys.times.begin() + last);
    const bool isBetween = keys.times.front() < 0.0f && keys.times.size() > 1;
    if (isBetween && interpolation == CANDELA_INTERPOLATE_LINEAR) interpolateFirst(keys, isRotation);
    keys.times.front() = 0.0f;
}

/// The quaternion of key `key`: the middle one of a cubic spline's three.
float* rotationOf(AnimationKeys& keys, std::size_t key) {
    const std::size_t width = numbersPerKey(keys);
    return keys.values.data() + key * width + (width > 4 ? 4 : 0);
}

bool repairRotations(AnimationKeys& keys) {
    bool repaired = false;
    for (std::size_t key = 0; key < keys.times.size(); ++key) {
        float* q = rotationOf(keys, key);
        if (!std::all_of(q, q + 4, [](float number) { return number == 0.0f; })) continue;
        q[3] = 1.0f;
        repaired = true;
    }
    return repaired;
}

/// Calls `use` with each number of the values themselves: of a cubic spline's keys, the middle third.
template <typename Use>
void forEachValue(AnimationKeys& keys, candela_interpolation interpolation, const Use& use) {
    const bool cubic = interpolation == CANDELA_INTERPOLATE_CUBIC_SPLINE;
    const std::size_t width = numbersPerKey(keys), first = cubic ? width / 3 : 0;
    const std::size_t end = cubic ? 2 * first : width;
    for (std::size_t key = 0; key < keys.times.size(); ++key)
        for (std::size_t i = first; i < end; ++i) use(keys.values[key * width + i]);
}

void requireSize(const AnimationKeys& keys, const std::string& element) {
    constexpr float max = 1e9f;  // the host's
    const bool fits = std::all_of(keys.values.begin(), keys.values.end(),
                                  [](float value) { return std::abs(value) <= max; });
    if (!fits) throw Failure{element + ", output", "has a number beyond 1e9"};
}

void clampValues(const KeyForm& form, candela_interpolation interpolation, AnimationKeys& keys,
                 const std::string& element, const Host& host) {
    bool isClamped = false;
    forEachValue(keys, interpolation, [&](float& value) {
        const float clamped = std::clamp(value, form.min, form.max);
        isClamped = isClamped || clamped != value;
        value = clamped;
    });
    if (isClamped)
        host.note(CANDELA_NOTE_REPAIRED, element, "values that the property does not have: clamped");
}

void repairKeys(const KeyForm& form, candela_interpolation interpolation, AnimationKeys& keys,
                const std::string& element, const Host& host) {
    if (form.clamps)
        clampValues(form, interpolation, keys, element, host);
    else
        requireSize(keys, element);
    if (!isSorted(keys.times)) {
        host.note(CANDELA_NOTE_REPAIRED, element, "key times that do not increase: sorted");
        sortByTime(keys);
        separateEqualTimes(keys.times);
    }
    if (keys.times.front() < 0.0f) {
        host.note(CANDELA_NOTE_REPAIRED, element, "key times before 0: cut off there");
        startAtZero(interpolation, form.isRotation, keys);
    }
    if (form.isRotation && repairRotations(keys)) {
        host.note(CANDELA_NOTE_REPAIRED, element, "rotations of length 0: not rotated");
    }
}

}  // namespace

candela_interpolation interpolationOf(const tinygltf::AnimationSampler& sampler) {
    if (sampler.interpolation == "STEP") return CANDELA_INTERPOLATE_STEP;
    return sampler.interpolation == "CUBICSPLINE" ? CANDELA_INTERPOLATE_CUBIC_SPLINE
                                                  : CANDELA_INTERPOLATE_LINEAR;
}

AnimationKeys readKeys(const Document& document, const tinygltf::AnimationSampler& sampler,
                       const KeyForm& form, const std::string& element, const Host& host) {
    const candela_interpolation interpolation = interpolationOf(sampler);
    AnimationKeys keys;
    keys.times = readFloats(document, sampler.input, 1, onlyFloat, element + ", input");
    const std::size_t parts = interpolation == CANDELA_INTERPOLATE_CUBIC_SPLINE ? 3 : 1;
    const std::size_t expected = keys.times.size() * form.elements * parts;
    const std::size_t count = document.model.accessors.at(static_cast<std::size_t>(sampler.output)).count;
    const std::string where = element + ", output";
    if (count != expected) {
        throw Failure{where, "accessor " + std::to_string(sampler.output) + " has " + std::to_string(count) +
                                 " elements, expected " + std::to_string(expected)};
    }
    keys.values = readFloats(document, sampler.output, form.components, form.encodings, where);
    for (float& value : keys.values) value *= form.factor;
    repairKeys(form, interpolation, keys, element, host);
    return keys;
}

}  // namespace candela_plugins::gltf
