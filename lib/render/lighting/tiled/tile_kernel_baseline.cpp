#define CANDELA_TILE_KERNEL tileKernelBaseline
#define CANDELA_TILE_KERNEL_NAME "baseline"
#include "render/lighting/tiled/tile_kernel_code.h"
