#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace candela {

// Loops over very many values, on all cores.

/// Values that are worth a task of their own: tens of microseconds.
constexpr std::size_t runLength = 16384;

/// Calls `body(first, end)` for consecutive runs of the numbers below `count`, each at most `runLength` long,
/// on all cores.
void inRuns(std::size_t count, const std::function<void(std::size_t first, std::size_t end)>& body);

/// Does `holds` hold for each of the values? It is asked on all cores.
template <typename Values, typename Rule>
bool holdsForAll(const Values& values, const Rule& holds) {
    const auto holdsIn = [&](std::size_t first, std::size_t end) {
        bool all = true;
        // Without a branch for each value, so that the compiler can vectorise it.
        for (std::size_t i = first; i < end; ++i) all &= static_cast<bool>(holds(values[i]));
        return all;
    };
    if (values.size() <= runLength) return holdsIn(0, values.size());
    std::atomic<bool> isBroken = false;
    inRuns(values.size(), [&](std::size_t first, std::size_t end) {
        if (!holdsIn(first, end)) isBroken = true;
    });
    return !isBroken;
}

/// Calls `body(index)` for each index below `count`, on all cores; it may run loops over the `sizeOf(index)`
/// values of its element on all cores too, which it does where these are many. Of the exceptions that it
/// throws, that of the lowest index is thrown again, whatever the number of threads.
void forEachElement(std::size_t count, const std::function<std::size_t(std::size_t index)>& sizeOf,
                    const std::function<void(std::size_t index)>& body);

}  // namespace candela
