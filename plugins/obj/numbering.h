#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela_obj {

/// Numbers distinct keys 0, 1, 2, ... in the order in which they come.
class Numbering {
  public:
    using Key = std::array<std::uint32_t, 3>;

    Numbering() : slots_(smallest, empty) {}

    std::uint32_t numberOf(const Key& key);
    /// By their numbers.
    const std::vector<Key>& keys() const { return keys_; }

  private:
    static constexpr std::size_t smallest = 16;
    static constexpr std::uint32_t empty = 0xFFFFFFFFu;

    std::size_t slotOf(const Key& key) const;
    void grow();

    std::vector<Key> keys_;
    std::vector<std::uint32_t> slots_;  // open addressing; a power of two of them
};

}  // namespace candela_obj
