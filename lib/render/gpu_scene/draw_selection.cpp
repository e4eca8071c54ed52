#include "render/gpu_scene/draw_list.h"

#include <algorithm>

namespace candela {

namespace {

GLenum modeOf(Topology topology) {
    if (topology == Topology::triangles) return GL_TRIANGLES;
    return topology == Topology::lines ? GL_LINES : GL_POINTS;
}

}  // namespace

std::size_t DrawSelection::drawCount() const {
    std::size_t count = 0;
    for (const DrawCommand& command : commands_) count += command.instanceCount;
    return count;
}

bool DrawSelection::isExtended() const {
    return std::ranges::any_of(
        batches_, [](const DrawBatch& batch) { return batch.key.program == PipelineKey::Program::extended; });
}

Backdrop DrawSelection::backdrop() const {
    Backdrop highest = Backdrop::none;
    for (const DrawBatch& batch : batches_) highest = std::max(highest, batch.key.backdrop);
    return highest;
}

bool DrawSelection::emits(SurfaceSet set) const {
    return std::ranges::any_of(
        batches_, [&](const DrawBatch& batch) { return batch.key.emissive && batch.key.isIn(set); });
}

void DrawSelection::draw(const DrawBatch& batch) {
    glMultiDrawElementsIndirect(
        modeOf(batch.key.topology), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(std::uintptr_t{batch.firstCommand} * sizeof(DrawCommand)),
        static_cast<GLsizei>(batch.commandCount), 0);
}

}  // namespace candela
