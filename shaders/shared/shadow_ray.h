// Where the occlusion ray between a light and a pixel ends. GLSL compiles this file over floats, the tile kernels of C++ over vectors of
// floats; the includer defines what shared/shading.h names.
//
// The ray ends above the surface, on the side of the eye, by
//  - the lift of the shadow word: the height of the smooth surface that the vertex normals describe over the flat triangle. A light that the
//    smooth surface sees is not hidden by the facets beside the pixel (Hanika, "Hacking the shadow terminator", 2021);
//  - a margin for the errors of the position that the G-buffer gives and of the arithmetic of the ray:
//    * The rasteriser rounds vertices to 1/256 pixel (SUBPIXEL_BITS is 8 on every device we know), so that the surface drawn at a pixel lies up
//      to 1/512 pixel beside the true one along each axis of the picture: 0.71/256 of the pixel's extent in all, on either side.
//    * Depth, the position from it, the light's place in the space of an instance and the test of a triangle each round to 24 bits. Together
//      that is below 12 units in the last place of the largest number that takes part: a coordinate of the surface or the way to the eye.
//      12 × 2^-23 < 2^-19.
// So a surface never hides itself. What lies nearer to it than the margin may let light through below it: at 1280×720 and 45 degrees the
// margin is 8e-6 of the distance to the eye.

const Scalar SHADOW_MARGIN_PIXELS = 1.0f / 256.0f;
const Scalar SHADOW_MARGIN_ROUNDING = 1.9073486e-6f;  // 2^-19

// The largest of the coordinates' magnitudes.
SHARED_FUNCTION Real maxMagnitude(Real3 v) {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

// `pixelExtent` is the side of a pixel at the surface, metres.
SHARED_FUNCTION Real3 shadowRayEnd(Real3 position, Real3 wayToEye, Real3 geometricNormal, Real lift, Real pixelExtent) {
    Real margin = pixelExtent * SHADOW_MARGIN_PIXELS + max(maxMagnitude(position), maxMagnitude(wayToEye)) * SHADOW_MARGIN_ROUNDING;
    return position + geometricNormal * (lift + margin);
}

// For a light behind the surface, whose light passes through it: the margin alone, on the other side. The smooth surface lies no farther away
// there than the triangle.
SHARED_FUNCTION Real3 shadowRayEndBehind(Real3 position, Real3 wayToEye, Real3 geometricNormal, Real pixelExtent) {
    return shadowRayEnd(position, wayToEye, Real3(0.0f) - geometricNormal, pixelExtent * 0.0f, pixelExtent);
}

// The part of the ray next to the light that is left out, as a share of its length: a light in or on a surface shines on both of its sides.
// A position of float precision lies on a plane to within 2^-23 of its coordinates.
SHARED_FUNCTION Real shadowRayStart(Real3 lightPosition, Real3 way) {
    return min(maxMagnitude(lightPosition) * SHADOW_MARGIN_ROUNDING * inversesqrt(max(dot(way, way), 1.0e-30f)), 1.0f);
}
