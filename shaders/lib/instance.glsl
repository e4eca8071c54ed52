// Instance records: the transforms that GpuScene uploads for each instance of a mesh or cage.

#include "shared/bindings.h"

layout(binding = INSTANCES_UNIT) uniform samplerBuffer instanceRecords;

vec3 instancePosition(uint instance, vec3 position) {
    int first = int(instance) * INSTANCE_TEXELS;
    vec4 p = vec4(position, 1.0);
    return vec3(dot(texelFetch(instanceRecords, first), p), dot(texelFetch(instanceRecords, first + 1), p),
                dot(texelFetch(instanceRecords, first + 2), p));
}

// Transforms a direction along the surface, such as a tangent.
vec3 instanceDirection(uint instance, vec3 direction) {
    int first = int(instance) * INSTANCE_TEXELS;
    return vec3(dot(texelFetch(instanceRecords, first).xyz, direction), dot(texelFetch(instanceRecords, first + 1).xyz, direction),
                dot(texelFetch(instanceRecords, first + 2).xyz, direction));
}

// The mean of the instance's scale along the axes: that of a cube of the same volume.
float meanScale(uint instance) {
    int first = int(instance) * INSTANCE_TEXELS;
    vec3 x = texelFetch(instanceRecords, first).xyz, y = texelFetch(instanceRecords, first + 1).xyz, z = texelFetch(instanceRecords, first + 2).xyz;
    return pow(abs(dot(x, cross(y, z))), 1.0 / 3.0);
}

// 1, or -1 where the instance is mirrored, which negates cross products of transformed directions.
float instanceHandedness(uint instance) {
    return texelFetch(instanceRecords, int(instance) * INSTANCE_TEXELS + 3).w;
}

// Normalised; zero for a vector of length zero, such as the normal of an instance that is flattened along it.
vec3 unitOrZero(vec3 v) {
    float length2 = dot(v, v);
    return length2 > 0.0 ? v * inversesqrt(length2) : vec3(0.0);
}

// Transforms a normal by the cofactor matrix, which is correct for any scale and for mirroring. Not normalised.
vec3 instanceNormal(uint instance, vec3 normal) {
    int first = int(instance) * INSTANCE_TEXELS + 3;
    return vec3(dot(texelFetch(instanceRecords, first).xyz, normal), dot(texelFetch(instanceRecords, first + 1).xyz, normal),
                dot(texelFetch(instanceRecords, first + 2).xyz, normal));
}
