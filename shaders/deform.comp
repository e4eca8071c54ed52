// Deforms the vertices of a mesh: one invocation a vertex, one work group a block. The CPU's counterpart, with the formats of the buffers,
// is lib/render/deformation/deform_kernel_code.h. Sources: glTF 2.0, 3.7.2.2 (morph targets) and 3.7.3.3 (skins).

#include "shared/bindings.h"

layout(local_size_x = 64) in;

layout(std430, binding = DEFORM_REST_STORAGE) readonly buffer Rest {
    float rest[];
};
layout(std430, binding = DEFORM_RUNS_STORAGE) readonly buffer Runs {
    uint runs[];
};  // of each run of 8 vertices the first element of influences, and the end of the last
layout(std430, binding = DEFORM_INFLUENCES_STORAGE) readonly buffer Influences {
    uint influences[];
};  // 9 words an element: a joint, its weights for the vertices of the run
layout(std430, binding = DEFORM_ROWS_STORAGE) readonly buffer Rows {
    uint rows[];
};
layout(std430, binding = DEFORM_ENTRIES_STORAGE) readonly buffer Entries {
    uint entries[];
};  // 10 words an entry: target, position, normal, tangent
layout(std430, binding = DEFORM_POSES_STORAGE) readonly buffer Poses {
    float poses[];
};  // rows of the joints' matrices, morph weights
layout(std430, binding = DEFORM_SURFACE_STORAGE) writeonly buffer Surface {
    float surface[];
};
layout(std430, binding = DEFORM_TANGENTS_STORAGE) writeonly buffer Tangents {
    vec4 tangents[];
};

layout(location = DEFORM_POSE_LOCATION) uniform uvec4 pose;
layout(location = DEFORM_SCALE_LOCATION) uniform float directionScale;

struct Vertex {
    vec3 position, normal;
    vec4 tangent;
};

uint blockIndex() {
    return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
}

float restColumn(uint column) {
    uint width = pose.w != 0u ? 10u : 6u;
    return rest[(blockIndex() * width + column) * gl_WorkGroupSize.x + gl_LocalInvocationIndex];
}

vec3 restVector(uint column) {
    return vec3(restColumn(column), restColumn(column + 1u), restColumn(column + 2u));
}

vec3 entryVector(uint at) {
    return vec3(uintBitsToFloat(entries[at]), uintBitsToFloat(entries[at + 1u]), uintBitsToFloat(entries[at + 2u]));
}

void addMorphTargets(uint vertex, inout Vertex v) {
    for (uint i = rows[vertex]; i < rows[vertex + 1u]; ++i) {
        float weight = poses[pose.z + entries[10u * i]];
        v.position += weight * entryVector(10u * i + 1u);
        v.normal += weight * entryVector(10u * i + 4u);
        v.tangent.xyz += weight * entryVector(10u * i + 7u);
    }
}

vec4 poseRow(uint at) {
    return vec4(poses[at], poses[at + 1u], poses[at + 2u], poses[at + 3u]);
}

void writeVector(uint at, vec3 value) {
    surface[at] = value.x;
    surface[at + 1u] = value.y;
    surface[at + 2u] = value.z;
}

// Of unit length, or zero where the vector has hardly any.
vec3 unitOrZero(vec3 v) {
    float length2 = dot(v, v);
    return length2 > 1e-30 ? v * inversesqrt(length2) : vec3(0.0);
}

void main() {
    uint vertex = blockIndex() * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
    if (vertex >= pose.x) return;
    Vertex v = Vertex(restVector(0u), restVector(3u), vec4(0.0));
    if (pose.w != 0u) v.tangent = vec4(restVector(6u), restColumn(9u));
    if (pose.z != DEFORM_NONE) addMorphTargets(vertex, v);
    vec4 x = vec4(1.0, 0.0, 0.0, 0.0), y = vec4(0.0, 1.0, 0.0, 0.0), z = vec4(0.0, 0.0, 1.0, 0.0);
    if (pose.y != DEFORM_NONE) {
        x = y = z = vec4(0.0);
        uint run = vertex / 8u, lane = vertex % 8u;
        for (uint i = runs[run]; i < runs[run + 1u]; ++i) {
            uint row = pose.y + 12u * influences[9u * i];
            float weight = uintBitsToFloat(influences[9u * i + 1u + lane]);
            x += weight * poseRow(row);
            y += weight * poseRow(row + 4u);
            z += weight * poseRow(row + 8u);
        }
    }
    vec4 position = vec4(v.position, 1.0);
    writeVector(6u * vertex, vec3(dot(x, position), dot(y, position), dot(z, position)));
    // The rows of the cofactor matrix: det(M) times the inverse transpose.
    vec3 yz = cross(y.xyz, z.xyz),
         cofactor = vec3(dot(yz, v.normal), dot(cross(z.xyz, x.xyz), v.normal), dot(cross(x.xyz, y.xyz), v.normal));
    float side = dot(x.xyz, yz) < 0.0 ? -1.0 : 1.0;
    writeVector(6u * vertex + 3u, side * unitOrZero(cofactor * (directionScale * directionScale)));
    if (pose.w == 0u) return;
    vec3 tangent = vec3(dot(x.xyz, v.tangent.xyz), dot(y.xyz, v.tangent.xyz), dot(z.xyz, v.tangent.xyz));
    tangents[vertex] = vec4(unitOrZero(tangent * directionScale), v.tangent.w * side);
}
