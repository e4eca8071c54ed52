#include "reference.h"

#include "osd_topology.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;

using Stencils = Far::StencilTableReal<double>;
using StencilFactory = Far::StencilTableFactoryReal<double>;
using LimitStencils = Far::LimitStencilTableReal<double>;
using LimitFactory = Far::LimitStencilTableFactoryReal<double>;

std::size_t controlCount(const Cage& cage, Primvar primvar) {
    return primvar == Primvar::position ? cage.positions.size() : cage.uvs.size();
}

ReferenceStencil zeroStencil(std::size_t controls) {
    const std::vector<double> zeros(controls, 0.0);
    return {zeros, zeros, zeros};
}

/// Whether the vertex lies on a sub-face, which is half as wide in the parameters of its face.
bool isOnSubface(const Cage& cage, const GridVertex& vertex) {
    return cage.scheme != SubdivisionScheme::loop && cage.faceSizes[vertex.face] != 4;
}

/// The patches of a refined topology, and the stencils of all their points.
struct Patches {
    std::unique_ptr<const Far::PatchTable> table;
    std::unique_ptr<const Stencils> points;
};

Patches patchesOf(const Far::TopologyRefiner& refined, Primvar primvar) {
    Far::PatchTableFactory::Options patchOptions;
    patchOptions.SetPatchPrecision<double>();
    patchOptions.SetFVarPatchPrecision<double>();
    patchOptions.useInfSharpPatch = true;
    patchOptions.generateLegacySharpCornerPatches = false;
    patchOptions.generateFVarTables = primvar == Primvar::uv;
    patchOptions.generateFVarLegacyLinearPatches = false;
    patchOptions.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    Patches patches;
    patches.table.reset(Far::PatchTableFactory::Create(refined, patchOptions));

    StencilFactory::Options stencilOptions;
    stencilOptions.interpolationMode = primvar == Primvar::position
                                           ? StencilFactory::INTERPOLATE_VERTEX
                                           : StencilFactory::INTERPOLATE_FACE_VARYING;
    stencilOptions.generateOffsets = true;
    stencilOptions.generateControlVerts = true;
    stencilOptions.generateIntermediateLevels = true;
    patches.points.reset(StencilFactory::Create(refined, stencilOptions));
    const Stencils* const local = primvar == Primvar::position
                                      ? patches.table->GetLocalPointStencilTable<double>()
                                      : patches.table->GetLocalPointFaceVaryingStencilTable<double>();
    const Stencils* joined =
        primvar == Primvar::position
            ? StencilFactory::AppendLocalPointStencilTable(refined, patches.points.get(), local)
            : StencilFactory::AppendLocalPointStencilTableFaceVarying(refined, patches.points.get(), local);
    if (joined != nullptr) patches.points.reset(joined);
    return patches;
}

/// The locations of vertices, in one array per patch.
struct Locations {
    std::vector<double> s, t;
    LimitFactory::LocationArrayVec arrays;

    Locations(const std::vector<GridVertex>& vertices, const Far::PtexIndices& ptexFaces) {
        for (const GridVertex& vertex : vertices) {
            s.push_back(vertex.s);
            t.push_back(vertex.t);
        }
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const int ptexFace =
                ptexFaces.GetFaceId(static_cast<int>(vertices[i].face)) + static_cast<int>(vertices[i].patch);
            if (arrays.empty() || arrays.back().ptexIdx != ptexFace) {
                arrays.emplace_back();
                arrays.back().ptexIdx = ptexFace;
                arrays.back().s = &s[i];
                arrays.back().t = &t[i];
            }
            ++arrays.back().numLocations;
        }
    }
};

}  // namespace

int semiSharpLevels(const Cage& cage) {
    const auto topology = osdTopology(cage);
    const Far::TopologyLevel& base = topology->GetLevel(0);
    float maximum = 0.0f;
    for (int edge = 0; edge < base.GetNumEdges(); ++edge) {
        if (!base.IsEdgeInfSharp(edge)) maximum = std::max(maximum, base.GetEdgeSharpness(edge));
    }
    for (int vertex = 0; vertex < base.GetNumVertices(); ++vertex) {
        if (!base.IsVertexInfSharp(vertex)) maximum = std::max(maximum, base.GetVertexSharpness(vertex));
    }
    return static_cast<int>(std::ceil(maximum));
}

ReferenceStencils farReference(const Cage& cage, std::uint32_t level, const std::vector<GridVertex>& vertices,
                               Primvar primvar) {
    const auto topology = osdTopology(cage);
    Far::TopologyRefiner::AdaptiveOptions adaptive(std::max(static_cast<int>(level), semiSharpLevels(cage)));
    adaptive.useInfSharpPatch = true;
    adaptive.considerFVarChannels = primvar == Primvar::uv;
    topology->RefineAdaptive(adaptive);
    const Patches patches = patchesOf(*topology, primvar);

    const Locations locations(vertices, Far::PtexIndices(*topology));
    LimitFactory::Options options;
    options.interpolationMode = primvar == Primvar::position ? LimitFactory::INTERPOLATE_VERTEX
                                                             : LimitFactory::INTERPOLATE_FACE_VARYING;
    const std::unique_ptr<const LimitStencils> limits(LimitFactory::Create(
        *topology, locations.arrays, patches.points.get(), patches.table.get(), options));
    EXPECT_NE(limits, nullptr);
    if (limits == nullptr) return {};
    EXPECT_EQ(static_cast<std::size_t>(limits->GetNumStencils()), vertices.size());

    ReferenceStencils stencils;
    std::size_t entry = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        ReferenceStencil stencil = zeroStencil(controlCount(cage, primvar));
        for (int k = 0; k < limits->GetSizes()[i]; ++k, ++entry) {
            const auto control = static_cast<std::size_t>(limits->GetControlIndices()[entry]);
            stencil.value[control] += limits->GetWeights()[entry];
            stencil.du[control] += limits->GetDuWeights()[entry];
            stencil.dv[control] += limits->GetDvWeights()[entry];
        }
        stencils.push_back(std::move(stencil));
    }
    return stencils;
}

ReferenceStencils bfrReference(const Cage& cage, std::uint32_t level, const std::vector<GridVertex>& vertices,
                               Primvar primvar) {
    const auto topology = osdTopology(cage);
    Bfr::SurfaceFactory::Options options;
    const int isolation = std::max(static_cast<int>(level), semiSharpLevels(cage));
    options.SetApproxLevelSmooth(isolation);
    options.SetApproxLevelSharp(isolation);
    options.SetDefaultFVarID(0);
    const Bfr::RefinerSurfaceFactory<> factory(*topology, options);
    ReferenceStencils stencils;
    for (const GridVertex& vertex : vertices) {
        Bfr::Surface<double> surface;
        const int face = static_cast<int>(vertex.face);
        EXPECT_TRUE(primvar == Primvar::position ? factory.InitVertexSurface(face, &surface)
                                                 : factory.InitFaceVaryingSurface(face, &surface));
        double uv[2] = {vertex.s, vertex.t};
        if (isOnSubface(cage, vertex)) {
            const double inSubface[2] = {vertex.s / 2, vertex.t / 2};
            surface.GetParameterization().ConvertSubFaceToCoord(static_cast<int>(vertex.patch), inSubface,
                                                                uv);
        }
        const auto count = static_cast<std::size_t>(surface.GetNumControlPoints());
        std::vector<int> controls(count);
        surface.GetControlPointIndices(controls.data());
        ReferenceStencil local = zeroStencil(count), stencil = zeroStencil(controlCount(cage, primvar));
        surface.EvaluateStencil(uv, local.value.data(), local.du.data(), local.dv.data());
        for (std::size_t i = 0; i < count; ++i) {
            const auto control = static_cast<std::size_t>(controls[i]);
            stencil.value[control] += local.value[i];
            stencil.du[control] += local.du[i];
            stencil.dv[control] += local.dv[i];
        }
        stencils.push_back(std::move(stencil));
    }
    return stencils;
}

}  // namespace candela
