// Occlusion rays between a pixel and lights, in frames with shadows.

#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
#include "lib/occlusion.glsl"
#include "shared/shadow_ray.h"

layout(binding = SHADOW_UNIT) uniform usampler2D shadowTexture;

// Farther than any surface.
const float SHADOW_INFINITY = 1.0e30;

// The side of a pixel at a surface, metres.
float pixelExtent(vec3 position) {
    float side = length(frame.rayStepY.xyz);
    return isOrthographic() ? side : dot(position - frame.eye.xyz, frame.cameraForward.xyz) * side;
}

// Where the rays of a pixel end.
struct RayEnds {
    vec3 inFront;
    vec3 behind;  // of lights behind the surface, through which light passes
    vec3 geometricNormal;
};

// Of a pixel whose surface is at `position`.
RayEnds rayEndsAt(ivec2 pixel, vec3 position) {
    ShadowSurface surface = unpackShadowWord(texelFetch(shadowTexture, pixel, 0).x);
    RayEnds ends;
    ends.inFront = shadowRayEnd(position, wayToEye(position), surface.geometricNormal, surface.lift, pixelExtent(position));
    ends.behind = shadowRayEndBehind(position, wayToEye(position), surface.geometricNormal, pixelExtent(position));
    ends.geometricNormal = surface.geometricNormal;
    return ends;
}

// What passes whole is the same bit for bit as without shadows.
vec3 dimmed(vec3 radiance, float passing) {
    return passing < 1.0 ? radiance * passing : radiance;
}

// What passes of the light of a point or spot light, 0 to 1.
float transmittanceFromPoint(vec3 rayEnd, vec3 lightPosition) {
    vec3 way = rayEnd - lightPosition;
    return transmittance(lightPosition, way, shadowRayStart(lightPosition, way), 1.0);
}

// Of a directional light, to which `l` points.
float transmittanceFromDirection(vec3 rayEnd, vec3 l) {
    return transmittance(rayEnd, l, 0.0, SHADOW_INFINITY);
}
