#pragma once

#include <cstddef>
#include <functional>

namespace candela_opensubdiv {

/// How many threads `inParallel` runs at most: 1 or more.
std::size_t workerCount();

/// Calls `work(item, worker)` for the items 0, 1, ... `count` - 1, on all cores. `worker`, below
/// `workerCount()`, tells threads apart. The first exception that one of them throws is thrown again when all
/// are done.
void inParallel(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace candela_opensubdiv
