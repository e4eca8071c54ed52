// What the geometry pass writes of a layer of transparent surfaces, and which fragments are part of it; see docs/layers.md. Follows
// lib/material.glsl.

#include "lib/layer_surface.glsl"

layout(binding = LAYER_NUMBERS_UNIT) uniform usampler2D layerNumbers;  // where surfaces share a depth: that of the layer's surface
layout(location = LAYER_LOCATION) uniform int sharesDepths;

layout(location = LAYER_OUTPUT) out uint layerWord;

// Does the fragment, which lies at the depth of the layer, cover anything, and is its surface that of the layer?
bool isInLayer(float coverage, uint draw) {
    if (packCoverage(coverage) == 0u) return false;
    if (sharesDepths == 0) return true;
    uint number = texelFetch(layerNumbers, ivec2(gl_FragCoord.xy), 0).x;
    return number == surfaceNumber(draw) || number == LAYER_NO_NUMBER;
}

void writeLayer(float coverage) {
    layerWord = packCoverage(coverage);
}
