// The frame's uniform block and functions of it.

#include "shared/bindings.h"
#include "shared/frame.h"

layout(std140, binding = FRAME_BINDING) uniform FrameBlock {
    FrameUniforms frame;
};

// `precise` keeps products and sums apart (no fused multiply-add), so that every device and the CPU compute the same position: close to a
// light, the last bit of a position far from the origin is visible.
//
bool isOrthographic() { return frame.depthRange.w != 0.0; }

// Distance along the view axis, metres, of a reversed depth: see `projection` of candela/camera.h.
float viewDistance(float depth) {
    precise float orthographic = frame.depthRange.y - depth * frame.depthRange.z;
    precise float perspective = frame.eye.w / (depth * frame.depthRange.y + frame.depthRange.x);
    return isOrthographic() ? orthographic : perspective;
}

// World position of the surface at a pixel, from its reversed depth.
vec3 worldPosition(ivec2 pixel, float depth) {
    precise vec3 ray = frame.rayCorner.xyz + float(pixel.x) * frame.rayStepX.xyz + float(pixel.y) * frame.rayStepY.xyz;
    precise vec3 inPerspective = frame.eye.xyz + ray * viewDistance(depth);
    precise vec3 inParallel = frame.eye.xyz + ray + frame.cameraForward.xyz * viewDistance(depth);
    return isOrthographic() ? inParallel : inPerspective;
}

// A vector from a surface towards the eye, of any length over 0.
vec3 wayToEye(vec3 position) { return isOrthographic() ? -frame.cameraForward.xyz : frame.eye.xyz - position; }

vec3 workingFromRec709(vec3 color) {
    return frame.workingFromRed.xyz * color.r + frame.workingFromGreen.xyz * color.g + frame.workingFromBlue.xyz * color.b;
}
