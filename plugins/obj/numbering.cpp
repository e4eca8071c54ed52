#include "numbering.h"

namespace candela_obj {
namespace {

/// The finaliser of the SplitMix64 generator (Steele, Lea and Flood, 2014), which spreads every bit.
std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
}

std::uint64_t hashOf(const Numbering::Key& key) {
    return mixed(mixed(std::uint64_t{key[0]} << 32 | key[1]) + key[2]);
}

}  // namespace

std::size_t Numbering::slotOf(const Key& key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hashOf(key) & mask;
    while (slots_[slot] != empty && keys_[slots_[slot]] != key) slot = (slot + 1) & mask;
    return slot;
}

void Numbering::grow() {
    slots_.assign(slots_.size() * 2, empty);
    for (std::size_t i = 0; i < keys_.size(); ++i) slots_[slotOf(keys_[i])] = static_cast<std::uint32_t>(i);
}

std::uint32_t Numbering::numberOf(const Key& key) {
    std::size_t slot = slotOf(key);
    if (slots_[slot] != empty) return slots_[slot];
    if (keys_.size() * 2 >= slots_.size()) {
        grow();
        slot = slotOf(key);
    }
    slots_[slot] = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return slots_[slot];
}

}  // namespace candela_obj
