#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela_plugins::opensubdiv {

/// A sum of weighted points, by the index of each point. The indices keep the order in which they were added.
/// `Value` is a weight, which is added with +=. The time of `add` does not depend on the length of the
/// stencil.
template <typename Value>
class StencilSum {
  public:
    explicit StencilSum(std::size_t indexCount) : places_(indexCount, none) {}

    void clear() {
        for (const int index : indices_) places_[static_cast<std::size_t>(index)] = none;
        indices_.clear();
        values_.clear();
    }

    void add(int index, const Value& value) {
        std::uint32_t& place = places_[static_cast<std::size_t>(index)];
        if (place != none) {
            values_[place] += value;
            return;
        }
        place = static_cast<std::uint32_t>(indices_.size());
        indices_.push_back(index);
        values_.push_back(value);
    }

    std::span<const int> indices() const { return indices_; }
    std::span<const Value> values() const { return values_; }
    std::span<Value> values() { return values_; }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::vector<int> indices_;
    std::vector<Value> values_;
    std::vector<std::uint32_t> places_;  ///< Of each index in `indices_`; `none` where it has none.
};

/// The weights of a value and of its two derivatives.
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

/// The stencil of a limit point, in double precision.
using LimitStencil = StencilSum<Weights>;

/// Complete stencils.
class StencilList {
  public:
    struct Entry {
        int index;
        double weight;
    };

    std::size_t size() const { return stencils_.size(); }

    std::span<const Entry> operator[](std::size_t stencil) const {
        return {entries_.data() + stencils_[stencil].first, stencils_[stencil].count};
    }

    /// Adds empty stencils.
    void grow(std::size_t count) { stencils_.resize(stencils_.size() + count); }

    /// Sets an empty stencil.
    void set(std::size_t stencil, const StencilSum<double>& sum) {
        stencils_[stencil] = {entries_.size(), static_cast<std::uint32_t>(sum.indices().size())};
        for (std::size_t i = 0; i < sum.indices().size(); ++i) {
            entries_.push_back({sum.indices()[i], sum.values()[i]});
        }
    }

  private:
    struct Range {
        std::size_t first = 0;
        std::uint32_t count = 0;
    };

    std::vector<Range> stencils_;
    std::vector<Entry> entries_;
};

}  // namespace candela_plugins::opensubdiv
