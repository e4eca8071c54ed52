// What the light equation reads of a material, read by C++ and GLSL both. The includer defines Real and Real3.

struct SurfaceLobes {
    Real3 baseColor;  // linear, in the working space, 0 to 1
    Real metallic;    // 0 to 1
    Real roughness;   // perceptual, 0 to 1
};

// What it reads of a material with more lobes: see include/candela/brdf.h.
struct ExtendedLobes {
    Real3 f0;
    Real f90;
    Real anisotropy;
    Real3 anisotropyDirection;
    Real3 sheenColor;
    Real sheenRoughness;
    Real clearcoat;
    Real clearcoatRoughness;
    Real3 clearcoatNormal;
    Real transmission;
    Real diffuseTransmission;
    Real3 diffuseTransmissionColor;
};
