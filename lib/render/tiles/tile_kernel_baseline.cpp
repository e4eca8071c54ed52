#define CANDELA_TILE_KERNEL tileKernelBaseline
#define CANDELA_TILE_KERNEL_NAME "baseline"
#include "render/tiles/tile_kernel_code.h"
