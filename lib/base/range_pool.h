#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace candela {

/// Ranges of the elements of a buffer that are given away and freed. The buffer itself is whose pool it is.
class RangePool {
  public:
    /// All elements are given away.
    explicit RangePool(std::uint64_t capacity = 0) : capacity_(capacity) {}

    std::uint64_t capacity() const { return capacity_; }
    /// The first of `count` free elements; 0 of none. None where the pool has to grow.
    std::optional<std::uint64_t> take(std::uint64_t count);
    /// Frees a range that was given away, or a part of one.
    void free(std::uint64_t first, std::uint64_t count);
    /// Adds free elements at the end. `capacity` is at least the present one.
    void growTo(std::uint64_t capacity);
    /// How many elements at the end are free.
    std::uint64_t freeAtEnd() const;

  private:
    std::uint64_t capacity_;
    std::map<std::uint64_t, std::uint64_t> free_;  ///< Number of elements by the first one; none adjoin.
};

}  // namespace candela
