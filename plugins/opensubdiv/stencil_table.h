#pragma once

#include <candela/plugin.h>

#include <cstdint>
#include <span>
#include <vector>

#include "sparse_sum.h"

namespace candela_opensubdiv {

/// Of the value and of both derivatives.
struct Weights {
    double value = 0.0, du = 0.0, dv = 0.0;

    Weights operator*(double factor) const { return {value * factor, du * factor, dv * factor}; }
    Weights& operator+=(const Weights& other) {
        value += other.value;
        du += other.du;
        dv += other.dv;
        return *this;
    }
};

/// A row of the table before it is rounded.
using RowSum = SparseSum<Weights>;

/// Replaces the derivatives of a row by those of another, which may have other columns.
void replaceDerivatives(RowSum& row, const RowSum& other);

/// One of the columns of a row.
struct WeightEntry {
    std::uint32_t column;
    float value, du, dv;
};

/// Rows of weights that grow at the end.
struct StencilTable {
    std::vector<std::uint32_t> lengths;  ///< The entries of each row.
    std::vector<WeightEntry> entries;

    /// Rounds to single precision, and leaves out the columns that have no weight at all.
    void add(const RowSum& row);
};

/// All rows of the table in one piece, as the host takes them.
class WeightTable {
  public:
    /// Empties the parts. Throws `Failure` where 32 bits do not count the entries.
    explicit WeightTable(std::span<StencilTable* const> parts);

    /// Lasts as long as the table.
    candela_stencil_table view() const;

  private:
    std::vector<std::uint32_t> starts_{0};
    std::vector<std::uint32_t> columns_;
    std::vector<float> weights_, duWeights_, dvWeights_;
};

}  // namespace candela_opensubdiv
