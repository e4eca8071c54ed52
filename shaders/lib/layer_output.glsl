// What the geometry pass writes of a layer of transparent surfaces, and which fragments are part of it; see docs/layers.md. Follows
// lib/material.glsl.

layout(binding = LAYER_BEFORE_UNIT) uniform sampler2D depthBefore;
layout(binding = OPAQUE_DEPTH_UNIT) uniform sampler2D opaqueDepth;
layout(location = LAYER_LOCATION) uniform int layer;

layout(location = LAYER_OUTPUT) out uint layerWord;

// The share of the pixel that the fragment covers.
float layerCoverage(float alpha, MaterialState state) {
    if (state.blends) return alpha;
    return alpha < state.alphaCutoff ? 0.0 : 1.0;
}

// Does the fragment cover anything, lie in front of the opaque surfaces and behind the layer before? The depth test selects the nearest of
// those that do.
bool isInLayer(float coverage) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (packCoverage(coverage) == 0u || gl_FragCoord.z <= texelFetch(opaqueDepth, pixel, 0).x) return false;
    return layer == 0 || gl_FragCoord.z < texelFetch(depthBefore, pixel, 0).x;
}

void writeLayer(float coverage) {
    layerWord = packCoverage(coverage);
}
