#include "topology.h"

#include <opensubdiv/far/topologyDescriptor.h>

#include "failure.h"
#include "messages.h"

namespace candela_opensubdiv {
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

Sdc::Options optionsOf(const GivenCage& cage) {
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(boundaries[cage.boundaryInterpolation]);
    options.SetFVarLinearInterpolation(faceVaryings[cage.faceVaryingInterpolation]);
    options.SetCreasingMethod(creaseMethods[cage.creaseMethod]);
    options.SetTriangleSubdivision(triangleRules[cage.triangleSubdivision]);
    return options;
}

/// OpenSubdiv's indices are int; `checkedCage` has made sure that all of ours fit.
const int* asInts(std::span<const std::uint32_t> values) {
    return reinterpret_cast<const int*>(values.data());
}

Far::TopologyDescriptor describe(const GivenCage& cage,
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

void checkCreases(const GivenCage& cage, const Far::TopologyLevel& base) {
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

std::unique_ptr<Far::TopologyRefiner> makeTopology(const GivenCage& cage) {
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

}  // namespace candela_opensubdiv
