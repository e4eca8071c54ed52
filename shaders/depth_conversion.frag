// Copies the depth of a host's or of candela's own surfaces from one scale to another, and a host's radiance with it: lib/render/host.

#include "shared/bindings.h"

#if DEPTH == 1
layout(binding = DEPTH_UNIT) uniform sampler2D sourceDepth;
// Near plane; near / far plane, 0 without one; 1 - that. Orthographic: near plane; far plane; far - near plane. w: 1 where depth is
// reversed.
layout(location = DEPTH_FROM_LOCATION) uniform vec4 from;
layout(location = DEPTH_TO_LOCATION) uniform vec4 to;
#endif
#if RADIANCE == 1
layout(binding = RADIANCE_UNIT) uniform sampler2D hostRadiance;
layout(location = 0) out vec4 radiance;
#endif
// Lower left corner in the target; 1 of an orthographic view; 1 where both scales have the same planes.
layout(location = DEPTH_PLACE_LOCATION) uniform ivec4 place;

#if DEPTH == 1
bool isOrthographic() {
    return place.z != 0;
}

// `precise`: radiance is copied where a second pass computes the depth of the first one.
float distanceAt(float reversedDepth) {
    precise float orthographic = from.y - reversedDepth * from.z;
    precise float perspective = from.x / (reversedDepth * from.z + from.y);
    return isOrthographic() ? orthographic : perspective;
}

float reversedDepthAt(float distance) {
    precise float orthographic = (to.y - distance) / to.z;
    precise float perspective = (to.x / distance - to.y) / to.z;
    return isOrthographic() ? orthographic : perspective;
}

float converted(float depth) {
    float reversedDepth = from.w != 0.0 ? depth : 1.0 - depth;
    if (reversedDepth <= 0.0 || place.w != 0) return clamp(reversedDepth, 0.0, 1.0);
    return clamp(reversedDepthAt(distanceAt(reversedDepth)), 0.0, 1.0);
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - place.xy;
#if DEPTH == 1
    float depth = converted(texelFetch(sourceDepth, pixel, 0).x);
    gl_FragDepth = to.w != 0.0 ? depth : 1.0 - depth;
#endif
#if RADIANCE == 1
    radiance = vec4(texelFetch(hostRadiance, pixel, 0).rgb, 0.0);
#endif
}
