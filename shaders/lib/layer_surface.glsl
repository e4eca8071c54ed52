// The fragments of transparent surfaces that layers hold; see docs/layers.md. Follows lib/material.glsl.

// The share of the pixel that a fragment covers.
float layerCoverage(float alpha, MaterialState state) {
    if (state.blends) return alpha;
    return alpha < state.alphaCutoff ? 0.0 : 1.0;
}

// Orders surfaces at the same depth: by their draws, then by the side that is seen.
uint surfaceNumber(uint draw) {
    return 2u * draw + (gl_FrontFacing ? 0u : 1u);
}
