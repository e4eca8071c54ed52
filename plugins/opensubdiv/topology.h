#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "given_cage.h"

namespace candela_opensubdiv {

OpenSubdiv::Sdc::SchemeType osdScheme(candela_scheme scheme);

/// The cage as OpenSubdiv holds it, not refined; its face-varying channel 0 are the texture coordinates.
/// Throws `Failure` for what OpenSubdiv rejects, and for a crease that is no edge.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> makeTopology(const GivenCage& cage);

}  // namespace candela_opensubdiv
