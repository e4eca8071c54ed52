#include "stencils.h"

#include <opensubdiv/far/stencilTable.h>

#include <algorithm>
#include <vector>

namespace candela_opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;

/// Traces sums of refined points back to the cage, one level after another. Each step is a sum of short
/// masks, however many points of the cage a point depends on in the end.
class Descent {
  public:
    explicit Descent(const LevelMasks& masks) : masks_(masks) {
        for (std::size_t level = 0; level < masks.levelCount(); ++level) {
            sums_.emplace_back(masks.first(level + 1) - masks.first(level));
        }
    }

    void clear() { sums_.front().clear(); }

    void add(std::size_t point, double weight) {
        std::size_t level = 0;
        while (point >= masks_.first(level + 1)) ++level;
        sums_[level].add(static_cast<int>(point - masks_.first(level)), weight);
    }

    /// What has been added since `clear`, as a sum of the cage's points.
    const SparseSum<double>& descend() {
        for (std::size_t level = sums_.size() - 1; level > 0; --level) {
            // First to points of the same level, whose own weight is complete then.
            for (const std::size_t to : {level, level - 1}) spread(level, to);
            sums_[level].clear();
        }
        return sums_.front();
    }

  private:
    /// Hands the weights of a level's points on to those points of level `to` that they are made of.
    void spread(std::size_t level, std::size_t to) {
        const auto first = static_cast<int>(masks_.first(to)), end = static_cast<int>(masks_.first(to + 1));
        const SparseSum<double>& from = sums_[level];
        for (std::size_t i = 0; i < from.columns().size(); ++i) {
            const double weight = from.values()[i];
            const std::size_t point = masks_.first(level) + static_cast<std::size_t>(from.columns()[i]);
            for (const SparseRows::Entry& entry : masks_.of(point)) {
                if (entry.column < first || entry.column >= end) continue;
                sums_[to].add(entry.column - first, entry.weight * weight);
            }
        }
    }

    const LevelMasks& masks_;
    std::vector<SparseSum<double>> sums_;  ///< Of the points of each level.
};

}  // namespace

Stencils::Stencils(const Far::TopologyRefiner& refined, const Far::PatchTable& patches, Primvar primvar) {
    const LevelMasks masks(refined, primvar);
    addRefinedPoints(masks);
    const auto* const points = primvar == Primvar::position
                                   ? patches.GetLocalPointStencilTable<double>()
                                   : patches.GetLocalPointFaceVaryingStencilTable<double>();
    if (points != nullptr) addPatchPoints(masks, *points);
}

void Stencils::addRefinedPoints(const LevelMasks& masks) {
    rows_.grow(masks.first(masks.levelCount()));
    SparseSum<double> sum(masks.first(1));
    for (std::size_t point = 0; point < masks.first(1); ++point) {
        sum.clear();
        sum.add(static_cast<int>(point), 1.0);
        rows_.set(point, sum);
    }
    for (std::size_t level = 1; level < masks.levelCount(); ++level) {
        const std::size_t first = masks.first(level), end = masks.first(level + 1);
        const auto usesItsLevel = [&](std::size_t point) {
            const auto mask = masks.of(point);
            return std::any_of(mask.begin(), mask.end(), [&](const SparseRows::Entry& entry) {
                return static_cast<std::size_t>(entry.column) >= first;
            });
        };
        // First those that others of their level are made of.
        for (const bool later : {false, true}) {
            for (std::size_t point = first; point < end; ++point) {
                if (usesItsLevel(point) == later) addRefinedPoint(masks, point, sum);
            }
        }
    }
}

void Stencils::addRefinedPoint(const LevelMasks& masks, std::size_t point, SparseSum<double>& sum) {
    sum.clear();
    for (const SparseRows::Entry& parent : masks.of(point)) {
        for (const SparseRows::Entry& entry : rows_[static_cast<std::size_t>(parent.column)]) {
            sum.add(entry.column, entry.weight * parent.weight);
        }
    }
    rows_.set(point, sum);
}

void Stencils::addPatchPoints(const LevelMasks& masks, const Far::StencilTableReal<double>& points) {
    Descent descent(masks);
    std::size_t entry = 0;
    for (const int size : points.GetSizes()) {
        descent.clear();
        for (int i = 0; i < size; ++i, ++entry) {
            descent.add(static_cast<std::size_t>(points.GetControlIndices()[entry]),
                        points.GetWeights()[entry]);
        }
        rows_.grow(1);
        rows_.set(rows_.size() - 1, descent.descend());
    }
}

}  // namespace candela_opensubdiv
