#include "render/culling/occlusion_buffer.h"

#include "base/thread_pool.h"
#include "render/instruction_sets.h"

#include <algorithm>

namespace candela {

namespace {

constexpr int side = occlusionBlockSide;

}  // namespace

extern const OcclusionKernel occlusionKernelBaseline;
#if defined(__x86_64__)
extern const OcclusionKernel occlusionKernelAvx2, occlusionKernelAvx512;
#endif

std::vector<const OcclusionKernel*> occlusionKernels() {
    std::vector<const OcclusionKernel*> kernels;
#if defined(__x86_64__)
    if (widestInstructionSet() >= InstructionSet::avx512) kernels.push_back(&occlusionKernelAvx512);
    if (widestInstructionSet() >= InstructionSet::avx2) kernels.push_back(&occlusionKernelAvx2);
#endif
    kernels.push_back(&occlusionKernelBaseline);
    return kernels;
}

void OcclusionBuffer::clear(int width, int height) {
    width_ = width, height_ = height;
    columns_ = (width + side - 1) / side, rows_ = (height + side - 1) / side;
    const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    nearness_.assign(count, 0.0f);
    partial_.assign(count, {});
}

void OcclusionBuffer::draw(std::span<const OccluderPolygon> polygons) {
    constexpr int rowsPerTask = 4;
    const int tasks = (rows_ + rowsPerTask - 1) / rowsPerTask;
    ThreadPool::shared()->run(static_cast<std::size_t>(tasks), [&](std::size_t task, unsigned) {
        const int first = static_cast<int>(task) * rowsPerTask, end = std::min(first + rowsPerTask, rows_);
        for (const OccluderPolygon& polygon : polygons) {
            const int last = std::min(end - 1, polygon.maxY / side);
            for (int row = std::max(first, polygon.minY / side); row <= last; ++row) {
                const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(row) * columns_;
                kernel_.draw(polygon, {row, columns_, nearness_.data() + start, partial_.data() + start});
            }
        }
    });
}

bool OcclusionBuffer::hides(const PixelBox& box, float nearest) const {
    const int left = std::max(box.minX, 0) / side, right = std::min(box.maxX, width_ - 1) / side;
    const int bottom = std::max(box.minY, 0) / side, top = std::min(box.maxY, height_ - 1) / side;
    if (box.maxX < 0 || box.maxY < 0 || left > right || bottom > top) return false;
    for (int row = bottom; row <= top; ++row) {
        const float* known = nearness_.data() + static_cast<std::ptrdiff_t>(row) * columns_;
        for (int column = left; column <= right; ++column) {
            if (!(known[column] > nearest)) return false;
        }
    }
    return true;
}

}  // namespace candela
