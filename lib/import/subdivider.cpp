#include <candela/subdivider.h>

#include "import/abi_reader.h"
#include "import/cage_struct.h"
#include "import/refinement.h"
#include "import/subdivider_state.h"

#include <candela/error.h>

#include <limits>
#include <utility>

namespace candela {
namespace {

void checkLevel(const Cage& cage, std::uint32_t level) {
    const AbiReader element("cage", std::nullopt, cage.name.c_str());
    if (level < 1 || level > maxSubdivisionLevel)
        element.refuse(joined("it was to be refined to level ", level, ", but 1 to ", maxSubdivisionLevel,
                              " was expected"));
    // Where all faces have a surface, each corner of the cage makes 4^level corners in every scheme.
    if (!cage.holes.empty() || cage.boundaryInterpolation == BoundaryInterpolation::none) return;
    const std::uint64_t corners = std::uint64_t{cage.faceVertices.size()} << (2 * level);
    if (corners > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    joined(element.label(), ": at level ", level, " it has ", corners,
                           " corners, more than 32 bits can count"));
}

}  // namespace

Subdivider::Subdivider(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const std::string& Subdivider::name() const {
    return state_->name;
}

RefinedCage Subdivider::refine(const Cage& cage, std::uint32_t level) const {
    checkLevel(cage, level);
    const CageStruct cageStruct(cage);
    return Refinement(*state_->plugin, cage, cageStruct.get()).run(level);
}

}  // namespace candela
