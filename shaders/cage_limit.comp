// Applies a stencil table to the points of a cage: one invocation a vertex of the limit surface. The CPU's counterpart is evaluateLimit
// (candela/refined_cage.h). Points are dispatched first, then seam vertices, which copy the positions of their points.

#include "shared/bindings.h"

layout(local_size_x = 64) in;

layout(std430, binding = LIMIT_OFFSETS_STORAGE) readonly buffer Offsets {
    uint offsets[];
};  // first entry of each stencil, and the end of the last; then the points of seam vertices
layout(std430, binding = LIMIT_ENTRIES_STORAGE) readonly buffer Entries {
    uvec4 entries[];
};  // control index; weights of value, du, dv
layout(std430, binding = LIMIT_POINTS_STORAGE) readonly buffer Points {
    float points[];
};
layout(std430, binding = LIMIT_SURFACE_STORAGE) buffer Surface {
    float surface[];
};  // all positions, then all normals
layout(std430, binding = LIMIT_UVS_STORAGE) readonly buffer Uvs {
    vec4 uvDerivatives[];
};
layout(std430, binding = LIMIT_TANGENTS_STORAGE) writeonly buffer Tangents {
    vec4 tangents[];
};

layout(location = LIMIT_RANGE_LOCATION) uniform uvec4 range;
layout(location = LIMIT_TANGENTS_LOCATION) uniform bool needsTangents;

// Scaled to a largest component of 1, so that products neither overflow nor vanish; (0, 0, 0) stays.
vec3 scaledToOne(vec3 v) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    return largest > 0.0 && !isinf(largest) ? v / largest : vec3(0.0);
}

vec3 unitOrZero(vec3 v) {
    vec3 scaled = scaledToOne(v);
    return scaled == vec3(0.0) ? scaled : normalize(scaled);
}

vec3 anyPerpendicular(vec3 axis) {
    vec3 size = abs(axis);
    vec3 other = vec3(0.0, 0.0, 1.0);
    if (size.x <= size.y && size.x <= size.z) {
        other = vec3(1.0, 0.0, 0.0);
    } else if (size.y <= size.z) {
        other = vec3(0.0, 1.0, 0.0);
    }
    return normalize(other - axis * dot(axis, other));
}

// The CPU's counterpart is limitTangent in lib/render/subdivision/evaluator_backend.cpp.
vec4 limitTangent(vec3 normal, vec3 du, vec3 dv, vec4 uv) {
    float area = uv.x * uv.w - uv.y * uv.z;
    vec3 alongU = (du * uv.w - dv * uv.y) * (area < 0.0 ? -1.0 : 1.0);
    vec3 inPlane = unitOrZero(alongU - normal * dot(normal, alongU));
    if (area == 0.0 || inPlane == vec3(0.0)) return vec4(anyPerpendicular(normal), 1.0);
    return vec4(inPlane, area < 0.0 ? 1.0 : -1.0);
}

vec3 readSurface(uint at) {
    return vec3(surface[at], surface[at + 1u], surface[at + 2u]);
}

void writeSurface(uint at, vec3 value) {
    surface[at] = value.x;
    surface[at + 1u] = value.y;
    surface[at + 2u] = value.z;
}

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint vertex = range.x + group * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
    if (vertex >= range.y) return;
    vec3 position = vec3(0.0), du = vec3(0.0), dv = vec3(0.0);
    for (uint i = offsets[vertex]; i < offsets[vertex + 1u]; ++i) {
        uvec4 entry = entries[i];
        uint at = 3u * entry.x;
        vec3 point = vec3(points[at], points[at + 1u], points[at + 2u]), weights = uintBitsToFloat(entry.yzw);
        position += point * weights.x;
        du += point * weights.y;
        dv += point * weights.z;
    }
    uint pointCount = range.z, vertexCount = range.w;
    if (vertex >= pointCount) position = readSurface(3u * offsets[vertexCount + 1u + vertex - pointCount]);
    vec3 normal = unitOrZero(cross(scaledToOne(du), scaledToOne(dv)));
    writeSurface(3u * vertex, position);
    writeSurface(3u * (vertexCount + vertex), normal);
    if (needsTangents) tangents[vertex] = limitTangent(normal, du, dv, uvDerivatives[vertex]);
}
