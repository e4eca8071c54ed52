#include "scene/geometry/tangent_groups.h"

#include "base/thread_pool.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <utility>

namespace candela {

namespace {

std::uint32_t nextCorner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::uint32_t previousCorner(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

// Sorts by a strict total order, so that the result does not depend on the number of threads.
template <typename Value, typename Less>
void sortInParallel(std::vector<Value>& values, const Less& less) {
    constexpr std::size_t minRun = 1 << 14;
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    const std::size_t wanted = std::min<std::size_t>(pool->size(), values.size() / minRun);
    const std::size_t runs = std::bit_ceil(std::max<std::size_t>(wanted, 1));
    const auto at = [&](std::size_t run) {
        return values.begin() + static_cast<std::ptrdiff_t>(values.size() * run / runs);
    };
    pool->run(runs, [&](std::size_t run, unsigned) { std::sort(at(run), at(run + 1), less); });
    for (std::size_t width = 1; width < runs; width *= 2) {
        pool->run(runs / (2 * width), [&](std::size_t pair, unsigned) {
            const std::size_t first = pair * 2 * width;
            std::inplace_merge(at(first), at(first + width), at(first + 2 * width), less);
        });
    }
}

struct VertexKey {
    std::array<std::uint32_t, 8> bits;
    std::uint32_t vertex;
};

// Comparing bits is a strict order for all numbers, including NaN. Adding 0 maps -0 to 0.
std::uint32_t bitsOf(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0f);
}

// For each vertex the first one that equals it.
std::vector<std::uint32_t> weldVertices(const Mesh& mesh, const std::vector<glm::vec2>& uv) {
    std::vector<VertexKey> keys(mesh.positions.size());
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
        keys[i] = {{bitsOf(p.x), bitsOf(p.y), bitsOf(p.z), bitsOf(n.x), bitsOf(n.y), bitsOf(n.z),
                    bitsOf(uv[i].x), bitsOf(uv[i].y)},
                   i};
    }
    sortInParallel(keys, [](const VertexKey& a, const VertexKey& b) {
        return a.bits != b.bits ? a.bits < b.bits : a.vertex < b.vertex;
    });
    std::vector<std::uint32_t> first(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const bool same = i > 0 && keys[i].bits == keys[i - 1].bits;
        first[keys[i].vertex] = same ? first[keys[i - 1].vertex] : keys[i].vertex;
    }
    return first;
}

// Twice the area of the triangle's texture coordinates; positive when their winding is that of the front
// face.
double uvArea(const Mesh& mesh, const std::vector<glm::vec2>& uv, std::size_t triangle) {
    const std::uint32_t* corner = mesh.indices.data() + triangle * 3;
    const glm::dvec2 a(uv[corner[0]]), b(uv[corner[1]]), c(uv[corner[2]]);
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void classify(const Mesh& mesh, const std::vector<glm::vec2>& uv, TangentGroups& groups) {
    const std::size_t triangles = mesh.indices.size() / 3;
    groups.kinds.resize(triangles);
    groups.mirrored.resize(triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
        const glm::vec3& a = mesh.positions[mesh.indices[i * 3]];
        const glm::vec3& b = mesh.positions[mesh.indices[i * 3 + 1]];
        const glm::vec3& c = mesh.positions[mesh.indices[i * 3 + 2]];
        const double area = uvArea(mesh, uv, i);
        groups.mirrored[i] = area < 0.0;
        if (a == b || b == c || c == a) {
            groups.kinds[i] = TriangleKind::degenerate;
        } else if (!(std::abs(area) > static_cast<double>(FLT_MIN))) {
            groups.kinds[i] = TriangleKind::withoutUvArea;
        }
    }
}

// The edge from a corner to the next of its triangle.
struct Edge {
    std::uint64_t ends;  // The lower vertex in the high half.
    std::uint32_t corner;
    bool rising;  // From the lower vertex to the higher.
};

std::vector<Edge> sortedEdges(const TangentGroups& groups) {
    std::vector<Edge> edges;
    edges.reserve(groups.vertexOfCorner.size());
    for (std::uint32_t corner = 0; corner < groups.vertexOfCorner.size(); ++corner) {
        if (groups.kinds[corner / 3] == TriangleKind::degenerate) continue;
        const std::uint64_t from = groups.vertexOfCorner[corner];
        const std::uint64_t to = groups.vertexOfCorner[nextCorner(corner)];
        edges.push_back({std::min(from, to) << 32 | std::max(from, to), corner, from < to});
    }
    sortInParallel(edges, [](const Edge& a, const Edge& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.corner < b.corner;
    });
    return edges;
}

// For each corner the corner whose edge is its own in reverse, or noCorner. Where more than two triangles
// meet at an edge, the first of each direction are paired, then the second ones, and so on.
std::vector<std::uint32_t> pairEdges(const TangentGroups& groups) {
    const std::vector<Edge> edges = sortedEdges(groups);
    std::vector<std::uint32_t> opposite(groups.vertexOfCorner.size(), noCorner);
    std::size_t begin = 0;
    while (begin < edges.size()) {
        std::size_t end = begin;
        while (end < edges.size() && edges[end].ends == edges[begin].ends) ++end;
        std::size_t up = begin, down = begin;
        while (true) {
            while (up < end && !edges[up].rising) ++up;
            while (down < end && edges[down].rising) ++down;
            if (up == end || down == end) break;
            opposite[edges[up].corner] = edges[down].corner;
            opposite[edges[down].corner] = edges[up].corner;
            ++up;
            ++down;
        }
        begin = end;
    }
    return opposite;
}

// Grows groups over the corners at one vertex, from triangle to triangle across their edges.
class GroupGrowth {
  public:
    GroupGrowth(TangentGroups& groups, std::vector<std::uint32_t> opposite)
        : groups_(groups), opposite_(std::move(opposite)) {}

    void growFrom(std::uint32_t start) {
        mirrored_ = groups_.mirrored[start / 3];
        add(start, start);
        while (!open_.empty()) {
            const std::uint32_t corner = open_.back();
            open_.pop_back();
            const std::uint32_t across = opposite_[corner], back = opposite_[previousCorner(corner)];
            if (across != noCorner) tryToAdd(nextCorner(across), start);
            if (back != noCorner) tryToAdd(back, start);
        }
    }

  private:
    void add(std::uint32_t corner, std::uint32_t group) {
        groups_.groupOfCorner[corner] = group;
        open_.push_back(corner);
    }

    void tryToAdd(std::uint32_t corner, std::uint32_t group) {
        if (groups_.groupOfCorner[corner] != noCorner) return;
        const std::uint32_t triangle = corner / 3;
        if (groups_.kinds[triangle] == TriangleKind::withoutUvArea && isUngrouped(triangle)) {
            groups_.mirrored[triangle] = mirrored_;
        }
        if (groups_.mirrored[triangle] == mirrored_) add(corner, group);
    }

    bool isUngrouped(std::uint32_t triangle) const {
        const std::uint32_t* group = groups_.groupOfCorner.data() + std::size_t{triangle} * 3;
        return group[0] == noCorner && group[1] == noCorner && group[2] == noCorner;
    }

    TangentGroups& groups_;
    std::vector<std::uint32_t> opposite_;
    std::vector<std::uint32_t> open_;
    bool mirrored_ = false;
};

}  // namespace

TangentGroups tangentGroups(const Mesh& mesh, const std::vector<glm::vec2>& uv) {
    TangentGroups groups;
    const std::vector<std::uint32_t> first = weldVertices(mesh, uv);
    groups.vertexOfCorner.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) groups.vertexOfCorner.push_back(first[index]);
    classify(mesh, uv, groups);

    const auto corners = static_cast<std::uint32_t>(mesh.indices.size());
    groups.groupOfCorner.assign(corners, noCorner);
    GroupGrowth growth(groups, pairEdges(groups));
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        const bool starts = groups.kinds[corner / 3] == TriangleKind::whole;
        if (starts && groups.groupOfCorner[corner] == noCorner) growth.growFrom(corner);
    }
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        if (groups.groupOfCorner[corner] == noCorner) groups.groupOfCorner[corner] = corner;
    }
    return groups;
}

}  // namespace candela
