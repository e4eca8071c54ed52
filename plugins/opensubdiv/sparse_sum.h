#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela_opensubdiv {

/// A row of a sparse matrix while it is summed up. Its columns stand in the order in which they came. `Value`
/// is added with += to itself; adding takes the same time for long rows as for short ones.
template <typename Value>
class SparseSum {
  public:
    explicit SparseSum(std::size_t columnCount) : places_(columnCount, none) {}

    void clear() {
        for (const int column : columns_) places_[static_cast<std::size_t>(column)] = none;
        columns_.clear();
        values_.clear();
    }

    void add(int column, const Value& value) {
        std::uint32_t& place = places_[static_cast<std::size_t>(column)];
        if (place != none) {
            values_[place] += value;
            return;
        }
        place = static_cast<std::uint32_t>(columns_.size());
        columns_.push_back(column);
        values_.push_back(value);
    }

    std::span<const int> columns() const { return columns_; }
    std::span<const Value> values() const { return values_; }
    std::span<Value> values() { return values_; }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::vector<int> columns_;
    std::vector<Value> values_;
    std::vector<std::uint32_t> places_;  ///< Of each column in the row.
};

}  // namespace candela_opensubdiv
