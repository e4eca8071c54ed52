// The bounding volume of a light: a polyhedron around the sphere of its range.

#include "lib/frame.glsl"

layout(binding = LIGHTS_UNIT) uniform samplerBuffer lightRecords;
layout(binding = CONES_UNIT) uniform samplerBuffer coneRecords;

layout(location = POSITION_ATTRIBUTE) in vec3 vertex;  // of a polyhedron that holds the unit sphere
layout(location = LIGHT_ATTRIBUTE) in uint lightIndex;

layout(location = 0) flat out vec4 lightPlace;
layout(location = 1) flat out vec4 lightIntensity;
layout(location = 2) flat out vec4 lightCone;

void main() {
    int index = int(lightIndex);
    lightPlace = texelFetch(lightRecords, index * LIGHT_TEXELS);
    lightIntensity = texelFetch(lightRecords, index * LIGHT_TEXELS + 1);
    lightCone = texelFetch(coneRecords, max(index - frame.lightCounts.x, 0));
    float range = inversesqrt(lightPlace.w);
    gl_Position = frame.clipFromWorld * vec4(lightPlace.xyz + vertex * range, 1.0);
}
