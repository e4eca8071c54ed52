// Adds the light of the environment to every surface that light falls on. VISIBILITY is defined where a texture tells how much of the
// environment each pixel sees.

#include "lib/lighting.glsl"
#include "lib/environment.glsl"
#ifdef LOBES
#include "shared/extended_environment.h"
#endif

layout(location = ENVIRONMENT_PARTS_LOCATION) uniform vec2 parts;  // factors on diffuse and specular reflection

#ifdef VISIBILITY
layout(binding = ENVIRONMENT_VISIBILITY_UNIT) uniform sampler2D visibilityTexture;
#endif

layout(location = 0) out vec4 radiance;

float visibilityOf(ivec2 at) {
#ifdef VISIBILITY
    return texelFetch(visibilityTexture, at, 0).r;
#else
    return 1.0;
#endif
}

// Of a lobe, 0 to 1.
float lobeVisibility(ShadingPoint lobe, float visibility) {
#ifdef VISIBILITY
    return specularVisibility(lobe, visibility);
#else
    return 1.0;
#endif
}

vec3 gathered(ShadingPoint lobe) {
    return radianceAt(inPicture(environmentAxes(), specularDirection(lobe)), environmentLevel(lobe));
}

#ifdef LOBES
vec3 reflectedByLobes(ExtendedPoint point, float visibility) {
    ShadingPoint base = baseInEnvironment(point), sheen = sheenInEnvironment(point);
    GatheredLight light;
    light.irradiance = irradianceAt(inPicture(environmentAxes(), point.base.normal)) * (visibility * parts.x);
    light.irradianceBehind = irradianceAt(inPicture(environmentAxes(), -point.base.normal)) * (visibility * parts.x);
    light.base = gathered(base) * (lobeVisibility(base, visibility) * parts.y);
    light.coat = gathered(point.coat) * (lobeVisibility(point.coat, visibility) * parts.y);
    light.sheen = gathered(sheen) * (lobeVisibility(sheen, visibility) * parts.y);
    return extendedEnvironmentRadiance(point, light) * environmentIntensity();
}
#endif

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    PixelSurface pixel = fetchSurface(at);
    if (!pixel.lit) discard;
    Receiver receiver = receiverAt(at, pixel);
    ShadingPoint point = receiver.point;
    float visibility = visibilityOf(at);
#ifdef LOBES
    if (pixel.extended) {
        radiance = vec4(reflectedByLobes(receiver.lobes, visibility), 0.0);
        return;
    }
#endif
    vec2 visible = vec2(visibility, lobeVisibility(point, visibility)) * (parts * environmentIntensity());
    vec3 irradiance = irradianceAt(inPicture(environmentAxes(), point.normal));
    vec3 reflected = gathered(point);
    radiance = vec4(environmentRadiance(point, irradiance * visible.x, reflected * visible.y), 0.0);
}
