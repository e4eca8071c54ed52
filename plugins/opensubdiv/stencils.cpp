#include "stencils.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTable.h>

#include <algorithm>
#include <vector>

namespace candela_plugins::opensubdiv {

namespace {

namespace Far = OpenSubdiv::Far;

std::size_t pointCount(const Far::TopologyLevel& level, Primvar primvar) {
    return static_cast<std::size_t>(primvar == Primvar::position ? level.GetNumVertices()
                                                                 : level.GetNumFVarValues());
}

}  // namespace

/// Records the weights with which Far's refiner interpolates the points of one level, point after point.
class LevelStencils::Builder {
  public:
    /// A point in the interface of Far's refiner.
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

    Builder(StencilList& stencils, std::size_t allPoints) : stencils_(stencils), sum_(allPoints) {}

    /// Stores the stencil of the selected point.
    void store() {
        if (selected_ != none) stencils_.set(selected_, sum_);
        sum_.clear();
        selected_ = none;
    }

  private:
    static constexpr std::size_t none = ~std::size_t{0};

    void select(std::size_t point) {
        if (point == selected_) return;
        store();
        for (const StencilList::Entry& entry : stencils_[point]) sum_.add(entry.index, entry.weight);
        selected_ = point;
    }

    StencilList& stencils_;
    StencilSum<double> sum_;
    std::size_t selected_ = none;
};

LevelStencils::LevelStencils(const Far::TopologyRefiner& refined, Primvar primvar) : firsts_{0} {
    for (int level = 0; level < refined.GetNumLevels(); ++level) {
        firsts_.push_back(firsts_.back() + pointCount(refined.GetLevel(level), primvar));
    }
    stencils_.grow(firsts_.back());
    Builder builder(stencils_, firsts_.back());
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

namespace {

/// Expands sums of refined points to sums of cage vertices, level by level. Each step uses the short stencils
/// of one level, however many vertices a point depends on in the end.
class StencilExpansion {
  public:
    explicit StencilExpansion(const LevelStencils& levels) : levels_(levels) {
        for (std::size_t level = 0; level < levels.levelCount(); ++level) {
            sums_.emplace_back(levels.first(level + 1) - levels.first(level));
        }
    }

    void clear() { sums_.front().clear(); }

    void add(std::size_t point, double weight) {
        std::size_t level = 0;
        while (point >= levels_.first(level + 1)) ++level;
        sums_[level].add(static_cast<int>(point - levels_.first(level)), weight);
    }

    /// The sum of what was added since `clear`, in vertices of the cage.
    const StencilSum<double>& expand() {
        for (std::size_t level = sums_.size() - 1; level > 0; --level) {
            // First to face points of the same level, so that their weights are complete when they are
            // expanded.
            for (const std::size_t to : {level, level - 1}) spread(level, to);
            sums_[level].clear();
        }
        return sums_.front();
    }

  private:
    /// Distributes the weights of a level's points to the points of level `to` in their stencils.
    void spread(std::size_t level, std::size_t to) {
        const auto first = static_cast<int>(levels_.first(to)), end = static_cast<int>(levels_.first(to + 1));
        const StencilSum<double>& from = sums_[level];
        for (std::size_t i = 0; i < from.indices().size(); ++i) {
            const double weight = from.values()[i];
            const std::size_t point = levels_.first(level) + static_cast<std::size_t>(from.indices()[i]);
            for (const StencilList::Entry& entry : levels_.of(point)) {
                if (entry.index < first || entry.index >= end) continue;
                sums_[to].add(entry.index - first, entry.weight * weight);
            }
        }
    }

    const LevelStencils& levels_;
    std::vector<StencilSum<double>> sums_;  ///< Of the points of each level.
};

}  // namespace

PointStencils::PointStencils(const Far::TopologyRefiner& refined, const Far::PatchTable& patches,
                             Primvar primvar) {
    const LevelStencils levels(refined, primvar);
    addRefinedPoints(levels);
    const auto* const points = primvar == Primvar::position
                                   ? patches.GetLocalPointStencilTable<double>()
                                   : patches.GetLocalPointFaceVaryingStencilTable<double>();
    if (points != nullptr) addPatchPoints(levels, *points);
}

void PointStencils::addRefinedPoints(const LevelStencils& levels) {
    stencils_.grow(levels.first(levels.levelCount()));
    StencilSum<double> sum(levels.first(1));
    for (std::size_t point = 0; point < levels.first(1); ++point) {
        sum.clear();
        sum.add(static_cast<int>(point), 1.0);
        stencils_.set(point, sum);
    }
    for (std::size_t level = 1; level < levels.levelCount(); ++level) {
        const std::size_t first = levels.first(level), end = levels.first(level + 1);
        const auto usesItsLevel = [&](std::size_t point) {
            const auto parents = levels.of(point);
            return std::any_of(parents.begin(), parents.end(), [&](const StencilList::Entry& entry) {
                return static_cast<std::size_t>(entry.index) >= first;
            });
        };
        // First the points that others of their level use.
        for (const bool later : {false, true}) {
            for (std::size_t point = first; point < end; ++point) {
                if (usesItsLevel(point) == later) addRefinedPoint(levels, point, sum);
            }
        }
    }
}

void PointStencils::addRefinedPoint(const LevelStencils& levels, std::size_t point, StencilSum<double>& sum) {
    sum.clear();
    for (const StencilList::Entry& parent : levels.of(point)) {
        for (const StencilList::Entry& entry : stencils_[static_cast<std::size_t>(parent.index)]) {
            sum.add(entry.index, entry.weight * parent.weight);
        }
    }
    stencils_.set(point, sum);
}

void PointStencils::addPatchPoints(const LevelStencils& levels, const Far::StencilTableReal<double>& points) {
    StencilExpansion expansion(levels);
    std::size_t entry = 0;
    for (const int size : points.GetSizes()) {
        expansion.clear();
        for (int i = 0; i < size; ++i, ++entry) {
            expansion.add(static_cast<std::size_t>(points.GetControlIndices()[entry]),
                          points.GetWeights()[entry]);
        }
        stencils_.grow(1);
        stencils_.set(stencils_.size() - 1, expansion.expand());
    }
}

}  // namespace candela_plugins::opensubdiv
