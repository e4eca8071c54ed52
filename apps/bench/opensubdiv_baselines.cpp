#include "opensubdiv_baselines.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/ompEvaluator.h>

#include <memory>

namespace Far = OpenSubdiv::Far;
namespace Osd = OpenSubdiv::Osd;
namespace Sdc = OpenSubdiv::Sdc;

namespace {

std::unique_ptr<Far::TopologyRefiner> makeRefiner(const candela::Cage& cage) {
    const std::vector<int> sizes(cage.faceSizes.begin(), cage.faceSizes.end());
    const std::vector<int> vertices(cage.faceVertices.begin(), cage.faceVertices.end());
    Far::TopologyDescriptor topology;
    topology.numVertices = static_cast<int>(cage.positions.size());
    topology.numFaces = static_cast<int>(sizes.size());
    topology.numVertsPerFace = sizes.data();
    topology.vertIndicesPerFace = vertices.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    return std::unique_ptr<Far::TopologyRefiner>(
        Factory::Create(topology, Factory::Options(Sdc::SCHEME_CATMARK, Sdc::Options())));
}

}  // namespace

OmpMove::OmpMove(const candela::RefinedCage& refined)
    : table_(refined.positions),
      controlIndices_(table_.controlIndices.begin(), table_.controlIndices.end()),
      positions_(refined.vertexCount()),
      du_(refined.vertexCount()),
      dv_(refined.vertexCount()) {
    for (std::size_t stencil = 0; stencil < refined.vertexCount(); ++stencil) {
        offsets_.push_back(static_cast<int>(table_.offsets[stencil]));
        sizes_.push_back(static_cast<int>(table_.offsets[stencil + 1] - table_.offsets[stencil]));
    }
}

void OmpMove::move(std::span<const glm::vec3> cagePoints) {
    const Osd::BufferDescriptor points(0, 3, 3);
    Osd::OmpEvaluator::EvalStencils(
        &cagePoints.front().x, points, &positions_.front().x, points, &du_.front().x, points, &dv_.front().x,
        points, sizes_.data(), offsets_.data(), controlIndices_.data(), table_.weights.data(),
        table_.duWeights.data(), table_.dvWeights.data(), 0, static_cast<int>(sizes_.size()));
}

std::uint64_t refineWithFar(const candela::Cage& cage, std::uint32_t level) {
    const std::unique_ptr<Far::TopologyRefiner> refiner = makeRefiner(cage);
    Far::PatchTableFactory::Options patches(level);
    patches.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    refiner->RefineAdaptive(patches.GetRefineAdaptiveOptions());
    const std::uint32_t side = 1u << level;
    std::vector<float> s, t;
    for (std::uint32_t i = 0; i < side; ++i) {
        for (std::uint32_t j = 0; j < side; ++j) {
            s.push_back(static_cast<float>(i) / static_cast<float>(side));
            t.push_back(static_cast<float>(j) / static_cast<float>(side));
        }
    }
    Far::LimitStencilTableFactory::LocationArrayVec locations(cage.faceSizes.size());
    for (std::size_t face = 0; face < locations.size(); ++face) {
        locations[face].ptexIdx = static_cast<int>(face);
        locations[face].numLocations = static_cast<int>(s.size());
        locations[face].s = s.data();
        locations[face].t = t.data();
    }
    const std::unique_ptr<const Far::LimitStencilTable> stencils(
        Far::LimitStencilTableFactory::Create(*refiner, locations, nullptr, nullptr));
    return static_cast<std::uint64_t>(stencils->GetNumStencils());
}
