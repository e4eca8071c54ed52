#pragma once

#include <cstdint>

namespace candela {

/// A run of indices.
struct IndexRange {
    std::uint32_t first = 0, count = 0;
};

}  // namespace candela
