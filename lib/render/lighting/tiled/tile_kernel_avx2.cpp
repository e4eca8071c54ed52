#define CANDELA_TILE_KERNEL tileKernelAvx2
#define CANDELA_TILE_KERNEL_NAME "avx2"
#include "render/lighting/tiled/tile_kernel_code.h"
