// A pixel of a line, unless the frame's surface occludes it.

#include "lib/frame.glsl"

layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;
layout(location = LINE_COLOR_LOCATION) uniform vec3 lineColor;

layout(location = 0) out vec4 code;

// A surface nearer than the line by less than this share of its distance does not occlude it: the depths of a line and of the surface it
// lies on are rounded differently.
const float DEPTH_SHARE = 5.0e-4;

bool isInside(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, frame.size.xy));
}

float depthAt(ivec2 pixel) {
    return texelFetch(depthTexture, pixel, 0).x;
}

// The change of depth from a pixel to its neighbour on one side, and from there to the next; 0 outside the picture.
vec2 changes(ivec2 pixel, float depth, ivec2 side) {
    if (!isInside(pixel + side)) return vec2(0.0);
    float next = depthAt(pixel + side), change = abs(next - depth);
    return vec2(change, isInside(pixel + 2 * side) ? abs(depthAt(pixel + 2 * side) - next) : change);
}

// The change of depth over one pixel along the surfaces at and beside this one. Of two consecutive changes the smaller counts, because
// the larger may be a step to another surface behind; of the two sides the larger counts, because in a valley the line lies behind the
// pixels of both faces.
float slope(ivec2 pixel, float depth, ivec2 axis) {
    vec2 before = changes(pixel, depth, -axis), after = changes(pixel, depth, axis);
    return max(min(before.x, after.x), max(min(before.x, before.y), min(after.x, after.y)));
}

// What rounding needs: the share of the distance, or in an orthographic view a share of a pixel's height.
float depthTolerance(float depth) {
    if (isOrthographic()) return 0.05 * length(frame.rayStepY.xyz) / frame.depthRange.z;
    return (depth + frame.depthRange.x / frame.depthRange.y) * DEPTH_SHARE;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = depthAt(pixel);
    // A line passes within half a pixel of the pixel's centre along each axis, and its end points are rounded to subpixels.
    float bias = depthTolerance(depth) + 0.6 * (slope(pixel, depth, ivec2(1, 0)) + slope(pixel, depth, ivec2(0, 1)));
    if (gl_FragCoord.z < depth - bias) discard;
    code = vec4(lineColor, 1.0);
}
