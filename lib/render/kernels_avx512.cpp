#define CANDELA_TILE_KERNEL tileKernelAvx512
#define CANDELA_DEFORM_KERNEL deformKernelAvx512
#define CANDELA_KERNEL_NAME "avx512"
#include "render/deformation/deform_kernel_code.h"
#include "render/lighting/tiled/tile_kernel_code.h"
