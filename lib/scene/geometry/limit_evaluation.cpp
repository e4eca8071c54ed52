#include "scene/geometry/limit_evaluation.h"

#include "base/error_context.h"
#include "base/thread_pool.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace candela {

namespace {

/// A point in one vector register; missing components are 0.
typedef float Float4 __attribute__((vector_size(16)));

Float4 padded(const glm::vec3& v) {
    return Float4{v.x, v.y, v.z, 0.0f};
}
Float4 padded(const glm::vec2& v) {
    return Float4{v.x, v.y, 0.0f, 0.0f};
}

template <typename Vector>
std::vector<Float4> paddedPoints(std::span<const Vector> points) {
    std::vector<Float4> result(points.size());
    std::transform(points.begin(), points.end(), result.begin(),
                   [](const Vector& point) { return padded(point); });
    return result;
}

template <typename Vector>
void store(Vector& to, Float4 from) {
    std::memcpy(&to, &from, sizeof to);
}

glm::vec3 vec3(Float4 v) {
    return {v[0], v[1], v[2]};
}

struct Sums {
    Float4 value{}, du{}, dv{};
};

Sums sumStencil(const StencilTable& table, std::size_t stencil, const Float4* points) {
    const std::uint32_t* controls = table.controlIndices.data();
    const float *weights = table.weights.data(), *du = table.duWeights.data(), *dv = table.dvWeights.data();
    Sums sums;
    const std::size_t end = table.offsets[stencil + 1];
    for (std::size_t entry = table.offsets[stencil]; entry < end; ++entry) {
        const Float4 point = points[controls[entry]];
        sums.value += point * weights[entry];
        sums.du += point * du[entry];
        sums.dv += point * dv[entry];
    }
    return sums;
}

float maxComponent(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// `v` with a largest component of 1; (0, 0, 0) where there is nothing to scale.
glm::vec3 scaledToOne(const glm::vec3& v) {
    const float largest = maxComponent(v);
    return largest > 0.0f && std::isfinite(largest) ? v / largest : glm::vec3(0.0f);
}

/// For tangents of any length; slower.
glm::vec3 robustNormal(const glm::vec3& du, const glm::vec3& dv) {
    const glm::vec3 normal = scaledToOne(glm::cross(scaledToOne(du), scaledToOne(dv)));
    return normal == glm::vec3(0.0f) ? normal : glm::normalize(normal);
}

glm::vec3 normalOf(const glm::vec3& du, const glm::vec3& dv) {
    const glm::vec3 normal = glm::cross(du, dv);
    const float square = glm::dot(normal, normal);
    // Within these limits no intermediate product overflows or loses relevant digits.
    if (!(square > 1e-20f && square < 1e30f)) return robustNormal(du, dv);
    return normal * (1.0f / std::sqrt(square));
}

/// Calls `body(first, end)` for blocks of stencils that cost about the same, in parallel.
template <typename Body>
void forStencilBlocks(const StencilTable& table, const Body& body) {
    constexpr std::size_t stencilCost = 8, blockCost = 1 << 15;  // In entries.
    const std::size_t stencilCount = table.stencilCount();
    const auto costBefore = [&](std::size_t stencil) {
        return table.offsets[stencil] + stencil * stencilCost;
    };
    const auto firstStencil = [&](std::size_t block) {
        std::size_t low = 0, high = stencilCount;
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (costBefore(middle) < block * blockCost) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    };
    const std::size_t blockCount = costBefore(stencilCount) / blockCost + 1;
    const auto run = [&](std::size_t block, unsigned) { body(firstStencil(block), firstStencil(block + 1)); };
    // Too little work to distribute.
    if (blockCount == 1) return run(0, 0);
    ThreadPool::shared()->run(blockCount, run);
}

/// Gives seam vertices the positions of their points.
void positionSeamVertices(const RefinedCage& refined, std::span<glm::vec3> positions) {
    constexpr std::size_t blockSize = 1 << 14;
    const std::span<glm::vec3> vertices = positions.subspan(refined.pointCount);
    const auto run = [&](std::size_t block, unsigned) {
        const std::size_t end = std::min(vertices.size(), (block + 1) * blockSize);
        for (std::size_t i = block * blockSize; i < end; ++i) vertices[i] = positions[refined.seamPoints[i]];
    };
    if (vertices.size() <= blockSize) return run(0, 0);
    ThreadPool::shared()->run((vertices.size() + blockSize - 1) / blockSize, run);
}

void requireTable(const char* name, const StencilTable& table, std::size_t vertices, std::size_t controls) {
    const ErrorContext context(name);
    context.requireCount("stencils", table.stencilCount(), "vertices", vertices);
    context.require(table.offsets.empty() || table.offsets.front() == 0,
                    "its first stencil must start at entry 0");
    context.require(std::is_sorted(table.offsets.begin(), table.offsets.end()),
                    "its stencil offsets must not decrease");
    const std::size_t entries = table.offsets.empty() ? 0 : table.offsets.back();
    context.requireCount("control indices", table.controlIndices.size(), "entries", entries);
    context.requireCount("weights", table.weights.size(), "entries", entries);
    context.requireCount("weights of du", table.duWeights.size(), "entries", entries);
    context.requireCount("weights of dv", table.dvWeights.size(), "entries", entries);
    context.requireEach("control index", table.controlIndices, "is out of range",
                        [controls](std::uint32_t index) { return index < controls; });
}

constexpr const char* positionTable = "stencil table of positions";
constexpr const char* uvTable = "stencil table of texture coordinates";

/// All but the tables.
void requireTopology(const RefinedCage& refined) {
    const ErrorContext context("refined cage");
    context.require(refined.faceSize == 3 || refined.faceSize == 4, "its faces must have 3 or 4 vertices");
    context.require(refined.vertexCount() <= 0xffffffffu, "has more vertices than 32 bits can count");
    context.requireCount("vertices of faces", refined.faceVertices.size(), "corners",
                         std::uint64_t{refined.cageFaces.size()} * refined.faceSize);
    context.requireEach("seam vertex", refined.seamPoints, "names a point that does not exist",
                        [&](std::uint32_t point) { return point < refined.pointCount; });
    context.requireEach("face vertex", refined.faceVertices, "names a vertex that does not exist",
                        [&](std::uint32_t vertex) { return vertex < refined.vertexCount(); });
}

void requireOutput(const RefinedCage& refined, const LimitVertices& out) {
    const ErrorContext context("limit vertices");
    const std::size_t vertices = refined.vertexCount();
    context.requireCount("positions", out.positions.size(), "vertices", vertices);
    context.requireCount("normals", out.normals.size(), "vertices", vertices);
    if (!out.du.empty()) context.requireCount("du", out.du.size(), "vertices", vertices);
    if (!out.dv.empty()) context.requireCount("dv", out.dv.size(), "vertices", vertices);
}

}  // namespace

void validateRefinedCage(const RefinedCage& refined, std::size_t cagePoints, std::size_t cageUvs) {
    requireTopology(refined);
    requireTable(positionTable, refined.positions, refined.vertexCount(), cagePoints);
    if (refined.uvs.stencilCount() != 0) requireTable(uvTable, refined.uvs, refined.vertexCount(), cageUvs);
}

std::uint32_t RefinedCage::pointOf(std::uint32_t vertex) const {
    if (vertex < pointCount) return vertex;
    ErrorContext("refined cage").require(vertex < vertexCount(), "it has no such vertex");
    return seamPoints[vertex - pointCount];
}

void evaluateLimit(const RefinedCage& refined, std::span<const glm::vec3> cagePoints,
                   const LimitVertices& out) {
    requireTopology(refined);
    requireTable(positionTable, refined.positions, refined.vertexCount(), cagePoints.size());
    evaluateValidatedLimit(refined, cagePoints, out);
}

void evaluateValidatedLimit(const RefinedCage& refined, std::span<const glm::vec3> cagePoints,
                            const LimitVertices& out) {
    requireOutput(refined, out);
    if (refined.vertexCount() == 0) return;
    const std::vector<Float4> points = paddedPoints(cagePoints);
    forStencilBlocks(refined.positions, [&](std::size_t first, std::size_t end) {
        for (std::size_t stencil = first; stencil < end; ++stencil) {
            const Sums sums = sumStencil(refined.positions, stencil, points.data());
            if (stencil < refined.pointCount) store(out.positions[stencil], sums.value);
            store(out.normals[stencil], padded(normalOf(vec3(sums.du), vec3(sums.dv))));
            if (!out.du.empty()) store(out.du[stencil], sums.du);
            if (!out.dv.empty()) store(out.dv[stencil], sums.dv);
        }
    });
    positionSeamVertices(refined, out.positions);
}

LimitUvs evaluateLimitUvs(const RefinedCage& refined, std::span<const glm::vec2> cageUvs) {
    LimitUvs result;
    const std::size_t stencilCount = refined.uvs.stencilCount();
    if (stencilCount == 0) return result;
    requireTable(uvTable, refined.uvs, refined.vertexCount(), cageUvs.size());
    result.uvs.resize(stencilCount);
    result.du.resize(stencilCount);
    result.dv.resize(stencilCount);
    const std::vector<Float4> points = paddedPoints(cageUvs);
    forStencilBlocks(refined.uvs, [&](std::size_t first, std::size_t end) {
        for (std::size_t stencil = first; stencil < end; ++stencil) {
            const Sums sums = sumStencil(refined.uvs, stencil, points.data());
            store(result.uvs[stencil], sums.value);
            store(result.du[stencil], sums.du);
            store(result.dv[stencil], sums.dv);
        }
    });
    return result;
}

}  // namespace candela
