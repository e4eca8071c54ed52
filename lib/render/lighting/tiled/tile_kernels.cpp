#include "render/lighting/tiled/tile_kernel.h"

#include "render/instruction_sets.h"

namespace candela {

extern const TileKernel tileKernelBaseline;
#if defined(__x86_64__)
extern const TileKernel tileKernelAvx2, tileKernelAvx512;
#endif

std::vector<const TileKernel*> tileKernels() {
    std::vector<const TileKernel*> kernels;
#if defined(__x86_64__)
    if (widestInstructionSet() >= InstructionSet::avx512) kernels.push_back(&tileKernelAvx512);
    if (widestInstructionSet() >= InstructionSet::avx2) kernels.push_back(&tileKernelAvx2);
#endif
    kernels.push_back(&tileKernelBaseline);
    return kernels;
}

const TileKernel& tileKernel() {
    static const TileKernel& widest = *tileKernels().front();
    return widest;
}

}  // namespace candela
