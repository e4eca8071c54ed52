#include "import/large_array.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace candela {

void adviseLargePages(void* memory, std::size_t bytes) noexcept {
#if defined(MADV_HUGEPAGE)
    // Two of the usual large pages: one at least lies within.
    constexpr std::size_t minBytes = std::size_t{4} << 20;
    if (bytes < minBytes) return;
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    // A refusal changes only how long it takes.
    ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#else
    static_cast<void>(memory);
    static_cast<void>(bytes);
#endif
}

}  // namespace candela
