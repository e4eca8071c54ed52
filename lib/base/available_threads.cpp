#include "base/available_threads.h"

#include <candela/threads.h>

#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

namespace candela {

namespace {

namespace fs = std::filesystem;

using Limit = std::optional<unsigned>;

Limit minLimit(Limit a, Limit b) {
    if (!a || !b) return a ? a : b;
    return std::min(*a, *b);
}

// `quota` microseconds of CPU time in every `period`.
Limit threadsOf(double quota, double period) {
    if (!(quota > 0.0) || !(period > 0.0)) return {};
    // Compared in double precision: a quota may be larger than any number of cores.
    const double threads = (quota + period - 1.0) / period;
    return threads < maxThreadCount ? std::max(1u, static_cast<unsigned>(threads)) : maxThreadCount;
}

std::optional<double> readNumber(const fs::path& path) {
    std::ifstream file(path);
    double number = 0.0;
    if (!(file >> number)) return {};
    return number;
}

// cgroup v2: "QUOTA PERIOD", where the quota is "max" without a limit.
Limit limitOfV2(const fs::path& group) {
    std::ifstream file(group / "cpu.max");
    double quota = 0.0, period = 0.0;
    if (!(file >> quota >> period)) return {};
    return threadsOf(quota, period);
}

// cgroup v1: the quota is -1 without a limit.
Limit limitOfV1(const fs::path& group) {
    const std::optional<double> quota = readNumber(group / "cpu.cfs_quota_us");
    const std::optional<double> period = readNumber(group / "cpu.cfs_period_us");
    return quota && period ? threadsOf(*quota, *period) : Limit{};
}

// The limit of `group`, such as "/a/b", and of all groups above it. In a container the group's own folder may
// not be mounted; the root then is the container's.
template <typename LimitOf>
Limit limitOfGroups(const fs::path& hierarchy, const std::string& group, const LimitOf& limitOf) {
    fs::path folder = hierarchy;
    Limit limit = limitOf(folder);
    for (const fs::path& part : fs::path(group).relative_path()) {
        folder /= part;
        limit = minLimit(limit, limitOf(folder));
    }
    return limit;
}

bool hasCpu(const std::string& controllers) {
    std::istringstream list(controllers);
    for (std::string name; std::getline(list, name, ',');) {
        if (name == "cpu") return true;
    }
    return false;
}

std::string textOf(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

unsigned affinityThreads() {
    // The kernel's mask may be larger than `cpu_set_t`.
    for (int cpus = CPU_SETSIZE; cpus <= 1 << 20; cpus *= 2) {
        const std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> set(CPU_ALLOC(cpus),
                                                                   [](cpu_set_t* s) { CPU_FREE(s); });
        if (!set) break;
        const std::size_t bytes = CPU_ALLOC_SIZE(cpus);
        CPU_ZERO_S(bytes, set.get());
        if (sched_getaffinity(0, bytes, set.get()) == 0)
            return static_cast<unsigned>(std::max(1, CPU_COUNT_S(bytes, set.get())));
        if (errno != EINVAL) break;
    }
    return std::max(1u, std::thread::hardware_concurrency());
}

std::optional<unsigned> cgroupThreads(const fs::path& mount, const std::string& membership) {
    Limit limit;
    std::istringstream lines(membership);
    for (std::string line; std::getline(lines, line);) {
        // "HIERARCHY:CONTROLLERS:GROUP"; v2 has hierarchy 0 and no controllers.
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string group = line.substr(second + 1);
        if (controllers.empty()) {
            limit = minLimit(limit, limitOfGroups(mount, group, limitOfV2));
            limit = minLimit(limit, limitOfGroups(mount / "unified", group, limitOfV2));
        } else if (hasCpu(controllers)) {
            for (const std::string& hierarchy : {controllers, std::string("cpu")})
                limit = minLimit(limit, limitOfGroups(mount / hierarchy, group, limitOfV1));
        }
    }
    return limit;
}

unsigned availableThreads() {
    const unsigned threads = std::min(affinityThreads(), maxThreadCount);
    const Limit granted = cgroupThreads("/sys/fs/cgroup", textOf("/proc/self/cgroup"));
    return granted ? std::min(threads, *granted) : threads;
}

}  // namespace candela
