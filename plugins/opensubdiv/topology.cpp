#include "topology.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "../common/failure.h"
#include "face_grid.h"

namespace candela_plugins::opensubdiv {

/// Catches the messages of OpenSubdiv, which it would print. Its callbacks are global, so they are set once
/// and pass each message to the catcher of the same thread; without one it is dropped.
class MessageCatcher {
  public:
    MessageCatcher();
    ~MessageCatcher();
    MessageCatcher(const MessageCatcher&) = delete;
    MessageCatcher& operator=(const MessageCatcher&) = delete;

    /// The first error since the catcher was created; empty when there is none. Warnings are dropped: the
    /// plugin makes these checks itself.
    const std::string& error() const { return error_; }

    void take(const char* error);

  private:
    std::string error_;
    MessageCatcher* outer_;
};

namespace {

namespace Far = OpenSubdiv::Far;

thread_local MessageCatcher* current = nullptr;

void takeError(Far::ErrorType, const char* message) {
    if (current != nullptr) current->take(message);
}

void dropWarning(const char*) {}

}  // namespace

MessageCatcher::MessageCatcher() : outer_(current) {
    static std::once_flag set;
    std::call_once(set, [] {
        Far::SetErrorCallback(takeError);
        Far::SetWarningCallback(dropWarning);
    });
    current = this;
}

MessageCatcher::~MessageCatcher() {
    current = outer_;
}

void MessageCatcher::take(const char* error) {
    if (error_.empty()) error_ = error;
}

namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr Sdc::SchemeType schemes[] = {Sdc::SCHEME_CATMARK, Sdc::SCHEME_LOOP, Sdc::SCHEME_BILINEAR};
constexpr Sdc::Options::VtxBoundaryInterpolation boundaries[] = {Sdc::Options::VTX_BOUNDARY_NONE,
                                                                 Sdc::Options::VTX_BOUNDARY_EDGE_ONLY,
                                                                 Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER};
constexpr Sdc::Options::FVarLinearInterpolation faceVaryings[] = {
    Sdc::Options::FVAR_LINEAR_NONE,          Sdc::Options::FVAR_LINEAR_CORNERS_ONLY,
    Sdc::Options::FVAR_LINEAR_CORNERS_PLUS1, Sdc::Options::FVAR_LINEAR_CORNERS_PLUS2,
    Sdc::Options::FVAR_LINEAR_BOUNDARIES,    Sdc::Options::FVAR_LINEAR_ALL};
constexpr Sdc::Options::CreasingMethod creaseMethods[] = {Sdc::Options::CREASE_UNIFORM,
                                                          Sdc::Options::CREASE_CHAIKIN};
constexpr Sdc::Options::TriangleSubdivision triangleRules[] = {Sdc::Options::TRI_SUB_CATMARK,
                                                               Sdc::Options::TRI_SUB_SMOOTH};

Sdc::Options optionsOf(const CheckedCage& cage) {
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(boundaries[cage.boundaryInterpolation]);
    options.SetFVarLinearInterpolation(faceVaryings[cage.faceVaryingInterpolation]);
    options.SetCreasingMethod(creaseMethods[cage.creaseMethod]);
    options.SetTriangleSubdivision(triangleRules[cage.triangleSubdivision]);
    return options;
}

/// OpenSubdiv's indices are int; `checkCage` has checked that all of ours fit.
const int* asInts(std::span<const std::uint32_t> values) {
    return reinterpret_cast<const int*>(values.data());
}

Far::TopologyDescriptor describe(const CheckedCage& cage,
                                 const Far::TopologyDescriptor::FVarChannel& textureCoordinates) {
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.vertexCount);
    descriptor.numFaces = static_cast<int>(cage.faceCount());
    descriptor.numVertsPerFace = asInts(cage.faceSizes);
    descriptor.vertIndicesPerFace = asInts(cage.faceVertices);
    descriptor.numCreases = static_cast<int>(cage.creaseSharpness.size());
    descriptor.creaseVertexIndexPairs = asInts(cage.creaseEdges);
    descriptor.creaseWeights = cage.creaseSharpness.data();
    descriptor.numCorners = static_cast<int>(cage.cornerSharpness.size());
    descriptor.cornerVertexIndices = asInts(cage.cornerVertices);
    descriptor.cornerWeights = cage.cornerSharpness.data();
    descriptor.numHoles = static_cast<int>(cage.holes.size());
    descriptor.holeIndices = asInts(cage.holes);
    descriptor.numFVarChannels = cage.uvCount != 0 ? 1 : 0;
    descriptor.fvarChannels = &textureCoordinates;
    return descriptor;
}

void checkCreases(const CheckedCage& cage, const Far::TopologyLevel& base) {
    for (std::size_t crease = 0; crease < cage.creaseSharpness.size(); ++crease) {
        const std::uint32_t vertex0 = cage.creaseEdges[2 * crease];
        const std::uint32_t vertex1 = cage.creaseEdges[2 * crease + 1];
        if (base.FindEdge(static_cast<int>(vertex0), static_cast<int>(vertex1)) != Far::INDEX_INVALID)
            continue;
        throw Failure{edgeName(vertex0, vertex1), "it is a crease, but no face has such an edge"};
    }
}

}  // namespace

Sdc::SchemeType osdScheme(candela_scheme scheme) {
    return schemes[scheme];
}

std::unique_ptr<Far::TopologyRefiner> makeTopology(const CheckedCage& cage) {
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Far::TopologyDescriptor::FVarChannel textureCoordinates;
    textureCoordinates.numValues = static_cast<int>(cage.uvCount);
    textureCoordinates.valueIndices = asInts(cage.faceUvs);

    const MessageCatcher messages;
    const Factory::Options options(osdScheme(cage.scheme), optionsOf(cage));
    std::unique_ptr<Far::TopologyRefiner> topology(
        Factory::Create(describe(cage, textureCoordinates), options));
    if (topology == nullptr) {
        throw Failure{"", messages.error().empty() ? "OpenSubdiv rejects its topology" : messages.error()};
    }
    checkCreases(cage, topology->GetLevel(0));
    return topology;
}

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
                      "the stencil table could have more than 4294967295 entries"};
    }
}

}  // namespace candela_plugins::opensubdiv
