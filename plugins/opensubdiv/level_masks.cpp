#include "level_masks.h"

#include <opensubdiv/far/primvarRefiner.h>

namespace candela_opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;

std::size_t pointCount(const Far::TopologyLevel& level, Primvar primvar) {
    return static_cast<std::size_t>(primvar == Primvar::position ? level.GetNumVertices()
                                                                 : level.GetNumFVarValues());
}

}  // namespace

/// Takes what Far's refiner does to the points of one level, point after point.
class LevelMasks::Builder {
  public:
    /// A point, as Far's refiner sees what it interpolates.
    struct Point {
        Builder& builder;
        std::size_t index;

        void Clear() {
            builder.select(index);
            builder.sum_.clear();
        }
        void AddWithWeight(const Point& other, double weight) {
            builder.select(index);
            builder.sum_.add(static_cast<int>(other.index), weight);
        }
    };

    /// The points of a level.
    struct Points {
        Builder& builder;
        std::size_t first;

        Point operator[](int point) const { return {builder, first + static_cast<std::size_t>(point)}; }
    };

    Builder(SparseRows& masks, std::size_t allPoints) : masks_(masks), sum_(allPoints) {}

    /// Stores the point at hand.
    void store() {
        if (selected_ != none) masks_.set(selected_, sum_);
        sum_.clear();
        selected_ = none;
    }

  private:
    static constexpr std::size_t none = ~std::size_t{0};

    void select(std::size_t point) {
        if (point == selected_) return;
        store();
        for (const SparseRows::Entry& entry : masks_[point]) sum_.add(entry.column, entry.weight);
        selected_ = point;
    }

    SparseRows& masks_;
    SparseSum<double> sum_;
    std::size_t selected_ = none;
};

LevelMasks::LevelMasks(const Far::TopologyRefiner& refined, Primvar primvar) : firsts_{0} {
    for (int level = 0; level < refined.GetNumLevels(); ++level) {
        firsts_.push_back(firsts_.back() + pointCount(refined.GetLevel(level), primvar));
    }
    masks_.grow(firsts_.back());
    Builder builder(masks_, firsts_.back());
    const Far::PrimvarRefinerReal<double> refiner(refined);
    for (int level = 1; level < refined.GetNumLevels(); ++level) {
        const auto index = static_cast<std::size_t>(level);
        const Builder::Points from{builder, first(index - 1)};
        Builder::Points to{builder, first(index)};
        if (primvar == Primvar::position) {
            refiner.Interpolate(level, from, to);
        } else {
            refiner.InterpolateFaceVarying(level, from, to);
        }
        builder.store();
    }
}

}  // namespace candela_opensubdiv
