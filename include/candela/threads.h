#pragma once

#include <candela/export.h>

namespace candela {

/// The maximum number of threads that `setThreadCount` takes.
constexpr unsigned maxThreadCount = 1024;

/// The number of cores this process may use, 1 or more: those of its affinity mask (`sched_getaffinity`), at
/// most the CPU time that its control groups grant (cgroup v2 `cpu.max`, v1 `cpu.cfs_quota_us`), rounded up.
CANDELA_API unsigned availableThreads();

/// Sets how many threads all parallel work of the library shares, the calling thread included; 0 (default)
/// stands for `availableThreads()`. Work that is under way keeps the threads it has. Throws `Error`
/// (badInput) when `count` is over `maxThreadCount`.
CANDELA_API void setThreadCount(unsigned count);

/// How many threads parallel work uses: what `setThreadCount` was given, else `availableThreads()`.
CANDELA_API unsigned threadCount();

}  // namespace candela
