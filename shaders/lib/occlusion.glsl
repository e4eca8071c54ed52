// Occlusion rays through the trees of lib/render/occlusion/gpu_occlusion.cpp.

#include "shared/bindings.h"

layout(binding = OCCLUSION_NODES_UNIT) uniform usamplerBuffer occlusionNodes;
layout(binding = OCCLUSION_TRIANGLES_UNIT) uniform usamplerBuffer occlusionTriangles;
layout(binding = OCCLUSION_INSTANCES_UNIT) uniform usamplerBuffer occlusionInstances;
layout(binding = OCCLUSION_CUTOUTS_UNIT) uniform usamplerBuffer occlusionCutouts;
layout(binding = OCCLUSION_ALPHAS_UNIT) uniform usamplerBuffer occlusionAlphas;

#define SHARED_FUNCTION
// The first word of an image.
#define AlphaTexels int

float alphaTexel(int firstWord, int index) {
    uint word = texelFetch(occlusionAlphas, firstWord + (index >> 2)).x;
    return float(word >> (8 * (index & 3)) & 255u) / 255.0;
}

#include "shared/alpha_cutout.h"

// A ray in the space of a tree, prepared for boxes and triangles. The triangle test is that of Woop, Benthin, Wald, "Watertight ray/triangle
// intersection", JCGT 2(1), 2013: coordinates are permuted so that the way's largest component is z, and sheared so that it is the only one.
struct OcclusionRay {
    vec3 from;
    vec3 inverse;    // 1 / way
    bvec3 backwards; // way < 0
    int axis;        // the way's largest component
    vec3 shear;
};

vec3 permuted(OcclusionRay ray, vec3 v) {
    return ray.axis == 0 ? v.yzx : ray.axis == 1 ? v.zxy : v;
}

OcclusionRay occlusionRay(vec3 from, vec3 way) {
    OcclusionRay ray;
    ray.from = from;
    ray.backwards = lessThan(way, vec3(0.0));
    vec3 size = abs(way);
    // Far below what single precision resolves: a component of 0 would make 0 times infinity.
    vec3 kept = max(size, max(1.0e-12 * max(max(size.x, size.y), size.z), 1.0e-30));
    ray.inverse = mix(1.0 / kept, -1.0 / kept, ray.backwards);
    ray.axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    vec3 inverse = permuted(ray, ray.inverse), along = permuted(ray, way);
    ray.shear = vec3(along.xy * inverse.z, inverse.z);
    return ray;
}

// ---- Boxes

// Where the ray crosses sides of four boxes: `codes` has 8 bits a side.
vec4 crossings(uint codes, float origin, float side, float from, float inverse) {
    precise vec4 place = origin + vec4(uvec4(codes, codes >> 8, codes >> 16, codes >> 24) & 255u) * side;
    precise vec4 t = (place - from) * inverse;
    return t;
}

// A bit for each of four boxes that the ray meets; `near` and `far` have the sides that it enters and leaves by.
uint meetsBoxes(OcclusionRay ray, vec3 origin, vec3 side, uvec3 near, uvec3 far, float tMin, float tMax) {
    vec4 enter = max(max(crossings(near.x, origin.x, side.x, ray.from.x, ray.inverse.x), vec4(tMin)),
                     max(crossings(near.y, origin.y, side.y, ray.from.y, ray.inverse.y),
                         crossings(near.z, origin.z, side.z, ray.from.z, ray.inverse.z)));
    vec4 leave = min(min(crossings(far.x, origin.x, side.x, ray.from.x, ray.inverse.x), vec4(tMax)),
                     min(crossings(far.y, origin.y, side.y, ray.from.y, ray.inverse.y),
                         crossings(far.z, origin.z, side.z, ray.from.z, ray.inverse.z)));
    // Each crossing has three roundings. Ize, "Robust BVH ray traversal", JCGT 2(2), 2013.
    const float margin = 1.0 + 1.0e-6;
    uvec4 meets = uvec4(lessThanEqual(enter, leave * margin));
    return meets.x | meets.y << 1 | meets.z << 2 | meets.w << 3;
}

// The node in the upper 24 bits, and in the lower 8 a bit for each child whose box the ray meets.
uint meetsChildren(OcclusionRay ray, uint node, float tMin, float tMax) {
    int texel = int(node) * OCCLUSION_NODE_TEXELS;
    uvec4 header = texelFetch(occlusionNodes, texel);
    vec3 origin = uintBitsToFloat(header.xyz);
    vec3 side = uintBitsToFloat((uvec3(header.w, header.w >> 8, header.w >> 16) & 255u) << 23);
    uvec4 x = texelFetch(occlusionNodes, texel + 1);
    uvec4 y = texelFetch(occlusionNodes, texel + 2);
    uvec4 z = texelFetch(occlusionNodes, texel + 3);
    if (ray.backwards.x) x = x.zwxy;
    if (ray.backwards.y) y = y.zwxy;
    if (ray.backwards.z) z = z.zwxy;
    uint meets = meetsBoxes(ray, origin, side, uvec3(x.x, y.x, z.x), uvec3(x.z, y.z, z.z), tMin, tMax) |
                 meetsBoxes(ray, origin, side, uvec3(x.y, y.y, z.y), uvec3(x.w, y.w, z.w), tMin, tMax) << 4;
    return node << 8 | (meets & header.w >> 24);
}

uint childOf(uint node, int lane) {
    return texelFetch(occlusionNodes, int(node) * OCCLUSION_NODE_TEXELS + 4 + (lane >> 2))[lane & 3];
}

// ---- Triangles

float cutoutTransmittance(uint cutout, vec3 weights) {
    int texel = int(cutout) * OCCLUSION_CUTOUT_TEXELS;
    vec4 first = uintBitsToFloat(texelFetch(occlusionCutouts, texel));
    vec4 second = uintBitsToFloat(texelFetch(occlusionCutouts, texel + 1));
    vec4 third = uintBitsToFloat(texelFetch(occlusionCutouts, texel + 2));
    uvec4 image = texelFetch(occlusionCutouts, texel + 3);
    float alpha = weights.x * second.z + weights.y * second.w + weights.z * third.x;
    if (image.x != OCCLUSION_NONE) {
        vec2 uv = weights.x * first.xy + weights.y * first.zw + weights.z * second.xy;
        AlphaSampling sampling = AlphaSampling(int(image.y), int(image.z), image.w & 3u, image.w >> OCCLUSION_WRAP_T_SHIFT & 3u,
                                               (image.w & OCCLUSION_NEAREST) != 0u);
        alpha *= sampleAlpha(int(image.x), sampling, uv);
    }
    return alphaTransmittance(alpha, third.y, (image.w & OCCLUSION_BLENDS) != 0u, third.z);
}

vec3 sheared(OcclusionRay ray, uvec4 corner) {
    precise vec3 p = permuted(ray, uintBitsToFloat(corner.xyz) - ray.from);
    precise vec2 q = p.xy - ray.shear.xy * p.z;
    return vec3(q, p.z * ray.shear.z);
}

// The products are rounded before the difference, so that two triangles get opposite numbers for the edge that they share.
float edgeFunction(vec3 a, vec3 b) {
    precise float first = a.x * b.y;
    precise float second = a.y * b.x;
    precise float difference = first - second;
    return difference;
}

// The share of the ray that passes: 1 where it misses the triangle.
float triangleTransmittance(OcclusionRay ray, uint triangle, float tMin, float tMax) {
    int texel = int(triangle) * OCCLUSION_TRIANGLE_TEXELS;
    uvec4 first = texelFetch(occlusionTriangles, texel);
    vec3 a = sheared(ray, first);
    vec3 b = sheared(ray, texelFetch(occlusionTriangles, texel + 1));
    vec3 c = sheared(ray, texelFetch(occlusionTriangles, texel + 2));
    vec3 edges = vec3(edgeFunction(c, b), edgeFunction(a, c), edgeFunction(b, a));
    bool outside = any(lessThan(edges, vec3(0.0))) && any(greaterThan(edges, vec3(0.0)));
    float area = edges.x + edges.y + edges.z;
    float t = dot(edges, vec3(a.z, b.z, c.z)) / area;
    // An area of 0 makes t infinite or not a number.
    if (outside || area == 0.0 || !(t > tMin && t < tMax)) return 1.0;
    return first.w == OCCLUSION_NONE ? 0.0 : cutoutTransmittance(first.w, edges / area);
}

float leafTransmittance(OcclusionRay ray, uint leaf, float tMin, float tMax) {
    uint triangle = leaf & OCCLUSION_LEAF_FIRST_MASK;
    uint end = triangle + (leaf >> OCCLUSION_LEAF_COUNT_SHIFT & 7u) + 1u;
    float passing = 1.0;
    for (; triangle < end && passing > 0.0; ++triangle) passing *= triangleTransmittance(ray, triangle, tMin, tMax);
    return passing;
}

// ---- The walk

// The share of light that passes along the ray from + t way, for t between tMin and tMax: 0 where it meets an opaque triangle, of either side,
// and the product of 1 - alpha over the blended ones that it meets. tMin is 0 or more; the way has any length over 0. A ray through the edge
// that two triangles of a mesh share meets one of them at least.
float transmittance(vec3 from, vec3 way, float tMin, float tMax) {
    uint root = texelFetch(occlusionInstances, 0).x;
    if (root == OCCLUSION_NONE) return 1.0;
    float passing = 1.0;
    OcclusionRay ray = occlusionRay(from, way);
    // Nodes with children that are still to be visited, as meetsChildren returns them: one a level of both trees at most.
    uint stack[2 * OCCLUSION_MAX_DEPTH];
    int height = 0;
    int instanceHeight = -1;  // the stack's height where the ray has entered an instance
    uint open = meetsChildren(ray, root, tMin, tMax);
    while (true) {
        if ((open & 255u) == 0u) {
            if (height == 0) return passing;
            if (height == instanceHeight) {
                ray = occlusionRay(from, way);
                instanceHeight = -1;
            }
            open = stack[--height];
            continue;
        }
        uint child = childOf(open >> 8, findLSB(open & 255u));
        open &= open - 1u;  // the lowest bit is that child
        bool isLeaf = (child & OCCLUSION_LEAF) != 0u;
        if (isLeaf && instanceHeight >= 0) {
            passing *= leafTransmittance(ray, child, tMin, tMax);
            if (passing == 0.0) return 0.0;
            continue;
        }
        uint node = child;
        if (isLeaf) {
            int texel = (1 + int(child & OCCLUSION_LEAF_FIRST_MASK)) * OCCLUSION_INSTANCE_TEXELS;
            node = texelFetch(occlusionInstances, texel + 3).x;
            if (node == OCCLUSION_NONE) continue;
            vec4 x = uintBitsToFloat(texelFetch(occlusionInstances, texel));
            vec4 y = uintBitsToFloat(texelFetch(occlusionInstances, texel + 1));
            vec4 z = uintBitsToFloat(texelFetch(occlusionInstances, texel + 2));
            vec3 d = from - vec3(x.w, y.w, z.w);
            ray = occlusionRay(vec3(dot(x.xyz, d), dot(y.xyz, d), dot(z.xyz, d)), vec3(dot(x.xyz, way), dot(y.xyz, way), dot(z.xyz, way)));
        }
        if (isLeaf || (open & 255u) != 0u) stack[height++] = open;
        if (isLeaf) instanceHeight = height;
        open = meetsChildren(ray, node, tMin, tMax);
    }
    return passing;
}
