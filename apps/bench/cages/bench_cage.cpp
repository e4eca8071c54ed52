#include "cages/bench_cage.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace {

using Lattice = std::array<int, 3>;

constexpr Lattice quadsAlong{50, 50, 25};

/// The vertices of the box's surface, each made once.
class LatticeVertices {
  public:
    explicit LatticeVertices(candela::Cage& cage) : cage_(cage) {}

    std::uint32_t at(const Lattice& place) {
        const auto [entry, isNew] =
            indices_.try_emplace(place, static_cast<std::uint32_t>(cage_.positions.size()));
        if (isNew) cage_.positions.push_back(onEllipsoid(place));
        return entry->second;
    }

  private:
    static glm::vec3 onEllipsoid(const Lattice& place) {
        glm::vec3 inBox;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            inBox[axis] = 2.0f * static_cast<float>(place[i]) / static_cast<float>(quadsAlong[i]) - 1.0f;
        }
        return glm::normalize(inBox) * glm::vec3(2.0f, 2.0f, 1.0f);
    }

    candela::Cage& cage_;
    std::map<Lattice, std::uint32_t> indices_;
};

enum class End { lower, upper };

/// The side of the box at one end of the axis `normal`; the other two axes follow it in turn.
void addSide(candela::Cage& cage, LatticeVertices& vertices, std::size_t normal, End end) {
    const std::size_t u = (normal + 1) % 3, v = (normal + 2) % 3;
    for (int i = 0; i < quadsAlong[u]; ++i) {
        for (int j = 0; j < quadsAlong[v]; ++j) {
            std::array<std::pair<int, int>, 4> ring{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
            if (end == End::lower) std::swap(ring[1], ring[3]);
            for (const auto& [a, b] : ring) {
                Lattice place{};
                place[normal] = end == End::upper ? quadsAlong[normal] : 0;
                place[u] = a;
                place[v] = b;
                cage.faceVertices.push_back(vertices.at(place));
            }
            cage.faceSizes.push_back(4);
        }
    }
}

}  // namespace

candela::Cage makeBenchCage() {
    candela::Cage cage;
    cage.name = "ellipsoid";
    LatticeVertices vertices(cage);
    for (std::size_t normal = 0; normal < 3; ++normal) {
        addSide(cage, vertices, normal, End::upper);
        addSide(cage, vertices, normal, End::lower);
    }
    return cage;
}

std::vector<glm::vec3> waved(const candela::Cage& cage, double seconds) {
    std::vector<glm::vec3> points;
    points.reserve(cage.positions.size());
    for (const glm::vec3& p : cage.positions) {
        const auto wave = static_cast<float>(0.1 * std::sin(4.0 * p.x + 6.0 * seconds));
        points.push_back(p * (1.0f + wave));
    }
    return points;
}

candela::Scene makeCageScene() {
    candela::Scene scene;
    scene.cages.push_back(makeBenchCage());
    candela::Node node;
    node.name = "ellipsoid";
    node.cage = candela::CageInstance{};
    scene.nodes.push_back(node);
    return scene;
}
