// A line over the picture, where the frame's surface does not hide it.

#include "lib/frame.glsl"

layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;
layout(location = LINE_COLOR_LOCATION) uniform vec3 lineColor;

layout(location = 0) out vec4 code;

// A surface nearer than the line by less than this share of its distance does not hide it: the depths of a line and of the surface it
// lies on are rounded apart.
const float DEPTH_SHARE = 5.0e-4;

bool isInside(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, frame.size.xy)); }

float depthAt(ivec2 pixel) { return texelFetch(depthTexture, pixel, 0).x; }

// How the depth changes from a pixel to the next one on one side, and from there to the one after; 0 outside of the picture.
vec2 changes(ivec2 pixel, float depth, ivec2 side) {
    if (!isInside(pixel + side)) return vec2(0.0);
    float next = depthAt(pixel + side), change = abs(next - depth);
    return vec2(change, isInside(pixel + 2 * side) ? abs(depthAt(pixel + 2 * side) - next) : change);
}

// By how much the depth changes over a pixel along the surfaces at and beside this one. Of two changes the lesser counts, as the greater
// may be a leap from one surface to another behind it; but the greater side does: in a valley the line lies behind the pixels of both
// faces.
float slope(ivec2 pixel, float depth, ivec2 axis) {
    vec2 before = changes(pixel, depth, -axis), after = changes(pixel, depth, axis);
    return max(min(before.x, after.x), max(min(before.x, before.y), min(after.x, after.y)));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = depthAt(pixel);
    // A line passes the pixel's centre at up to half a pixel along each axis, and ends are rounded to parts of a pixel.
    float bias = depth * DEPTH_SHARE + 0.6 * (slope(pixel, depth, ivec2(1, 0)) + slope(pixel, depth, ivec2(0, 1)));
    if (gl_FragCoord.z < depth - bias) discard;
    code = vec4(lineColor, 1.0);
}
