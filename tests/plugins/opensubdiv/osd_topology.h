#pragma once

#include <candela/cage.h>

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

namespace candela {

/// The topology of a cage for OpenSubdiv, built without the plugin's code. Not refined.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> osdTopology(const Cage& cage);

}  // namespace candela
