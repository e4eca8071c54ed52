#define CANDELA_TILE_KERNEL tileKernelAvx512
#define CANDELA_DISPLAY_KERNEL displayKernelAvx512
#define CANDELA_ENVIRONMENT_KERNEL environmentKernelAvx512
#define CANDELA_TRIANGLE_KERNEL triangleKernelAvx512
#define CANDELA_OCCLUSION_KERNEL occlusionKernelAvx512
#define CANDELA_KERNEL_NAME "avx512"
#include "render/culling/occlusion_kernel_code.h"
#include "render/culling/triangle_filter_kernel_code.h"
#include "render/display/display_kernel_code.h"
#include "render/environment/environment_kernel_code.h"
#include "render/lighting/tiled/tile_kernel_code.h"
