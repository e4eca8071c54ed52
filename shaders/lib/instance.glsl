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

// 1, or -1 where the instance is mirrored: cross products of what it carries along change their sign there.
float instanceHandedness(uint instance) {
    return texelFetch(instanceRecords, int(instance) * INSTANCE_TEXELS + 3).w;
}

// Of unit length, or zero where the vector has none, as a normal in the plane to which an instance is flattened.
vec3 unitOrZero(vec3 v) {
    float length2 = dot(v, v);
    return length2 > 0.0 ? v * inversesqrt(length2) : vec3(0.0);
}

// A normal, by the cofactor matrix: right under any scale, mirrored or not. Not of unit length.
vec3 instanceNormal(uint instance, vec3 normal) {
    int first = int(instance) * INSTANCE_TEXELS + 3;
    return vec3(dot(texelFetch(instanceRecords, first).xyz, normal), dot(texelFetch(instanceRecords, first + 1).xyz, normal),
                dot(texelFetch(instanceRecords, first + 2).xyz, normal));
}
