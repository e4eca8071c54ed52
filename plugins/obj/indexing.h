#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace candela_plugins::obj {

/// Assigns the indices 0, 1, 2, ... to distinct names, in the order of their first use.
class NameIndex {
  public:
    std::uint32_t indexOf(std::string_view name) {
        const auto [found, isNew] =
            indices_.try_emplace(std::string(name), static_cast<std::uint32_t>(names_.size()));
        if (isNew) names_.emplace_back(name);
        return found->second;
    }
    const std::string& operator[](std::size_t index) const { return names_[index]; }
    std::size_t size() const { return names_.size(); }

  private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, std::uint32_t> indices_;
};

/// Assigns the indices 0, 1, 2, ... to distinct keys, in the order of their first use.
class KeyIndex {
  public:
    using Key = std::array<std::uint32_t, 3>;

    KeyIndex() : table_(minTableSize, empty) {}

    std::uint32_t indexOf(const Key& key);
    /// By their indices.
    const std::vector<Key>& keys() const { return keys_; }

  private:
    static constexpr std::size_t minTableSize = 16;
    static constexpr std::uint32_t empty = 0xFFFFFFFFu;

    std::size_t slotOf(const Key& key) const;
    void grow();

    std::vector<Key> keys_;
    std::vector<std::uint32_t> table_;  // open addressing; a power of two of them
};

}  // namespace candela_plugins::obj
