#include "available_memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

namespace candela_plugins::plaza {
namespace {

constexpr std::uint64_t unknown = UINT64_MAX;

/// The number after `key` in a file of lines "key number unit", in bytes.
std::uint64_t kilobytesOf(const char* path, const std::string& key) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(key)) return std::strtoull(line.c_str() + key.size(), nullptr, 10) * 1024;
    return unknown;
}

/// The only number of a file; a word, such as "max", stands for no limit.
std::uint64_t numberOf(const char* path) {
    std::uint64_t number = 0;
    return std::ifstream(path) >> number ? number : unknown;
}

std::uint64_t leftOf(std::uint64_t limit, std::uint64_t used) {
    if (limit == unknown || used == unknown) return unknown;
    return limit > used ? limit - used : 0;
}

std::uint64_t addressSpaceLimit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
    return limit.rlim_cur;
}

}  // namespace

std::uint64_t availableMemory() {
    const std::uint64_t group =
        leftOf(numberOf("/sys/fs/cgroup/memory.max"), numberOf("/sys/fs/cgroup/memory.current"));
    const std::uint64_t addresses = leftOf(addressSpaceLimit(), kilobytesOf("/proc/self/status", "VmSize:"));
    return std::min({kilobytesOf("/proc/meminfo", "MemAvailable:"), group, addresses});
}

}  // namespace candela_plugins::plaza
