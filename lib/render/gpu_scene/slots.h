#pragma once

#include "base/error_context.h"

#include <candela/error.h>
#include <candela/handle.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace candela {

/// The places of the elements of one kind, which are given anew after a removal (see candela/handle.h).
class Slots {
  public:
    /// The first `count` places have elements. `kind` is such as "node".
    Slots(const char* kind, std::size_t count) : kind_(kind), generations_(count), alive_(count, true) {}

    std::size_t size() const { return alive_.size(); }
    bool isAlive(std::uint32_t index) const { return index < alive_.size() && alive_[index]; }
    std::uint32_t generation(std::uint32_t index) const { return generations_[index]; }

    /// The place of an element. Throws `Error` (badInput) where there never was one, or the handle is stale.
    template <typename Element>
    std::uint32_t indexOf(const Handle<Element>& handle) const {
        requireIndex(handle.index);
        if (isAlive(handle.index) && generations_[handle.index] == handle.generation) return handle.index;
        const std::string name = kind_ + (" " + std::to_string(handle.index));
        throw Error(ErrorKind::badInput, "",
                    "the handle of " + name + " is stale: that " + kind_ + " has been removed");
    }
    /// Refuses an element that refers to a place without one.
    void requireAlive(std::optional<std::uint32_t> index, const ErrorContext& referring) const {
        referring.requireIndex(kind_, index, size());
        if (index && !alive_[*index])
            referring.refuse(std::string("names ") + kind_ + " " + std::to_string(*index) +
                             ", which has been removed");
    }

    /// Takes a free place, over `above` where that is given, or a new one at the end.
    std::uint32_t add(std::optional<std::uint32_t> above = {}) {
        const auto free = above ? free_.upper_bound(*above) : free_.begin();
        if (free == free_.end()) {
            alive_.push_back(true);
            generations_.push_back(0);
            return static_cast<std::uint32_t>(alive_.size() - 1);
        }
        const std::uint32_t index = *free;
        free_.erase(free);
        alive_[index] = true;
        return index;
    }
    /// The place that `add` would take.
    std::uint32_t next(std::optional<std::uint32_t> above = {}) const {
        const auto free = above ? free_.upper_bound(*above) : free_.begin();
        return free == free_.end() ? static_cast<std::uint32_t>(alive_.size()) : *free;
    }
    /// A new place that is never given away.
    void addUnused() {
        alive_.push_back(false);
        generations_.push_back(0);
    }
    void remove(std::uint32_t index) {
        alive_[index] = false;
        ++generations_[index];
        free_.insert(index);
    }
    void removeAll() {
        for (std::uint32_t i = 0; i < alive_.size(); ++i) {
            if (alive_[i]) remove(i);
        }
    }

  private:
    void requireIndex(std::uint32_t index) const {
        if (index < alive_.size()) return;
        throw Error(ErrorKind::badInput, "",
                    std::string("there is no ") + kind_ + " " + std::to_string(index) + ": the scene has " +
                        std::to_string(alive_.size()) + " (counted from 0)");
    }

    const char* kind_;
    std::vector<std::uint32_t> generations_;
    std::vector<bool> alive_;
    std::set<std::uint32_t> free_;
};

}  // namespace candela
