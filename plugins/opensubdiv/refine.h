#pragma once

#include <candela/plugin.h>

#include <cstdint>

namespace candela_opensubdiv {

/// Refines a cage and hands the result to the host. Throws `Failure` or `HostRefused`.
void refine(const candela_refinement& host, const candela_cage& cage, std::uint32_t level);

}  // namespace candela_opensubdiv
