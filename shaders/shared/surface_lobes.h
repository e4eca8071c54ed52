// What the light equation reads of a material, read by C++ and GLSL both. The includer defines Real and Real3.

struct SurfaceLobes {
    Real3 baseColor;  // linear, in the working space, 0 to 1
    Real metallic;    // 0 to 1
    Real roughness;   // perceptual, 0 to 1
};
