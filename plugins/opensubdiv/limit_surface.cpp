#include "limit_surface.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>

namespace candela_plugins::opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;

/// Of any kind of patch: a Gregory patch has 20 points, a triangular one 18.
constexpr int maxPatchPoints = 20;

/// The levels until the last semi-sharp feature has become smooth; 0 to 10.
int semiSharpLevels(const Far::TopologyLevel& base) {
    float maxSharpness = 0.0f;
    for (int edge = 0; edge < base.GetNumEdges(); ++edge) {
        if (base.IsEdgeSemiSharp(edge)) maxSharpness = std::max(maxSharpness, base.GetEdgeSharpness(edge));
    }
    for (int vertex = 0; vertex < base.GetNumVertices(); ++vertex) {
        if (base.IsVertexSemiSharp(vertex))
            maxSharpness = std::max(maxSharpness, base.GetVertexSharpness(vertex));
    }
    return static_cast<int>(std::ceil(maxSharpness));
}

std::unique_ptr<Far::TopologyRefiner> refined(const Far::TopologyRefiner& base, int level, Primvar primvar) {
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> topology(Factory::Create(base));
    Far::TopologyRefiner::AdaptiveOptions options(std::max(level, semiSharpLevels(base.GetLevel(0))));
    options.useInfSharpPatch = true;
    options.considerFVarChannels = primvar == Primvar::uv;
    topology->RefineAdaptive(options);
    return topology;
}

std::unique_ptr<const Far::PatchTable> makePatches(const Far::TopologyRefiner& topology, Primvar primvar) {
    Far::PatchTableFactory::Options options;
    options.SetPatchPrecision<double>();
    options.SetFVarPatchPrecision<double>();
    options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    options.useInfSharpPatch = true;
    options.generateVaryingTables = false;
    options.generateVaryingLocalPoints = false;
    options.generateFVarTables = primvar == Primvar::uv;
    // Both would be approximations, for the sake of older versions.
    options.generateFVarLegacyLinearPatches = false;
    options.generateLegacySharpCornerPatches = false;
    return std::unique_ptr<const Far::PatchTable>(Far::PatchTableFactory::Create(topology, options));
}

/// The weights of a patch's points at a location.
struct PatchBasis {
    double value[maxPatchPoints], du[maxPatchPoints], dv[maxPatchPoints];
};

}  // namespace

LimitSurface::LimitSurface(const Far::TopologyRefiner& base, std::uint32_t level, Primvar primvar)
    : primvar_(primvar), ptexFaces_(base) {
    const auto topology = refined(base, static_cast<int>(level), primvar);
    patches_ = makePatches(*topology, primvar);
    map_ = std::make_unique<Far::PatchMap>(*patches_);
    stencils_ = std::make_unique<PointStencils>(*topology, *patches_, primvar);
}

const Far::PatchTable::PatchHandle* LimitSurface::find(const Place& place) const {
    const int ptexFace = ptexFaces_.GetFaceId(static_cast<int>(place.face)) + static_cast<int>(place.patch);
    return map_->FindPatch(ptexFace, place.s, place.t);
}

bool LimitSurface::covers(std::uint32_t face) const {
    return find({face, 0, 0.25, 0.25}) != nullptr;
}

void LimitSurface::evaluate(const Place& place, LimitStencil& stencil) const {
    const PatchTable::PatchHandle& patch = *find(place);
    const bool isPosition = primvar_ == Primvar::position;
    PatchBasis basis;
    if (isPosition) {
        patches_->EvaluateBasis(patch, place.s, place.t, basis.value, basis.du, basis.dv);
    } else {
        patches_->EvaluateBasisFaceVarying(patch, place.s, place.t, basis.value, basis.du, basis.dv);
    }
    const Far::ConstIndexArray points =
        isPosition ? patches_->GetPatchVertices(patch) : patches_->GetPatchFVarValues(patch);
    stencil.clear();
    for (int i = 0; i < points.size(); ++i) {
        const Weights weights{basis.value[i], basis.du[i], basis.dv[i]};
        for (const StencilList::Entry& entry : stencils_->of(points[i])) {
            stencil.add(entry.index, weights * entry.weight);
        }
    }
}

}  // namespace candela_plugins::opensubdiv
