// The bounds of the light equation, read by C++ and GLSL both; docs/lighting.md gives the reasons. The includer defines Scalar as a
// floating-point type.

const Scalar PI = Scalar(3.14159265358979323846);
const Scalar MIN_ALPHA = Scalar(1.0e-3);  // alpha = roughness²
const Scalar MIN_N_DOT_V = Scalar(1.0e-4);
const Scalar MIN_DISTANCE = Scalar(1.0e-3);  // metres
const Scalar DIELECTRIC_F0 = Scalar(0.04);
const Scalar MIN_SHEEN_ROUGHNESS = Scalar(0.07);
// How much higher than the mean of 64 reflections the albedo of a lobe with two alphas is taken, and Schlick's weight in it.
const Scalar ANISOTROPIC_BIAS = Scalar(0.03);
const Scalar ANISOTROPIC_FRESNEL_BIAS = Scalar(0.004);
