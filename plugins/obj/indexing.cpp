#include "indexing.h"

namespace candela_plugins::obj {

namespace {

/// The finaliser of the SplitMix64 generator (Steele, Lea and Flood, 2014), which spreads every bit.
std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
}

std::uint64_t hashOf(const KeyIndex::Key& key) {
    return mixed(mixed(std::uint64_t{key[0]} << 32 | key[1]) + key[2]);
}

}  // namespace

std::size_t KeyIndex::slotOf(const Key& key) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = hashOf(key) & mask;
    while (table_[slot] != empty && keys_[table_[slot]] != key) slot = (slot + 1) & mask;
    return slot;
}

void KeyIndex::grow() {
    table_.assign(table_.size() * 2, empty);
    for (std::size_t i = 0; i < keys_.size(); ++i) table_[slotOf(keys_[i])] = static_cast<std::uint32_t>(i);
}

std::uint32_t KeyIndex::indexOf(const Key& key) {
    std::size_t slot = slotOf(key);
    if (table_[slot] != empty) return table_[slot];
    if (keys_.size() * 2 >= table_.size()) {
        grow();
        slot = slotOf(key);
    }
    table_[slot] = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return table_[slot];
}

}  // namespace candela_plugins::obj
