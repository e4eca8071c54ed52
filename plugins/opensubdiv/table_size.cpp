#include "table_size.h"

#include <limits>
#include <vector>

#include "face_grid.h"
#include "failure.h"

namespace candela_opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;

/// Counts the vertices that a face's surface depends on: those of all faces around its corners.
class Neighbourhoods {
  public:
    explicit Neighbourhoods(const Far::TopologyLevel& base)
        : base_(base), lastSeen_(static_cast<std::size_t>(base.GetNumVertices()), -1) {}

    std::uint64_t count(int face) {
        std::uint64_t count = 0;
        for (const int corner : base_.GetFaceVertices(face)) {
            for (const int neighbour : base_.GetVertexFaces(corner)) {
                for (const int vertex : base_.GetFaceVertices(neighbour)) {
                    int& seen = lastSeen_[static_cast<std::size_t>(vertex)];
                    if (seen != face) ++count;
                    seen = face;
                }
            }
        }
        return count;
    }

  private:
    const Far::TopologyLevel& base_;
    std::vector<int> lastSeen_;
};

}  // namespace

void checkTableSize(const Far::TopologyRefiner& topology, std::uint32_t level) {
    const Far::TopologyLevel& base = topology.GetLevel(0);
    Neighbourhoods neighbourhoods(base);
    std::uint64_t entries = 0;
    for (int face = 0; face < base.GetNumFaces(); ++face) {
        const auto size = static_cast<std::uint64_t>(base.GetFaceVertices(face).size());
        entries += gridPoints(topology.GetSchemeType(), size, level) * neighbourhoods.count(face);
        if (entries <= std::numeric_limits<std::uint32_t>::max()) continue;
        throw Failure{"level " + std::to_string(level),
                      "the table of weights could have more than 4294967295 entries"};
    }
}

}  // namespace candela_opensubdiv
