// The frame's uniform block and functions of it.

#include "shared/bindings.h"
#include "shared/frame.h"

layout(std140, binding = FRAME_BINDING) uniform FrameBlock {
    FrameUniforms frame;
};

// `precise` keeps products and sums apart (no fused multiply-add), so that every device and the CPU compute the same position: close to a
// light, the last bit of a position far from the origin is visible.
//
// World position of the surface at a pixel, from its reversed depth (which is near plane / distance along the view axis).
vec3 worldPosition(ivec2 pixel, float depth) {
    precise vec3 ray = frame.rayCorner.xyz + float(pixel.x) * frame.rayStepX.xyz + float(pixel.y) * frame.rayStepY.xyz;
    precise vec3 position = frame.eye.xyz + ray * (frame.eye.w / depth);
    return position;
}

vec3 workingFromRec709(vec3 color) {
    return frame.workingFromRed.xyz * color.r + frame.workingFromGreen.xyz * color.g + frame.workingFromBlue.xyz * color.b;
}
