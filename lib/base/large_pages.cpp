#include "base/large_pages.h"

#include "base/thread_pool.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace candela {

namespace {

/// Whole pages, from one address to another.
struct Pages {
    std::uintptr_t begin, end;
};

// What fails leaves the memory as it is: its pages come one by one then, when it is written.
void advise(const Pages& pages, int advice) {
    ::madvise(reinterpret_cast<void*>(pages.begin), pages.end - pages.begin, advice);
}

#if defined(MADV_POPULATE_WRITE)
void populate(const Pages& pages) {
    constexpr std::size_t part = std::size_t{16} << 20;
    ThreadPool::shared()->run((pages.end - pages.begin + part - 1) / part, [&](std::size_t i, unsigned) {
        const std::uintptr_t begin = pages.begin + i * part;
        advise({begin, std::min(begin + part, pages.end)}, MADV_POPULATE_WRITE);
    });
}
#endif

}  // namespace

void requestLargePages(void* memory, std::size_t bytes) {
#if defined(MADV_HUGEPAGE)
    // Two large pages of the usual size: at least one of them lies within.
    constexpr std::size_t minBytes = std::size_t{4} << 20;
    if (bytes < minBytes) return;
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const Pages pages{(address + page - 1) / page * page, (address + bytes) / page * page};
    advise(pages, MADV_HUGEPAGE);
#if defined(MADV_POPULATE_WRITE)
    populate(pages);
#endif
#else
    static_cast<void>(memory);
    static_cast<void>(bytes);
#endif
}

}  // namespace candela
