// Adds the light of the environment to every surface that light falls on. VISIBILITY is defined where a texture tells how much of the
// environment each pixel sees.

#include "lib/lighting.glsl"
#include "lib/environment.glsl"

layout(location = ENVIRONMENT_PARTS_LOCATION) uniform vec2 parts;  // factors on diffuse and specular reflection

#ifdef VISIBILITY
layout(binding = ENVIRONMENT_VISIBILITY_UNIT) uniform sampler2D visibilityTexture;
#endif

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    PixelSurface pixel = fetchSurface(at);
    if (!pixel.lit) discard;
    ShadingPoint point = receiverAt(at, pixel).point;
    vec2 visible = vec2(1.0);
#ifdef VISIBILITY
    visible.x = texelFetch(visibilityTexture, at, 0).r;
    visible.y = specularVisibility(point, visible.x);
#endif
    visible *= parts * environmentIntensity();
    vec3 irradiance = irradianceAt(inPicture(environmentAxes(), point.normal));
    vec3 reflected = radianceAt(inPicture(environmentAxes(), specularDirection(point)), environmentLevel(point));
    radiance = vec4(environmentRadiance(point, irradiance * visible.x, reflected * visible.y), 0.0);
}
