#pragma once

#include <candela/cage.h>

#include <cstdint>

namespace candela {

/// Expects the stencil table of a cage to equal OpenSubdiv's own evaluation: by Far and by Bfr at all
/// vertices, by uniform refinement at those of the cage.
void expectAgreement(const Cage& cage, std::uint32_t level);

}  // namespace candela
