#include "render/subdivision/gpu_stencil_table.h"

#include "render/subdivision/level_of_detail.h"

#include <candela/error.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace candela {

namespace {

/// What shaders/cage_limit.comp reads of an entry.
struct StoredEntry {
    std::uint32_t controlIndex;
    float weight, duWeight, dvWeight;
};
static_assert(sizeof(StoredEntry) == GpuStencilTable::Storage::entryBytes);

template <typename T>
std::uint64_t bytesOf(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

std::uint64_t bytesOf(const StencilTable& table) {
    return bytesOf(table.offsets) + bytesOf(table.controlIndices) + bytesOf(table.weights) +
           bytesOf(table.duWeights) + bytesOf(table.dvWeights);
}

std::vector<StoredEntry> entriesOf(const StencilTable& table) {
    std::vector<StoredEntry> entries(table.controlIndices.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
        entries[i] = {table.controlIndices[i], table.weights[i], table.duWeights[i], table.dvWeights[i]};
    return entries;
}

}  // namespace

CageMaterials materialsOf(const Cage& cage, std::uint32_t none) {
    CageMaterials result;
    const std::size_t faces = cage.faceSizes.size();
    const auto materialOf = [&](std::size_t face) {
        return cage.faceMaterials.empty() ? none : cage.faceMaterials[face].value_or(none);
    };
    for (std::size_t face = 0; face < faces; ++face) result.materials.push_back(materialOf(face));
    std::ranges::sort(result.materials);
    const auto repeated = std::ranges::unique(result.materials);
    result.materials.erase(repeated.begin(), repeated.end());
    for (std::size_t face = 0; face < faces; ++face) {
        const auto found = std::ranges::lower_bound(result.materials, materialOf(face));
        result.slotOfFace.push_back(static_cast<std::uint32_t>(found - result.materials.begin()));
    }
    return result;
}

GpuStencilTable::GpuStencilTable(const Cage& cage, const CageMaterials& materials, RefinedCage refined)
    : refined_(std::move(refined)) {
    createTriangles(materials);
    const std::vector<std::uint32_t>& offsets = refined_.positions.offsets;
    for (std::size_t i = 1; i < offsets.size(); ++i)
        maxStencilSize_ = std::max(maxStencilSize_, offsets[i] - offsets[i - 1]);
    if (refined_.uvs.stencilCount() == 0) return;
    const LimitUvs limit = evaluateLimitUvs(refined_, cage.uvs);
    uvs_ = gl::Buffer::immutable("cage texture coordinates", std::span<const glm::vec2>(limit.uvs));
}

std::uint64_t GpuStencilTable::bytes() const {
    return bytesOf(refined_.positions) + bytesOf(refined_.uvs) + bytesOf(refined_.seamPoints);
}

void GpuStencilTable::createTriangles(const CageMaterials& materials) {
    const std::uint32_t corners = refined_.faceSize;
    const std::size_t faces = refined_.faceVertices.size() / corners;
    triangles_ = std::uint64_t{faces} * (corners - 2);
    if (3 * triangles_ > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(ErrorKind::limit, "",
                    "a cage refined to level " + std::to_string(refined_.level) + " has " +
                        std::to_string(triangles_) + " triangles; candela draws 1,431,655,765 at most");
    }
    std::vector<std::uint32_t> ends(materials.materials.size());
    for (const std::uint32_t cageFace : refined_.cageFaces)
        ends[materials.slotOfFace[cageFace]] += 3 * (corners - 2);
    std::uint32_t end = 0;
    for (std::uint32_t& count : ends) {
        ranges_.push_back({end, count});
        end += std::exchange(count, end);
    }
    std::vector<std::uint32_t> indices(end);
    for (std::size_t face = 0; face < faces; ++face) {
        const std::uint32_t* vertices = refined_.faceVertices.data() + face * corners;
        std::uint32_t& at = ends[materials.slotOfFace[refined_.cageFaces[face]]];
        for (std::uint32_t i = 2; i < corners; ++i) {
            indices[at++] = vertices[0];
            indices[at++] = vertices[i - 1];
            indices[at++] = vertices[i];
        }
    }
    indices_ = gl::Buffer::immutable("cage indices", std::span<const std::uint32_t>(indices));
}

std::span<const glm::vec4> GpuStencilTable::uvDerivatives(const Cage& cage) {
    if (uvDerivatives_.empty() && uvs_) {
        const LimitUvs limit = evaluateLimitUvs(refined_, cage.uvs);
        for (std::size_t i = 0; i < limit.du.size(); ++i)
            uvDerivatives_.emplace_back(limit.du[i].x, limit.du[i].y, limit.dv[i].x, limit.dv[i].y);
    }
    return uvDerivatives_;
}

const EdgeIndices& GpuStencilTable::faceEdges() {
    if (!faceEdges_) faceEdges_.emplace(edgesOf(refined_));
    return *faceEdges_;
}

const GpuStencilTable::Storage& GpuStencilTable::storage() {
    if (!storage_) {
        std::vector<std::uint32_t> offsets(refined_.positions.offsets);
        offsets.insert(offsets.end(), refined_.seamPoints.begin(), refined_.seamPoints.end());
        const std::vector<StoredEntry> entries = entriesOf(refined_.positions);
        storage_.emplace(
            Storage{gl::Buffer::immutable("cage stencil offsets", std::span<const std::uint32_t>(offsets)),
                    gl::Buffer::immutable("cage stencil entries", std::span<const StoredEntry>(entries))});
    }
    return *storage_;
}

const gl::Buffer& GpuStencilTable::uvDerivativeBuffer() {
    if (!uvDerivativeBuffer_) {
        uvDerivativeBuffer_ =
            gl::Buffer::immutable("cage uv derivatives", std::span<const glm::vec4>(uvDerivatives_));
    }
    return *uvDerivativeBuffer_;
}

CageTables::CageTables(const Cage& cage, const std::optional<Subdivider>& subdivider,
                       std::uint32_t noMaterial)
    : cage_(cage),
      subdivider_(subdivider),
      materials_(materialsOf(cage, noMaterial)),
      edges_(edgesOf(cage)) {}

std::optional<std::uint32_t> CageTables::fixedLevel(const SubdivisionSettings& settings) const {
    if (!subdivider_) return 0;
    return settings.level ? settings.level : cage_.level;
}

std::uint32_t CageTables::maxLevel(const SubdivisionSettings& settings) const {
    const CageSize size{cage_.positions.size(), edges_.size(), cage_.faceSizes.size(),
                        cage_.faceVertices.size()};
    return candela::maxLevel(cage_.scheme, size, settings);
}

GpuStencilTable& CageTables::table(std::uint32_t level) {
    const auto known = tables_.find(level);
    if (known != tables_.end()) return known->second;
    RefinedCage refined = subdivider_ ? subdivider_->refine(cage_, level) : cagePolygons(cage_);
    return tables_.try_emplace(level, cage_, materials_, std::move(refined)).first->second;
}

std::uint64_t CageTables::tableBytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [level, table] : tables_) bytes += table.bytes();
    return bytes;
}

const EdgeIndices& CageTables::cageEdges() {
    if (!cageEdges_) cageEdges_.emplace(edges_);
    return *cageEdges_;
}

}  // namespace candela
