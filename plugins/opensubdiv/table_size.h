#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <cstdint>

namespace candela_opensubdiv {

/// Throws `Failure` where the table of a cage could have more entries than 32 bits count, before anything of
/// that size is made. Points and polygons are fewer than entries.
void checkTableSize(const OpenSubdiv::Far::TopologyRefiner& topology, std::uint32_t level);

}  // namespace candela_opensubdiv
