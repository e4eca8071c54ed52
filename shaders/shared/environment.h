// How an environment reaches a surface; docs/environment.md. Follows shared/shading.h, and is compiled over the same types.
//
// The includer defines, besides what that file asks for,
//   Real signOf(Real x)                     -1 where x is below 0, else 1
//   Real octavesBelowOne(Real x)            -log2(x), linear between powers of two, for 0 < x <= 1

// A place in an octahedral map, 0 to 1 along each side.
struct MapPoint {
    Real u;
    Real v;
};

// `direction` has any length over 0.
SHARED_FUNCTION MapPoint octahedralPoint(Real3 direction) {
    Real scale = 0.5f / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    Real below = max(-direction.y, 0.0f);
    MapPoint point;
    point.u = (direction.x + signOf(direction.x) * below) * scale + 0.5f;
    point.v = (direction.z + signOf(direction.z) * below) * scale + 0.5f;
    return point;
}

// Rows of the rotation from the world to the picture's frame.
struct EnvironmentAxes {
    Real3 x;
    Real3 y;
    Real3 z;
};

SHARED_FUNCTION Real3 inPicture(EnvironmentAxes axes, Real3 direction) {
    return Real3(dot(axes.x, direction), dot(axes.y, direction), dot(axes.z, direction));
}

// The mean of max(cosine, 0) over cosines that are spread evenly by `halfWidth` in both directions.
SHARED_FUNCTION Real meanCosine(Real cosine, Real halfWidth) {
    Real above = min(max(cosine + halfWidth, 0.0f), halfWidth * 2.0f);
    return above * above / (halfWidth * 4.0f) + max(cosine - halfWidth, 0.0f);
}

// The level of the maps for the lobe's alpha, without an upper end: level i is that of alpha = 2^-i.
SHARED_FUNCTION Real environmentLevel(ShadingPoint point) {
    return octavesBelowOne(point.alpha2) * 0.5f;
}

// About the middle of the light that a lobe reflects: a rough one leans from the mirror direction to the normal, as in Lagarde and de
// Rousiers, "Moving Frostbite to physically based rendering", 2014, 4.9.3. The weight (1 - alpha²)^4 is fitted to integrals of both models:
// docs/environment.md. Any length over 0.
SHARED_FUNCTION Real3 specularDirection(ShadingPoint point) {
    Real3 mirrored = point.normal * (2.0f * max(point.nDotV, 0.0f)) - point.toEye;
    Real weight = (1.0f - point.alpha2) * (1.0f - point.alpha2);
    return point.normal + (mirrored - point.normal) * (weight * weight);
}

// The share of the lobe's light that arrives where `visibility` of the hemisphere is free, 1 where all of it is. The same, listing 26.
SHARED_FUNCTION Real specularVisibility(ShadingPoint point, Real visibility) {
    Real nDotV = max(point.nDotV, MIN_N_DOT_V);
    Real exponent = exp2(-16.0f * sqrt(point.alpha2) - 1.0f);
    Real share = exp2(log2(nDotV + visibility) * exponent) - 1.0f + visibility;
    return min(max(share, 0.0f), 1.0f);
}
