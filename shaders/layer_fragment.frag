// The fragments of transparent surfaces that cover anything: USE 0 makes lists of the depths at each pixel, USE 1 finds the layers of each
// draw, USE 2 tells surfaces apart that share the depth of a layer. The depth test leaves what lies in front of the opaque surfaces, and for
// USE 2 at the depth of the layer.

layout(early_fragment_tests) in;

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"

layout(binding = BASE_COLOR_UNIT) uniform sampler2D baseColorTexture;

layout(location = 0) in vec4 uvs;
layout(location = 1) in float vertexAlpha;
layout(location = 2) flat in uvec2 surface;  // material, number of the draw

#include "lib/texture_coordinates.glsl"
#include "lib/layer_surface.glsl"

#if USE == 1
layout(binding = LAYER_DEPTHS_UNIT) uniform usampler2DArray fragmentDepths;
layout(location = LAYER_LOCATION) uniform int firstNumber;
layout(std430, binding = LAYERS_OF_DRAWS_STORAGE) buffer LayersOfDraws {
    uint layersOfDraws[];  // two words a draw: a bit each
};

void mark(int layer) {
    uint word = 2u * (surface.y - uint(firstNumber)) + uint(layer / 32), bit = 1u << uint(layer % 32);
    if ((layersOfDraws[word] & bit) == 0u) atomicOr(layersOfDraws[word], bit);
}

// Of surfaces that share a depth, each may be in any of their layers.
void record(ivec2 pixel) {
    uint depth = floatBitsToUint(gl_FragCoord.z);
    int length = min(textureSize(fragmentDepths, 0).z, 64);
    for (int i = 0; i < length; ++i) {
        uint listed = texelFetch(fragmentDepths, ivec3(pixel, i), 0).x;
        if (listed < depth) return;
        if (listed == depth) mark(i);
    }
}
#elif USE == 2
layout(binding = LAYER_DEPTHS_UNIT) uniform usampler2DArray fragmentDepths;
layout(binding = LAYER_NUMBERS_UNIT) uniform usampler2D numbersBefore;  // of the layer in front
layout(binding = LAYER_NUMBERS_IMAGE, r32ui) uniform uimage2D numbers;
layout(location = LAYER_LOCATION) uniform int layer;

bool sharesDepthBefore(ivec2 pixel) {
    return layer > 0 && texelFetch(fragmentDepths, ivec3(pixel, layer - 1), 0).x == texelFetch(fragmentDepths, ivec3(pixel, layer), 0).x;
}

// The first of the surfaces at this depth that no layer in front holds.
void record(ivec2 pixel) {
    uint number = surfaceNumber(surface.y);
    if (sharesDepthBefore(pixel) && number <= texelFetch(numbersBefore, pixel, 0).x) return;
    imageAtomicMin(numbers, pixel, number);
}
#else
layout(binding = FRAGMENT_COUNTS_IMAGE, r32ui) uniform uimage2D fragmentCounts;
layout(binding = FRAGMENT_DEPTHS_IMAGE, r32ui) uniform uimage2DArray fragmentDepths;
layout(binding = DEPTH_TIES_IMAGE, r32ui) uniform uimage2D depthTies;

// Inserts the depth into the list of its pixel, nearest first; what a full list has no room for falls out at its end. The list does not
// depend on the order of fragments. Bits of floats over 0 are in the order of the floats. After Liu, Huang, Liu and Wu, "FreePipe: a
// programmable parallel rendering architecture for efficient multi-fragment effects", I3D 2010.
void record(ivec2 pixel) {
    imageAtomicAdd(fragmentCounts, pixel, 1u);
    uint depth = floatBitsToUint(gl_FragCoord.z);
    int length = imageSize(fragmentDepths).z;
    for (int i = 0; i < length; ++i) {
        // Depths in the list only grow, and reading takes less than an atomic operation.
        if (imageLoad(fragmentDepths, ivec3(pixel, i)).x > depth) continue;
        uint before = imageAtomicMax(fragmentDepths, ivec3(pixel, i), depth);
        if (before == 0u) return;
        if (before == depth) imageAtomicOr(depthTies, ivec2(0), 1u);
        depth = min(depth, before);
    }
}
#endif

void main() {
    // As in surface_textured.frag.
    float alpha = materialFactors(surface.x).alpha * vertexAlpha * texture(baseColorTexture, textureCoordinate(surface.x, BASE_COLOR_SLOT)).a;
    if (packCoverage(layerCoverage(alpha, materialState(surface.x))) == 0u) discard;
    record(ivec2(gl_FragCoord.xy));
}
