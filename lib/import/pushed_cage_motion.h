#pragma once

#include "import/pushed_element.h"

#include <candela/cage.h>
#include <candela/plugin.h>

namespace candela {

// What moves a pushed cage besides its node. The cage has its vertices already.

/// Joints and their weights, whose sum becomes 1 for each vertex.
void takeInfluences(const candela_cage& pushed, const PushedElement& element, Cage& cage);
void takeMorphTargets(const candela_cage& pushed, const PushedElement& element, Cage& cage);

}  // namespace candela
