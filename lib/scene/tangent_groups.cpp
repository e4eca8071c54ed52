#include "scene/tangent_groups.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

std::uint32_t nextCorner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

struct VertexKey {
    std::array<std::uint32_t, 8> bits;
    std::uint32_t vertex;
};

// Bits compare in a strict order whatever the numbers are, NaN included. Adding 0 turns -0 into 0.
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
    std::sort(keys.begin(), keys.end(), [](const VertexKey& a, const VertexKey& b) {
        return a.bits != b.bits ? a.bits < b.bits : a.vertex < b.vertex;
    });
    std::vector<std::uint32_t> first(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const bool same = i > 0 && keys[i].bits == keys[i - 1].bits;
        first[keys[i].vertex] = same ? first[keys[i - 1].vertex] : keys[i].vertex;
    }
    return first;
}

// Twice the area of the triangle's texture coordinates; positive when they turn as the front face does.
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
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.corner < b.corner;
    });
    return edges;
}

// For each corner the corner whose edge runs back along its own, or noCorner. Where more than two triangles
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

// Triangles without uv area take the orientation of the first neighbour that has one, breadth first.
void spreadOrientation(const std::vector<std::uint32_t>& opposite, TangentGroups& groups) {
    std::vector<bool> known(groups.kinds.size());
    std::vector<std::uint32_t> queue;
    for (std::uint32_t i = 0; i < groups.kinds.size(); ++i) {
        known[i] = groups.kinds[i] != TriangleKind::withoutUvArea;
        if (groups.kinds[i] == TriangleKind::whole) queue.push_back(i);
    }
    for (std::size_t at = 0; at < queue.size(); ++at) {
        for (std::uint32_t corner = queue[at] * 3; corner < queue[at] * 3 + 3; ++corner) {
            if (opposite[corner] == noCorner) continue;
            const std::uint32_t neighbour = opposite[corner] / 3;
            if (known[neighbour]) continue;
            known[neighbour] = true;
            groups.mirrored[neighbour] = groups.mirrored[queue[at]];
            queue.push_back(neighbour);
        }
    }
}

// A forest over corners: each points towards the one that stands for its group.
class Forest {
  public:
    explicit Forest(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0u); }

    std::uint32_t root(std::uint32_t corner) {
        while (parents_[corner] != corner) {
            parents_[corner] = parents_[parents_[corner]];
            corner = parents_[corner];
        }
        return corner;
    }

    // The lower corner stands for both.
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

}  // namespace

TangentGroups tangentGroups(const Mesh& mesh, const std::vector<glm::vec2>& uv) {
    TangentGroups groups;
    const std::vector<std::uint32_t> first = weldVertices(mesh, uv);
    groups.vertexOfCorner.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) groups.vertexOfCorner.push_back(first[index]);
    classify(mesh, uv, groups);
    const std::vector<std::uint32_t> opposite = pairEdges(groups);
    spreadOrientation(opposite, groups);

    const auto corners = static_cast<std::uint32_t>(mesh.indices.size());
    Forest forest(corners);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        const std::uint32_t other = opposite[corner];
        if (other == noCorner || other < corner) continue;
        if (groups.mirrored[corner / 3] != groups.mirrored[other / 3]) continue;
        forest.join(corner, nextCorner(other));
        forest.join(nextCorner(corner), other);
    }
    groups.groupOfCorner.resize(corners);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        groups.groupOfCorner[corner] = forest.root(corner);
    }
    return groups;
}

}  // namespace candela
