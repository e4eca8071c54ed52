// What passes through a triangle of a material that masks or blends by alpha: read by GLSL, where rays are traced in shaders, and by C++ over GLM's
// vectors. The includer defines
//   SHARED_FUNCTION  what C++ puts before a function; nothing in GLSL
//   AlphaTexels      an image, and float alphaTexel(AlphaTexels texels, int index): the alpha of a texel of it, row × width + column

const uint ALPHA_REPEAT = 0u;  // AlphaWrap::repeat
const uint ALPHA_CLAMP = 1u;   // AlphaWrap::clampToEdge
const uint ALPHA_MIRROR = 2u;  // AlphaWrap::mirroredRepeat

// How an image is read at level 0.
struct AlphaSampling {
    int width, height;
    uint wrapS, wrapT;  // ALPHA_...
    bool nearest;       // no interpolation between texels
};

// Into 0 to 1.
SHARED_FUNCTION float wrapCoordinate(float x, uint wrap) {
    if (wrap == ALPHA_CLAMP) return min(max(x, 0.0f), 1.0f);
    if (wrap == ALPHA_REPEAT) return x - floor(x);
    float inPair = x - 2.0f * floor(0.5f * x);
    return inPair > 1.0f ? 2.0f - inPair : inPair;
}

// Of a texel in the image or next to it.
SHARED_FUNCTION int wrapTexel(int texel, int size, uint wrap) {
    int before = wrap == ALPHA_REPEAT ? size - 1 : 0;
    int behind = wrap == ALPHA_REPEAT ? 0 : size - 1;
    return texel < 0 ? before : texel < size ? texel : behind;
}

SHARED_FUNCTION float alphaAt(AlphaTexels texels, AlphaSampling sampling, int column, int row) {
    int x = wrapTexel(column, sampling.width, sampling.wrapS), y = wrapTexel(row, sampling.height, sampling.wrapT);
    return alphaTexel(texels, y * sampling.width + x);
}

// The alpha of an image, as OpenGL 4.5, 8.14.3 filters it.
SHARED_FUNCTION float sampleAlpha(AlphaTexels texels, AlphaSampling sampling, vec2 uv) {
    float s = wrapCoordinate(uv.x, sampling.wrapS) * float(sampling.width);
    float t = wrapCoordinate(uv.y, sampling.wrapT) * float(sampling.height);
    if (sampling.nearest) return alphaAt(texels, sampling, int(floor(s)), int(floor(t)));
    float left = floor(s - 0.5f), top = floor(t - 0.5f);
    float toRight = s - 0.5f - left, down = t - 0.5f - top;
    int x = int(left), y = int(top);
    float a = alphaAt(texels, sampling, x, y), b = alphaAt(texels, sampling, x + 1, y);
    float c = alphaAt(texels, sampling, x, y + 1), d = alphaAt(texels, sampling, x + 1, y + 1);
    float above = a + (b - a) * toRight, below = c + (d - c) * toRight;
    return above + (below - above) * down;
}

// More than interpolation rounds an alpha of 1.
const float ALPHA_ROUNDING = 1.0e-5f;

// The share of a ray that passes where the alpha is `alpha`. `transmitted` is what a mask lets through where it covers.
SHARED_FUNCTION float alphaTransmittance(float alpha, float cutoff, bool blends, float transmitted) {
    if (!blends) return alpha < cutoff ? 1.0f : transmitted;
    return alpha > 1.0f - ALPHA_ROUNDING ? 0.0f : 1.0f - max(alpha, 0.0f);
}
