// Where an instance stands: the records that GpuScene uploads for each node that shows a mesh.

#include "shared/bindings.h"

layout(binding = INSTANCES_UNIT) uniform samplerBuffer instanceRecords;

vec3 instancePosition(uint instance, vec3 position) {
    int first = int(instance) * INSTANCE_TEXELS;
    vec4 p = vec4(position, 1.0);
    return vec3(dot(texelFetch(instanceRecords, first), p), dot(texelFetch(instanceRecords, first + 1), p),
                dot(texelFetch(instanceRecords, first + 2), p));
}

// A direction that moves with the surface, such as a tangent.
vec3 instanceDirection(uint instance, vec3 direction) {
    int first = int(instance) * INSTANCE_TEXELS;
    return vec3(dot(texelFetch(instanceRecords, first).xyz, direction), dot(texelFetch(instanceRecords, first + 1).xyz, direction),
                dot(texelFetch(instanceRecords, first + 2).xyz, direction));
}

// A normal, by the cofactor matrix: right under any scale, mirrored or not. Not of unit length.
vec3 instanceNormal(uint instance, vec3 normal) {
    int first = int(instance) * INSTANCE_TEXELS + 3;
    return vec3(dot(texelFetch(instanceRecords, first).xyz, normal), dot(texelFetch(instanceRecords, first + 1).xyz, normal),
                dot(texelFetch(instanceRecords, first + 2).xyz, normal));
}
