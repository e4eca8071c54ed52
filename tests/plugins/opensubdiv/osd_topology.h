#pragma once

#include <candela/cage.h>

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

namespace candela {

/// A cage as OpenSubdiv holds it, made by this test alone: not by the plugin's code. Not refined.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> osdTopology(const Cage& cage);

}  // namespace candela
