#include "generated_cages.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

glm::vec3 onCircle(float revolutions, float radius, float height) {
    return {radius * std::cos(2.0f * pi * revolutions), height, -radius * std::sin(2.0f * pi * revolutions)};
}

float uniform(Random& random) {
    return std::uniform_real_distribution<float>(0.0f, 1.0f)(random);
}

/// Groups the corners of a cage into fans of faces around a vertex, connected across edges with equal texture
/// coordinates.
class UvFans {
  public:
    explicit UvFans(const Cage& cage) : cage_(cage), parents_(cage.faceVertices.size()) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
        // The corners at the lower and the higher vertex of each edge, in the first face that has it.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::size_t>> edgeCorners;
        std::size_t first = 0;
        for (const std::uint32_t size : cage.faceSizes) {
            for (std::uint32_t i = 0; i < size; ++i) {
                std::pair ends{first + i, first + (i + 1) % size};
                if (vertex(ends.first) > vertex(ends.second)) std::swap(ends.first, ends.second);
                const auto [known, isNew] =
                    edgeCorners.try_emplace({vertex(ends.first), vertex(ends.second)}, ends);
                if (!isNew) join(known->second, ends);
            }
            first += size;
        }
    }

    std::size_t of(std::size_t corner) const {
        while (parents_[corner] != corner) corner = parents_[corner];
        return corner;
    }

  private:
    std::uint32_t vertex(std::size_t corner) const { return cage_.faceVertices[corner]; }

    void join(std::pair<std::size_t, std::size_t> a, std::pair<std::size_t, std::size_t> b) {
        if (cage_.faceUvs[a.first] != cage_.faceUvs[b.first]) return;
        if (cage_.faceUvs[a.second] != cage_.faceUvs[b.second]) return;
        parents_[of(a.first)] = of(b.first);
        parents_[of(a.second)] = of(b.second);
    }

    const Cage& cage_;
    std::vector<std::size_t> parents_;
};

/// Gives each fan a separate texture coordinate. Far and Bfr differ for one that two fans of a vertex share:
/// Bfr does not move it, Far moves it with each of the fans.
void separateFans(Cage& cage) {
    const UvFans fans(cage);
    std::map<std::uint32_t, std::size_t> owner;
    std::map<std::size_t, std::uint32_t> added;
    for (std::size_t corner = 0; corner < cage.faceUvs.size(); ++corner) {
        const std::size_t fan = fans.of(corner);
        const std::uint32_t uv = cage.faceUvs[corner];
        if (owner.try_emplace(uv, fan).first->second == fan) continue;
        const auto [place, isNew] = added.try_emplace(fan, static_cast<std::uint32_t>(cage.uvs.size()));
        if (isNew) cage.uvs.push_back(cage.uvs[uv]);
        cage.faceUvs[corner] = place->second;
    }
}

}  // namespace

Cage makeCage(std::string name, std::vector<glm::vec3> points,
              const std::vector<std::vector<std::uint32_t>>& faces) {
    Cage cage;
    cage.name = std::move(name);
    cage.positions = std::move(points);
    for (const auto& face : faces) {
        cage.faceSizes.push_back(static_cast<std::uint32_t>(face.size()));
        cage.faceVertices.insert(cage.faceVertices.end(), face.begin(), face.end());
    }
    return cage;
}

Cage cube() {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 8; ++i) {
        points.emplace_back(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
    }
    return makeCage("cube", points,
                    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

Cage torus(std::uint32_t around, std::uint32_t along) {
    std::vector<glm::vec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t j = 0; j < along; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const float angle = 2.0f * pi * static_cast<float>(j) / static_cast<float>(along);
            points.push_back(onCircle(static_cast<float>(i) / static_cast<float>(around),
                                      3.0f + std::cos(angle), std::sin(angle)));
            const std::uint32_t nextI = (i + 1) % around, nextJ = (j + 1) % along;
            faces.push_back({j * around + i, j * around + nextI, nextJ * around + nextI, nextJ * around + i});
        }
    }
    return makeCage("torus", points, faces);
}

Cage pyramid(std::uint32_t sides) {
    std::vector<glm::vec3> points{{0.0f, 1.5f, 0.0f}};
    std::vector<std::vector<std::uint32_t>> faces(1);
    for (std::uint32_t i = 0; i < sides; ++i) {
        points.push_back(
            onCircle(static_cast<float>(i) / static_cast<float>(sides), 1.0f, i % 2 == 0 ? 0.0f : 0.2f));
        faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
        faces.front().push_back(sides - i);
    }
    return makeCage("pyramid of " + std::to_string(sides), points, faces);
}

Cage sheet(std::uint32_t columns, std::uint32_t rows) {
    std::vector<glm::vec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        for (std::uint32_t i = 0; i <= columns; ++i) {
            points.emplace_back(static_cast<float>(i), 0.0f, -static_cast<float>(j));
            if (i == columns || j == rows) continue;
            const std::uint32_t first = j * (columns + 1) + i;
            faces.push_back({first, first + 1, first + columns + 2, first + columns + 1});
        }
    }
    return makeCage("sheet", points, faces);
}

Cage star(std::uint32_t valence) {
    // Two rings of vertices around the center: the inner one at the ends of its edges and between them.
    std::vector<glm::vec3> points{{0.0f, 0.3f, 0.0f}};
    std::vector<std::vector<std::uint32_t>> faces;
    const std::uint32_t ring = 2 * valence;
    for (std::uint32_t circle = 1; circle <= 2; ++circle) {
        for (std::uint32_t i = 0; i < ring; ++i) {
            points.push_back(onCircle(static_cast<float>(i) / static_cast<float>(ring),
                                      static_cast<float>(circle), 0.1f * static_cast<float>(i % 3)));
        }
    }
    for (std::uint32_t i = 0; i < ring; ++i) {
        const std::uint32_t next = (i + 1) % ring;
        if (i % 2 == 0) faces.push_back({0, 1 + i, 1 + next, 1 + (i + 2) % ring});
        faces.push_back({1 + i, 1 + ring + i, 1 + ring + next, 1 + next});
    }
    return makeCage("star of " + std::to_string(valence), points, faces);
}

Cage mixedPolygons() {
    // A strip of polygons between two lines of vertices; 0 to 12 below, 13 to 25 above.
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 26; ++i) {
        points.emplace_back(static_cast<float>(i % 13), 0.3f * static_cast<float>(i * 7 % 5),
                            i < 13 ? 0.0f : -2.0f);
    }
    return makeCage("mixed polygons", points,
                    {{0, 1, 13},
                     {1, 2, 14, 13},
                     {2, 3, 4, 15, 14},
                     {4, 5, 6, 17, 16, 15},
                     {6, 7, 8, 9, 19, 18, 17},
                     {9, 10, 19},
                     {10, 11, 20, 19},
                     {11, 12, 22, 21, 20}});
}

Cage threeSheets() {
    std::vector<glm::vec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t j = 0; j < 4; ++j) {
        points.emplace_back(0.0f, 0.0f, -static_cast<float>(j));
        for (std::uint32_t side = 0; side < 3; ++side) {
            const float angle = static_cast<float>(side) / 3.0f + 0.1f;
            points.emplace_back(std::cos(2.0f * pi * angle), std::sin(2.0f * pi * angle),
                                -static_cast<float>(j));
            if (j == 3) continue;
            const std::uint32_t line = 4 * j, outer = line + 1 + side;
            faces.push_back({line, outer, outer + 4, line + 4});
        }
    }
    return makeCage("three sheets", points, faces);
}

Cage triangulated(const Cage& cage) {
    Cage result = cage;
    result.name += ", triangulated";
    result.faceSizes.clear();
    result.faceVertices.clear();
    result.faceUvs.clear();
    std::size_t first = 0;
    for (const std::uint32_t size : cage.faceSizes) {
        for (std::uint32_t i = 1; i + 1 < size; ++i) {
            result.faceSizes.push_back(3);
            for (const std::size_t corner : {first, first + i, first + i + 1}) {
                result.faceVertices.push_back(cage.faceVertices[corner]);
                if (!cage.faceUvs.empty()) result.faceUvs.push_back(cage.faceUvs[corner]);
            }
        }
        first += size;
    }
    result.scheme = SubdivisionScheme::loop;
    return result;
}

void jitter(Cage& cage, float amount, Random& random) {
    for (glm::vec3& point : cage.positions) {
        const float x = uniform(random), y = uniform(random), z = uniform(random);
        point += (glm::vec3(x, y, z) - 0.5f) * 2.0f * amount;
    }
}

void addSmoothUvs(Cage& cage) {
    cage.uvs.clear();
    for (const glm::vec3& point : cage.positions) {
        cage.uvs.emplace_back(point.x + 0.3f * point.y, point.z - 0.2f * point.y);
    }
    cage.faceUvs = cage.faceVertices;
}

void addUvsWithSeams(Cage& cage, Random& random) {
    addSmoothUvs(cage);
    const auto vertexCount = static_cast<std::uint32_t>(cage.positions.size());
    for (std::uint32_t i = 0; i < vertexCount; ++i) cage.uvs.push_back(cage.uvs[i] * 0.7f + 5.0f);
    std::size_t corner = 0;
    for (const std::uint32_t size : cage.faceSizes) {
        const std::uint32_t chart = uniform(random) < 0.3f ? 1 : 0;
        for (std::uint32_t i = 0; i < size; ++i, ++corner) {
            cage.faceUvs[corner] += chart * vertexCount;
            if (uniform(random) > 0.05f) continue;
            cage.uvs.push_back(cage.uvs[cage.faceUvs[corner]] + 0.25f);
            cage.faceUvs[corner] = static_cast<std::uint32_t>(cage.uvs.size() - 1);
        }
    }
    separateFans(cage);
}

void addRandomSharpness(Cage& cage, Random& random) {
    constexpr float sharpnesses[] = {0.4f, 1.0f, 1.7f, 2.6f, infiniteSharpness, infiniteSharpness};
    const auto randomSharpness = [&] {
        return sharpnesses[std::uniform_int_distribution<std::size_t>(0, 5)(random)];
    };
    for (const auto& [vertex0, vertex1] : edgesOf(cage)) {
        if (uniform(random) < 0.25f) cage.creases.push_back({vertex0, vertex1, randomSharpness()});
    }
    // The sharpness of unused vertices has no effect.
    for (std::uint32_t vertex = 0; vertex < cage.positions.size(); ++vertex) {
        if (uniform(random) < 0.1f) cage.corners.push_back({vertex, randomSharpness()});
    }
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesOf(const Cage& cage) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    const std::uint32_t* face = cage.faceVertices.data();
    for (const std::uint32_t size : cage.faceSizes) {
        for (std::uint32_t i = 0; i < size; ++i) {
            edges.push_back(std::minmax(face[i], face[(i + 1) % size]));
        }
        face += size;
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace candela
