#include "osd_topology.h"

#include <opensubdiv/far/topologyDescriptor.h>

#include <vector>

namespace candela {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

Sdc::SchemeType schemeOf(const Cage& cage) {
    if (cage.scheme == SubdivisionScheme::loop) return Sdc::SCHEME_LOOP;
    return cage.scheme == SubdivisionScheme::bilinear ? Sdc::SCHEME_BILINEAR : Sdc::SCHEME_CATMARK;
}

Sdc::Options optionsOf(const Cage& cage) {
    Sdc::Options options;
    if (cage.boundaryInterpolation == BoundaryInterpolation::edges) {
        options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    } else if (cage.boundaryInterpolation == BoundaryInterpolation::edgesAndCorners) {
        options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    }
    switch (cage.faceVaryingInterpolation) {
        case FaceVaryingInterpolation::none:
            options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_NONE);
            break;
        case FaceVaryingInterpolation::cornersOnly:
            options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_ONLY);
            break;
        case FaceVaryingInterpolation::cornersPlus1:
            options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_PLUS1);
            break;
        case FaceVaryingInterpolation::cornersPlus2:
            options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_PLUS2);
            break;
        case FaceVaryingInterpolation::boundaries:
            options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_BOUNDARIES);
            break;
        case FaceVaryingInterpolation::all:
            options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_ALL);
    }
    if (cage.creaseMethod == CreaseMethod::chaikin) options.SetCreasingMethod(Sdc::Options::CREASE_CHAIKIN);
    if (cage.triangleSubdivision == TriangleSubdivision::smooth) {
        options.SetTriangleSubdivision(Sdc::Options::TRI_SUB_SMOOTH);
    }
    return options;
}

std::vector<int> asInts(const std::vector<std::uint32_t>& values) {
    return {values.begin(), values.end()};
}

}  // namespace

std::unique_ptr<Far::TopologyRefiner> osdTopology(const Cage& cage) {
    const std::vector<int> sizes = asInts(cage.faceSizes), vertices = asInts(cage.faceVertices),
                           uvs = asInts(cage.faceUvs), holes = asInts(cage.holes);
    std::vector<int> creases, corners;
    std::vector<float> creaseSharpness, cornerSharpness;
    for (const Crease& crease : cage.creases) {
        creases.push_back(static_cast<int>(crease.vertex0));
        creases.push_back(static_cast<int>(crease.vertex1));
        creaseSharpness.push_back(crease.sharpness);
    }
    for (const Corner& corner : cage.corners) {
        corners.push_back(static_cast<int>(corner.vertex));
        cornerSharpness.push_back(corner.sharpness);
    }
    Far::TopologyDescriptor::FVarChannel channel;
    channel.numValues = static_cast<int>(cage.uvs.size());
    channel.valueIndices = uvs.data();
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.positions.size());
    descriptor.numFaces = static_cast<int>(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = vertices.data();
    descriptor.numCreases = static_cast<int>(creaseSharpness.size());
    descriptor.creaseVertexIndexPairs = creases.data();
    descriptor.creaseWeights = creaseSharpness.data();
    descriptor.numCorners = static_cast<int>(corners.size());
    descriptor.cornerVertexIndices = corners.data();
    descriptor.cornerWeights = cornerSharpness.data();
    descriptor.numHoles = static_cast<int>(holes.size());
    descriptor.holeIndices = holes.data();
    descriptor.numFVarChannels = cage.uvs.empty() ? 0 : 1;
    descriptor.fvarChannels = &channel;
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    return std::unique_ptr<Far::TopologyRefiner>(
        Factory::Create(descriptor, Factory::Options(schemeOf(cage), optionsOf(cage))));
}

}  // namespace candela
