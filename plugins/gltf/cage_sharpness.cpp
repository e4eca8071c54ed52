#include "cage_sharpness.h"

#include <algorithm>
#include <map>

namespace candela_gltf {
namespace {

/// Both ends in one number, whichever way round the edge is given.
std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

std::vector<std::uint64_t> sortedEdges(const JoinedCage& cage) {
    std::vector<std::uint64_t> edges;
    edges.reserve(cage.faceVertices.size());
    std::size_t begin = 0;
    for (const std::uint32_t size : cage.faceSizes) {
        for (std::uint32_t i = 0; i < size; ++i) {
            edges.push_back(edgeKey(cage.faceVertices[begin + i], cage.faceVertices[begin + (i + 1) % size]));
        }
        begin += size;
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

class Resolver {
  public:
    Resolver(const CageSource& source, const JoinedCage& cage, std::string element)
        : source_(source), cage_(cage), element_(std::move(element)) {}

    void addCreases(const std::vector<SharpEdge>& creases) {
        if (creases.empty()) return;
        const std::vector<std::uint64_t> edges = sortedEdges(cage_);
        for (std::size_t i = 0; i < creases.size(); ++i) {
            const SharpEdge& crease = creases[i];
            const std::string where = element_ + ", creases " + std::to_string(i);
            const std::uint32_t a = vertex(crease.vertex0, where), b = vertex(crease.vertex1, where);
            const std::uint64_t edge = edgeKey(a, b);
            if (!std::binary_search(edges.begin(), edges.end(), edge)) {
                throw Failure{where, "there is no edge from vertex " + std::to_string(crease.vertex0) +
                                         " to vertex " + std::to_string(crease.vertex1)};
            }
            if (!isNew(knownEdges_, edge, crease.sharpness, i, where)) continue;
            result_.creaseEdges.insert(result_.creaseEdges.end(), {a, b});
            result_.creaseSharpness.push_back(crease.sharpness);
        }
    }

    void addCorners(const std::vector<SharpVertex>& corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::string where = element_ + ", corners " + std::to_string(i);
            const std::uint32_t at = vertex(corners[i].vertex, where);
            if (!isNew(knownVertices_, at, corners[i].sharpness, i, where)) continue;
            result_.cornerVertices.push_back(at);
            result_.cornerSharpness.push_back(corners[i].sharpness);
        }
    }

    void addHoles(const std::vector<std::uint32_t>& holes) {
        std::vector<bool> known(cage_.faceSizes.size());
        for (std::size_t i = 0; i < holes.size(); ++i) {
            if (holes[i] >= cage_.cageFaces.size()) {
                throw Failure{element_ + ", holes " + std::to_string(i),
                              "face " + std::to_string(holes[i]) + " does not exist: the mesh has " +
                                  std::to_string(cage_.cageFaces.size())};
            }
            const std::uint32_t face = cage_.cageFaces[holes[i]];
            if (face == notInCage || known[face]) continue;
            known[face] = true;
            result_.holes.push_back(face);
        }
    }

    CageSharpness take() { return std::move(result_); }

  private:
    struct Known {
        float sharpness;
        std::size_t entry;
    };
    using KnownValues = std::map<std::uint64_t, Known>;

    std::uint32_t vertex(std::uint32_t number, const std::string& where) const {
        const std::optional<std::uint32_t> found = source_.numbers.find(number);
        if (!found) {
            throw Failure{where, "vertex " + std::to_string(number) + " does not exist: the mesh has " +
                                     std::to_string(source_.numbers.count())};
        }
        const std::uint32_t vertex = cage_.cageVertices[*found];
        if (vertex == notInCage) {
            throw Failure{where, "vertex " + std::to_string(number) + " belongs to no face"};
        }
        return vertex;
    }

    /// The file may name a vertex by each of its split copies, so repetition is fine while the value is the
    /// same.
    static bool isNew(KnownValues& known, std::uint64_t key, float sharpness, std::size_t entry,
                      const std::string& where) {
        const auto [found, added] = known.try_emplace(key, Known{sharpness, entry});
        if (!added && found->second.sharpness != sharpness) {
            throw Failure{where, "gives another sharpness to what entry " +
                                     std::to_string(found->second.entry) + " names already"};
        }
        return added;
    }

    const CageSource& source_;
    const JoinedCage& cage_;
    std::string element_;
    CageSharpness result_;
    KnownValues knownEdges_, knownVertices_;
};

}  // namespace

CageSharpness resolveSharpness(const CageSettings& settings, const CageSource& source, const JoinedCage& cage,
                               const std::string& element) {
    Resolver resolver(source, cage, element);
    resolver.addCreases(settings.creases);
    resolver.addCorners(settings.corners);
    resolver.addHoles(settings.holes);
    return resolver.take();
}

}  // namespace candela_gltf
