// The frame's uniform block and what follows from it.

#include "shared/bindings.h"
#include "shared/frame.h"

layout(std140, binding = FRAME_BINDING) uniform FrameBlock { FrameUniforms frame; };

// World position of the surface at a pixel, from its reversed depth (which is near plane / distance along the view axis).
vec3 worldPosition(ivec2 pixel, float depth) {
    vec3 ray = frame.rayCorner.xyz + float(pixel.x) * frame.rayStepX.xyz + float(pixel.y) * frame.rayStepY.xyz;
    return frame.eye.xyz + ray * (frame.eye.w / depth);
}

vec3 workingFromRec709(vec3 color) {
    return frame.workingFromRed.xyz * color.r + frame.workingFromGreen.xyz * color.g + frame.workingFromBlue.xyz * color.b;
}
