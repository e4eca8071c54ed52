#define CANDELA_TILE_KERNEL tileKernelAvx2
#define CANDELA_DEFORM_KERNEL deformKernelAvx2
#define CANDELA_DISPLAY_KERNEL displayKernelAvx2
#define CANDELA_ENVIRONMENT_KERNEL environmentKernelAvx2
#define CANDELA_TRIANGLE_KERNEL triangleKernelAvx2
#define CANDELA_OCCLUSION_KERNEL occlusionKernelAvx2
#define CANDELA_KERNEL_NAME "avx2"
#include "render/culling/occlusion_kernel_code.h"
#include "render/culling/triangle_filter_kernel_code.h"
#include "render/deformation/deform_kernel_code.h"
#include "render/display/display_kernel_code.h"
#include "render/environment/environment_kernel_code.h"
#include "render/lighting/tiled/tile_kernel_code.h"
