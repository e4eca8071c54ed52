#include "render/subdivision/compute_evaluator.h"

#include "render/layout.h"
#include "render/subdivision/gpu_stencil_table.h"

#include <algorithm>

namespace candela {

namespace {

void bindStorage(int binding, const gl::Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.name());
}

std::size_t maxStorageBlock() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

}  // namespace

ComputeEvaluator::ComputeEvaluator()
    : program_({{"cage_limit.comp", {}, {}}}, "cage limit"), maxBlock_(maxStorageBlock()) {}

bool ComputeEvaluator::takes(const LimitRequest& request) const {
    const RefinedCage& refined = request.table.refined();
    const std::size_t largest =
        std::max({refined.positions.columns.size() * GpuStencilTable::Storage::entryBytes,
                  LimitStreams::surfaceBytes(refined.vertexCount()), request.uvDerivatives.size_bytes(),
                  request.points.size_bytes()});
    // llvmpipe ends a loop after 65,535 turns without a word.
    constexpr std::uint32_t maxRow = 65535;
    return largest <= maxBlock_ && request.table.longestRow() <= maxRow;
}

void ComputeEvaluator::evaluate(const LimitRequest& request) const {
    const RefinedCage& refined = request.table.refined();
    if (refined.vertexCount() == 0) return;
    const GpuStencilTable::Storage& storage = request.table.storage();
    const bool wantsTangents = !request.uvDerivatives.empty();
    bindStorage(layout::LIMIT_ROWS_STORAGE, storage.rows);
    bindStorage(layout::LIMIT_ENTRIES_STORAGE, storage.entries);
    bindStorage(layout::LIMIT_POINTS_STORAGE, request.pointBuffer);
    bindStorage(layout::LIMIT_SURFACE_STORAGE, request.streams.surface);
    if (wantsTangents) {
        bindStorage(layout::LIMIT_UVS_STORAGE, request.table.uvDerivativeBuffer());
        bindStorage(layout::LIMIT_TANGENTS_STORAGE, request.streams.tangents);
    }
    glUseProgram(program_.name());
    glUniform1i(layout::LIMIT_TANGENTS_LOCATION, wantsTangents ? 1 : 0);
    dispatch(0, refined.pointCount, request.table);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    dispatch(refined.pointCount, refined.vertexCount(), request.table);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

void ComputeEvaluator::dispatch(std::size_t first, std::size_t end, const GpuStencilTable& table) const {
    if (first == end) return;
    constexpr std::size_t groupSize = 64, maxGroups = 65535;  // What every device takes along one axis.
    const RefinedCage& refined = table.refined();
    const std::size_t groups = (end - first + groupSize - 1) / groupSize;
    const std::size_t columns = std::min(groups, maxGroups);
    glUniform4ui(layout::LIMIT_RANGE_LOCATION, static_cast<GLuint>(first), static_cast<GLuint>(end),
                 refined.pointCount, static_cast<GLuint>(refined.vertexCount()));
    glDispatchCompute(static_cast<GLuint>(columns), static_cast<GLuint>((groups + columns - 1) / columns), 1);
}

}  // namespace candela
