#pragma once

#include "render/gpu_scene/draw_list.h"

#include <epoxy/gl.h>

#include <cstdint>

namespace candela {

/// Issues the commands of a batch from the bound indirect buffer.
inline void drawCommands(const DrawBatch& batch) {
    constexpr std::uintptr_t commandSize = 5 * sizeof(std::uint32_t);
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                                reinterpret_cast<const void*>(batch.firstCommand * commandSize),
                                static_cast<GLsizei>(batch.commandCount), 0);
}

}  // namespace candela
