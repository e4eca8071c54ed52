#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace candela {

/// The CPUs that the affinity mask of the calling thread allows, 1 or more.
unsigned affinityThreads();

/// The CPUs' worth of time that control groups grant, rounded up, 1 or more; none where nothing limits it.
/// `membership` is the text of /proc/self/cgroup, `mount` stands for /sys/fs/cgroup. A group is limited by
/// every group above it too.
std::optional<unsigned> cgroupThreads(const std::filesystem::path& mount, const std::string& membership);

}  // namespace candela
