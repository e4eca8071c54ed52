#include "render/lighting/tiled/tile_kernel.h"

namespace candela {

extern const TileKernel tileKernelBaseline;
#if defined(__x86_64__)
extern const TileKernel tileKernelAvx2, tileKernelAvx512;
#endif

std::vector<const TileKernel*> tileKernels() {
    std::vector<const TileKernel*> kernels;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        kernels.push_back(&tileKernelAvx512);
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) kernels.push_back(&tileKernelAvx2);
#endif
    kernels.push_back(&tileKernelBaseline);
    return kernels;
}

const TileKernel& tileKernel() {
    static const TileKernel& widest = *tileKernels().front();
    return widest;
}

}  // namespace candela
