#pragma once

#include "import/abi_reader.h"

#include <candela/cage.h>
#include <candela/plugin.h>

namespace candela {

// What moves a pushed cage besides its node. The cage has its vertices already.

/// Joints and their weights, whose sum becomes 1 for each vertex.
void takeInfluences(const candela_cage& pushed, const AbiReader& element, Cage& cage);
void takeMorphTargets(const candela_cage& pushed, const AbiReader& element, Cage& cage);

}  // namespace candela
