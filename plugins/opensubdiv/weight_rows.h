#pragma once

#include <candela/plugin.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// A row while it is summed up in double precision. Its columns stand in the order in which they came.
class RowSum {
  public:
    explicit RowSum(std::size_t columnCount) : places_(columnCount, none) {}

    void clear() {
        for (const int column : columns_) places_[static_cast<std::size_t>(column)] = none;
        columns_.clear();
        weights_.clear();
    }

    void add(int column, const Weights& weights) {
        std::uint32_t& place = places_[static_cast<std::size_t>(column)];
        if (place != none) {
            weights_[place] += weights;
            return;
        }
        place = static_cast<std::uint32_t>(columns_.size());
        columns_.push_back(column);
        weights_.push_back(weights);
    }

    std::span<const int> columns() const { return columns_; }
    std::span<const Weights> weights() const { return weights_; }

    /// Takes the derivatives of another row, which may have other columns.
    void takeDerivatives(const RowSum& other);

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::vector<int> columns_;
    std::vector<Weights> weights_;
    std::vector<std::uint32_t> places_;  ///< Of each column in the row.
};

/// One of the columns of a row.
struct WeightEntry {
    std::uint32_t column;
    float value, du, dv;
};

/// Rows of weights that grow at the end.
struct WeightRows {
    std::vector<std::uint32_t> lengths;  ///< The entries of each row.
    std::vector<WeightEntry> entries;

    /// Rounds to single precision, and leaves out the columns that have no weight at all.
    void add(const RowSum& row);
};

/// All rows of the table in one piece, as the host takes them.
class WeightTable {
  public:
    /// Empties the parts. Throws `Failure` where 32 bits do not count the entries.
    explicit WeightTable(std::span<WeightRows* const> parts);

    /// Lasts as long as the table.
    candela_weight_rows view() const;

  private:
    std::vector<std::uint32_t> starts_{0};
    std::vector<std::uint32_t> columns_;
    std::vector<float> weights_, duWeights_, dvWeights_;
};

}  // namespace candela_opensubdiv
