#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <cstdint>
#include <memory>

#include "cage.h"

namespace candela_plugins::opensubdiv {

OpenSubdiv::Sdc::SchemeType osdScheme(candela_scheme scheme);

/// The topology of the cage, not refined; face-varying channel 0 has the texture coordinates. Throws
/// `Failure` for what OpenSubdiv rejects, and for a crease that is not an edge.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> makeTopology(const CheckedCage& cage);

/// Throws `Failure` where the table of a cage could have more entries than 32 bits count, before anything of
/// that size is built. Points and polygons are fewer than entries.
void checkTableSize(const OpenSubdiv::Far::TopologyRefiner& topology, std::uint32_t level);

}  // namespace candela_plugins::opensubdiv
