#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sparse_sum.h"

namespace candela_opensubdiv {

/// Finished rows of a sparse matrix.
class SparseRows {
  public:
    struct Entry {
        int column;
        double weight;
    };

    std::size_t size() const { return rows_.size(); }

    std::span<const Entry> operator[](std::size_t row) const {
        return {entries_.data() + rows_[row].first, rows_[row].count};
    }

    /// Adds empty rows.
    void grow(std::size_t count) { rows_.resize(rows_.size() + count); }

    /// Makes a row what has been summed up.
    void set(std::size_t row, const SparseSum<double>& sum) {
        rows_[row] = {entries_.size(), static_cast<std::uint32_t>(sum.columns().size())};
        for (std::size_t i = 0; i < sum.columns().size(); ++i) {
            entries_.push_back({sum.columns()[i], sum.values()[i]});
        }
    }

  private:
    struct Row {
        std::size_t first = 0;
        std::uint32_t count = 0;
    };

    std::vector<Row> rows_;
    std::vector<Entry> entries_;
};

}  // namespace candela_opensubdiv
