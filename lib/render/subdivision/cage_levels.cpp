#include "render/subdivision/cage_levels.h"

#include "render/subdivision/lod_request.h"

namespace candela {

CageLevels::CageLevels(const Cage& cage, const std::optional<Subdivider>& subdivider,
                       std::uint32_t noMaterial)
    : cage_(cage),
      subdivider_(subdivider),
      materials_(materialsOf(cage, noMaterial)),
      edges_(edgesOf(cage)) {}

std::optional<std::uint32_t> CageLevels::fixedLevel(const SubdivisionSettings& settings) const {
    if (!subdivider_) return 0;
    return settings.level ? settings.level : cage_.level;
}

std::uint32_t CageLevels::greatest(const SubdivisionSettings& settings) const {
    const CageSize size{cage_.positions.size(), edges_.size(), cage_.faceSizes.size(),
                        cage_.faceVertices.size()};
    return maxLevel(cage_.scheme, size, settings);
}

GpuStencilTable& CageLevels::table(std::uint32_t level) {
    const auto known = tables_.find(level);
    if (known != tables_.end()) return known->second;
    RefinedCage refined = subdivider_ ? subdivider_->refine(cage_, level) : cagePolygons(cage_);
    return tables_.try_emplace(level, cage_, materials_, std::move(refined)).first->second;
}

std::uint64_t CageLevels::tableBytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [level, table] : tables_) bytes += table.bytes();
    return bytes;
}

const LineIndices& CageLevels::edgeLines() {
    if (!edgeLines_) edgeLines_.emplace(edges_);
    return *edgeLines_;
}

}  // namespace candela
