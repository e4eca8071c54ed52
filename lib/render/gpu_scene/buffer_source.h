#pragma once

#include <candela/gpu_scene.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

/// Throws `Error` (badInput) unless `range` is one of a buffer that has `size` bytes from its offset on.
void requireBytes(const BufferRange& range, std::uint64_t size, const char* what);

/// Reads `size` bytes of a buffer. Throws as `requireBytes` does.
std::vector<std::byte> readBytes(const BufferRange& range, std::uint64_t size, const char* what);

}  // namespace candela
