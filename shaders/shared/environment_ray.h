// Rays that ask how much of its surroundings a surface sees: read by GLSL and by C++ over GLM's vectors. The includer defines SHARED_FUNCTION.
//
// The pixels of a 4 × 4 pattern take consecutive runs of one sequence of directions, so that any 4 × 4 neighbouring pixels have a whole set
// of them together, which a filter of that size averages (Keller and Heidrich, "Interleaved sampling", 2001). Each sample of a picture has the
// next set, of which a pixel takes another run, such that 16 samples of a pixel of one ray are a (0, 4, 2)-net as a set is; those of its
// neighbours lie between.

const int OCCLUSION_PATTERN = 4;

// A bit pattern turned around: van der Corput's sequence in base 2, as a number from 0 to less than 1.
SHARED_FUNCTION float radicalInverse(uint i) {
    i = (i & 0x55555555u) << 1 | (i >> 1 & 0x55555555u);
    i = (i & 0x33333333u) << 2 | (i >> 2 & 0x33333333u);
    i = (i & 0x0f0f0f0fu) << 4 | (i >> 4 & 0x0f0f0f0fu);
    i = i << 24 | (i & 0xff00u) << 8 | (i >> 8 & 0xff00u) | i >> 24;
    return float(i >> 8) * 5.9604645e-8f;  // 2^-24
}

// The second coordinate of Sobol's sequence, of which van der Corput's is the first.
SHARED_FUNCTION float sobolNumber(uint i) {
    uint result = 0u;
    for (uint direction = 0x80000000u; i != 0u; i >>= 1, direction ^= direction >> 1) {
        if ((i & 1u) != 0u) result ^= direction;
    }
    return float(result >> 8) * 5.9604645e-8f;
}

// The first ray of a pixel, of which the next `rays` follow.
SHARED_FUNCTION uint firstEnvironmentRay(uint x, uint y, uint sampleNumber, uint rays) {
    uint place = (x & 3u) | (y & 3u) << 2;
    uint turned = (sampleNumber & 3u) << 2 | ((sampleNumber ^ sampleNumber >> 2) & 3u);
    return (sampleNumber << 4 | (place ^ turned)) * rays;
}

// The direction of ray `index` over the plane z = 0, unit length. Uniform in the unit disc and lifted to the hemisphere, so that the density is
// in proportion to the cosine (Malley's method).
SHARED_FUNCTION vec3 environmentDirection(uint index) {
    float area = radicalInverse(index), angle = 6.2831853f * sobolNumber(index);
    float radius = sqrt(area);
    return vec3(radius * cos(angle), radius * sin(angle), sqrt(1.0f - area));
}

// Two vectors that make an orthonormal basis with a unit vector. Duff et al., "Building an orthonormal basis, revisited", 2017.
struct TangentPair {
    vec3 first, second;
};

SHARED_FUNCTION TangentPair tangentsOf(vec3 n) {
    float side = n.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (side + n.z), b = n.x * n.y * a;
    TangentPair tangents;
    tangents.first = vec3(1.0f + side * n.x * n.x * a, side * b, -side * n.x);
    tangents.second = vec3(b, side + n.y * n.y * a, -n.y);
    return tangents;
}

// The sine of the lowest elevation of a ray over the triangle: the geometric normal of the shadow word errs by up to 0.95 degrees.
const float MIN_RAY_ELEVATION = 0.02f;

// A ray below the triangle, where its normal and the shading normal differ, is mirrored to the side above: an open surface hides nothing of
// its surroundings from itself.
SHARED_FUNCTION vec3 aboveTriangle(vec3 direction, vec3 geometricNormal) {
    float height = dot(direction, geometricNormal);
    float raised = max(abs(height), MIN_RAY_ELEVATION);
    return height < MIN_RAY_ELEVATION ? direction + (raised - height) * geometricNormal : direction;
}

// The first offset along an axis, 0 or 1, of the pixels that the filter averages. A window of even size is off by half a pixel, which four
// samples even out.
SHARED_FUNCTION int filterStart(uint sampleNumber, int axis) {
    return -OCCLUSION_PATTERN / 2 + ((sampleNumber >> uint(axis) & 1u) == 0u ? 1 : 0);
}

// Is what a pixel found averaged into another one? `distance` is that of its surface from the plane of the other one, `cosine` that of the angle
// between their geometric normals.
const float MIN_FILTER_COSINE = 0.9f;
const float MAX_FILTER_PIXELS = 2.0f;

SHARED_FUNCTION bool isFiltered(float distance, float cosine, float pixelExtent) {
    return abs(distance) <= MAX_FILTER_PIXELS * pixelExtent && cosine >= MIN_FILTER_COSINE;
}
