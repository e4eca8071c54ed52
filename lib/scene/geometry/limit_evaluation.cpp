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

Sums sumRow(const StencilTable& rows, std::size_t row, const Float4* points) {
    const std::uint32_t* columns = rows.columns.data();
    const float *weights = rows.weights.data(), *du = rows.duWeights.data(), *dv = rows.dvWeights.data();
    Sums sums;
    const std::size_t end = rows.rowStarts[row + 1];
    for (std::size_t entry = rows.rowStarts[row]; entry < end; ++entry) {
        const Float4 point = points[columns[entry]];
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

/// Calls `body(first, end)` for blocks of rows that cost about the same, in parallel.
template <typename Body>
void forRowBlocks(const StencilTable& rows, const Body& body) {
    constexpr std::size_t rowCost = 8, blockCost = 1 << 15;  // In entries.
    const std::size_t rowCount = rows.rowCount();
    const auto costBefore = [&](std::size_t row) { return rows.rowStarts[row] + row * rowCost; };
    const auto firstRow = [&](std::size_t block) {
        std::size_t low = 0, high = rowCount;
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
    const std::size_t blockCount = costBefore(rowCount) / blockCost + 1;
    const auto run = [&](std::size_t block, unsigned) { body(firstRow(block), firstRow(block + 1)); };
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

void requireTable(const char* name, const StencilTable& table, std::size_t vertices, std::size_t sources) {
    const ErrorContext context(name);
    context.requireCount("rows", table.rowCount(), "vertices", vertices);
    context.require(table.rowStarts.empty() || table.rowStarts.front() == 0, "its first row must start at 0");
    context.require(std::is_sorted(table.rowStarts.begin(), table.rowStarts.end()),
                    "its row starts must not descend");
    const std::size_t entries = table.rowStarts.empty() ? 0 : table.rowStarts.back();
    context.requireCount("columns", table.columns.size(), "entries", entries);
    context.requireCount("weights", table.weights.size(), "entries", entries);
    context.requireCount("weights of du", table.duWeights.size(), "entries", entries);
    context.requireCount("weights of dv", table.dvWeights.size(), "entries", entries);
    context.requireEach("column", table.columns, "names a point that the cage does not have",
                        [sources](std::uint32_t column) { return column < sources; });
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
    if (refined.uvs.rowCount() != 0) requireTable(uvTable, refined.uvs, refined.vertexCount(), cageUvs);
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
    forRowBlocks(refined.positions, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row) {
            const Sums sums = sumRow(refined.positions, row, points.data());
            if (row < refined.pointCount) store(out.positions[row], sums.value);
            store(out.normals[row], padded(normalOf(vec3(sums.du), vec3(sums.dv))));
            if (!out.du.empty()) store(out.du[row], sums.du);
            if (!out.dv.empty()) store(out.dv[row], sums.dv);
        }
    });
    positionSeamVertices(refined, out.positions);
}

LimitUvs evaluateLimitUvs(const RefinedCage& refined, std::span<const glm::vec2> cageUvs) {
    LimitUvs result;
    const std::size_t rowCount = refined.uvs.rowCount();
    if (rowCount == 0) return result;
    requireTable(uvTable, refined.uvs, refined.vertexCount(), cageUvs.size());
    result.uvs.resize(rowCount);
    result.du.resize(rowCount);
    result.dv.resize(rowCount);
    const std::vector<Float4> points = paddedPoints(cageUvs);
    forRowBlocks(refined.uvs, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row) {
            const Sums sums = sumRow(refined.uvs, row, points.data());
            store(result.uvs[row], sums.value);
            store(result.du[row], sums.du);
            store(result.dv[row], sums.dv);
        }
    });
    return result;
}

}  // namespace candela
