#pragma once

#include <cstdint>

namespace candela_plugins::plaza {

/// How much memory this process may still take, in bytes, without swapping: what the system has free, what
/// the control group leaves and what the limit of the address space leaves, whichever is least. UINT64_MAX
/// where the system tells none.
std::uint64_t availableMemory();

}  // namespace candela_plugins::plaza
