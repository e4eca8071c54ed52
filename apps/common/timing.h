#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

/// Wall-clock milliseconds since `start`.
inline double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Wall-clock milliseconds that `work` takes.
template <typename Work>
double measureMilliseconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return millisecondsSince(start);
}

/// The median of one or more numbers.
inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}
