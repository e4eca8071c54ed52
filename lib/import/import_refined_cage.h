#pragma once

#include "import/abi_reader.h"

#include <candela/cage.h>
#include <candela/plugin.h>
#include <candela/refined_cage.h>

namespace candela {

/// What a subdivider has set as the result for `cage`, checked and copied; the level is left to the caller.
/// Throws `Error`: badInput that begins with `element`; limit when the faces have more corners than 32 bits
/// can count.
RefinedCage refinedCageFrom(const candela_refined_cage& source, const AbiReader& element, const Cage& cage);

}  // namespace candela
