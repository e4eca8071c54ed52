// The reflectance at normal incidence of dielectrics and of thin films, read by GLSL and by C++ over GLM's vectors. The includer defines
// SHARED_FUNCTION. include/candela/brdf.h has the same functions in double precision, as the reference of the tests.

// F0 of a dielectric. `ior` is 1 or more, or infinity; `specular` and `specularColor` are those of KHR_materials_specular, which multiply what
// KHR_materials_ior gives. F90 is `specular`.
SHARED_FUNCTION vec3 dielectricF0(float ior, float specular, vec3 specularColor) {
    float inverse = 1.0f / ior;
    float root = (1.0f - inverse) / (1.0f + inverse);
    return min(specularColor * (root * root), vec3(1.0f)) * specular;
}

// (1 - cosine)^5 of Schlick's Fresnel term.
SHARED_FUNCTION float grazingWeight(float cosine) {
    float sine = clamp(1.0f - cosine, 0.0f, 1.0f);
    return sine * sine * (sine * sine) * sine;
}

// F0 of the boundary between two media with these indices of refraction.
SHARED_FUNCTION float boundaryF0(float inside, float outside) {
    float root = (inside - outside) / (inside + outside);
    return root * root;
}

// Fresnel's reflectance of unpolarised light at a boundary from air to a medium, in which its direction has the cosine `inside`.
SHARED_FUNCTION float boundaryReflectance(float cosine, float inside, float ior) {
    float across = (cosine - ior * inside) / max(cosine + ior * inside, 1.0e-6f);
    float along = (ior * cosine - inside) / max(ior * cosine + inside, 1.0e-6f);
    return 0.5f * (across * across + along * along);
}

// How the eye sees an interference of light whose paths differ by `difference` nanometres, by colour channel of Rec.709: the CIE functions in
// Fourier space, of Belcour and Barla's supplement.
SHARED_FUNCTION vec3 interferenceColor(float difference) {
    float phase = 6.2831853e-9f * difference;
    vec3 sensitivity = vec3(9.0458142e-8f, 1.0687371e-7f, 1.0696994e-7f) * cos(vec3(1.6810e6f, 1.7953e6f, 2.2084e6f) * phase) *
                       exp(vec3(-4.3278e9f, -9.3046e9f, -6.6121e9f) * (phase * phase));
    sensitivity.x += 1.6440829e-8f * cos(2.2399e6f * phase) * exp(-4.5282e9f * (phase * phase));
    vec3 xyz = sensitivity / 1.0685e-7f;
    return vec3(3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z, -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
                0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z);
}

// Two boundaries of a film and what passes between them, of one colour channel.
struct FilmBoundary {
    float throughput;  // the light that is reflected by the base, over all its ways through the film
    float amplitude;   // of one way more through the film
    float parity;      // -1 where the reflections shift the phase by half a wavelength, else 1
};

// `outer` is the reflectance of the film's outer side at the angle of view, `f0` that of the base without a film.
SHARED_FUNCTION FilmBoundary filmBoundary(float outer, float f0, float filmIor, float filmCosine) {
    float root = sqrt(clamp(f0, 0.0f, 0.9999f));
    float baseIor = (1.0f + root) / (1.0f - root);
    float baseF0 = boundaryF0(baseIor, filmIor);
    float inner = baseF0 + (1.0f - baseF0) * grazingWeight(filmCosine);
    float both = min(outer * inner, 0.9999f);
    FilmBoundary boundary;
    boundary.throughput = (1.0f - outer) * (1.0f - outer) * inner / (1.0f - both);
    boundary.amplitude = sqrt(both);
    // The film's inner side shifts the phase by half a wavelength, and a base that is optically thinner by another half.
    boundary.parity = baseIor < filmIor ? 1.0f : -1.0f;
    return boundary;
}

// The reflectance of a film on a base of `f0` for light at n·v. Belcour and Barla, "A practical extension to microfacet theory for the
// modeling of varying iridescence", 2017, with the first two orders of interference, as KHR_materials_iridescence has it. Fresnel's
// equations give the film's outer side and Schlick's term the base, of which no more is known than F0: a film that is air is none.
SHARED_FUNCTION vec3 filmReflectance(float nDotV, vec3 f0, float filmIor, float thickness) {
    // A film much thinner than light's wavelength is none.
    float presence = clamp(thickness / 0.03f, 0.0f, 1.0f);
    float ior = 1.0f + (filmIor - 1.0f) * (presence * presence * (3.0f - 2.0f * presence));
    float cosine = sqrt(max(1.0f - (1.0f - nDotV * nDotV) / (ior * ior), 0.0f));
    float outer = boundaryReflectance(nDotV, cosine, ior);
    FilmBoundary r = filmBoundary(outer, f0.x, ior, cosine);
    FilmBoundary g = filmBoundary(outer, f0.y, ior, cosine);
    FilmBoundary b = filmBoundary(outer, f0.z, ior, cosine);
    vec3 throughput = vec3(r.throughput, g.throughput, b.throughput);
    vec3 ratio = vec3(r.amplitude * r.parity, g.amplitude * g.parity, b.amplitude * b.parity);
    vec3 order = (throughput - (1.0f - outer)) * ratio;
    float difference = 2.0f * ior * thickness * cosine;
    vec3 first = 2.0f * order * interferenceColor(difference);
    vec3 second = 2.0f * order * ratio * interferenceColor(2.0f * difference);
    return max(throughput + outer + first + second, vec3(0.0f));
}

// The F0 with which Schlick's term gives, at n·v, the reflectance of a film on a base of `f0`. `filmIor` is 1 or more.
SHARED_FUNCTION vec3 iridescentF0(float nDotV, vec3 f0, float filmIor, float thicknessNanometres) {
    float cosine = clamp(nDotV, 0.0f, 1.0f);
    float weight = min(grazingWeight(cosine), 0.9999f);
    vec3 reflectance = filmReflectance(cosine, f0, filmIor, thicknessNanometres);
    return clamp((reflectance - weight) / (1.0f - weight), vec3(0.0f), vec3(1.0f));
}
