#define CANDELA_TILE_KERNEL tileKernelBaseline
#define CANDELA_DEFORM_KERNEL deformKernelBaseline
#define CANDELA_DISPLAY_KERNEL displayKernelBaseline
#define CANDELA_ENVIRONMENT_KERNEL environmentKernelBaseline
#define CANDELA_TRIANGLE_KERNEL triangleKernelBaseline
#define CANDELA_OCCLUSION_KERNEL occlusionKernelBaseline
#define CANDELA_KERNEL_NAME "baseline"
#include "render/culling/occlusion_kernel_code.h"
#include "render/culling/triangle_filter_kernel_code.h"
#include "render/deformation/deform_kernel_code.h"
#include "render/display/display_kernel_code.h"
#include "render/environment/environment_kernel_code.h"
#include "render/lighting/tiled/tile_kernel_code.h"
