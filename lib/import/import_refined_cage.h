#pragma once

#include "import/abi_reader.h"

#include <candela/cage.h>
#include <candela/plugin.h>
#include <candela/refined_cage.h>

namespace candela {

/// Validates and copies the result of a subdivider for `cage`. The caller sets the level.
/// Throws `Error`: badInput that begins with `element`; limit when the faces have more corners than 32 bits
/// can count.
RefinedCage refinedCageFrom(const candela_refined_cage& source, const AbiReader& element, const Cage& cage);

}  // namespace candela
