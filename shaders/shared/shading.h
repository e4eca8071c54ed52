// The light equation in the merged form that docs/lighting.md derives: with t = l + v, neither the half vector nor its normalisation is
// computed, and D, G and the denominator share one division. GLSL compiles this file over floats, the tile kernels of C++ over vectors of
// floats, the tests over float and double. include/candela/brdf.h is the textbook form, kept independent as the reference of the tests.
//
// The includer defines
//   Real, Real3      a number and three of them, with the operators and functions that GLSL has for float and vec3
//   Scalar           the type of constants
//   SHARED_FUNCTION  what C++ puts before a function; nothing in GLSL
//   precise          nothing in C++
//   AlbedoTable      the reflection model's table of lib/shading/directional_albedo.h
//   fastDivide(a, b) a / b to the last bit but one
// before it, and `readAlbedoTable` after it, and includes shared/shading_constants.h and shared/surface_lobes.h. The parameter `brdf` is a
// constant wherever the functions are called.

const int BRDF_COURSE = 0;  // BrdfModel::course
const int BRDF_GLTF = 1;    // BrdfModel::gltf

// A surface with all that does not depend on the light.
struct ShadingPoint {
    Real3 position;
    Real3 normal;
    Real3 toEye;           // unit length
    Real nDotV;            // of the true view direction, for t; may be negative
    Real alpha2;           // alpha²
    Real viewLobe;         // the factor of D G / (4 (n·l) (n·v)) that does not depend on l
    Real maskingSlope;     // course: 1 - k; gltf: the root of Smith's term for v
    Real maskingOffset;    // course: k; gltf: n·v
    Real3 fresnelBase;     // F0 times the energy compensation
    Real3 fresnelSlope;    // 1 - F0 times the energy compensation
    Real3 specularAlbedo;  // E_s: what the lobe reflects of light from everywhere, compensation included; 0 to 1
    Real3 diffuse;         // (1 - E_s) (1 - metallic) baseColor / pi
};

// A point of the table.
struct AlbedoTexel {
    Real albedo;
    Real cosine;
};

// Bilinear between the texels, which lie at the corners of the cells; x and y go from 0 to 1.
SHARED_FUNCTION AlbedoTexel readAlbedoTable(AlbedoTable table, Real x, Real y);

// A point or spot light. `inverseRange2` is 1 / range²; `intensity` is colour × candela in the working space.
struct LocalLight {
    Real3 position;
    Real inverseRange2;
    Real3 intensity;
};

// A spot's direction times the scale of its ramp, and the ramp's offset, as KHR_lights_punctual recommends.
struct LightCone {
    Real3 axis;
    Real offset;
};

// ---- Terms of the BRDF

SHARED_FUNCTION Real3 reflectanceAtNormalIncidence(SurfaceLobes lobes) {
    return lobes.baseColor * lobes.metallic + Real3(DIELECTRIC_F0 * (1.0f - lobes.metallic));
}

// Lambert without the factor 1 - E_s.
SHARED_FUNCTION Real3 diffuseLobe(SurfaceLobes lobes) {
    return lobes.baseColor * ((1.0f - lobes.metallic) * (1.0f / PI));
}

// k of Schlick-Smith masking. Karis, "Real shading in Unreal Engine 4", 2013.
SHARED_FUNCTION Real schlickSmithK(Real roughness) {
    return (roughness + 1.0f) * (roughness + 1.0f) * 0.125f;
}

// One root of height-correlated Smith masking for GGX. Heitz 2014, equation 99.
SHARED_FUNCTION Real smithRoot(Real nDotW, Real alpha2) {
    return sqrt(nDotW * nDotW * (1.0f - alpha2) + alpha2);
}

// Energy compensation. Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
SHARED_FUNCTION Real3 energyCompensation(Real3 f0, Real albedo) {
    Real missing = (1.0f - albedo) / albedo;
    return Real3(1.0f) + f0 * missing;
}

SHARED_FUNCTION Real fifthPower(Real a) {
    return a * a * (a * a) * a;
}

// What the lobe reflects towards the eye of light from everywhere, without compensation: albedo (F0 + (1 - F0) fresnelWeight). This is the
// split sum of Karis, "Real shading in Unreal Engine 4", 2013: A = albedo (1 - fresnelWeight), B = albedo fresnelWeight.
struct LobeAlbedo {
    Real albedo;         // for F = 1
    Real fresnelWeight;  // the mean of Schlick's weight
};

SHARED_FUNCTION LobeAlbedo lobeAlbedo(const int brdf, AlbedoTable table, Real nDotV, Real roughness, Real alpha) {
    Real reach = nDotV + alpha;
    AlbedoTexel texel = readAlbedoTable(table, nDotV * (1.0f + alpha) / reach, roughness);
    LobeAlbedo lobe;
    lobe.albedo = texel.albedo;
    if (brdf == BRDF_COURSE) {
        Real k = schlickSmithK(roughness);
        Real side = reach / (reach * (1.0f - k) + k);
        lobe.albedo = min(texel.albedo * side * side, 1.0f);
    }
    lobe.fresnelWeight = fifthPower(max(1.0f - texel.cosine * reach, 0.0f));
    return lobe;
}

// The factor of the masking term's denominator that depends on l; n·l of its numerator cancels.
SHARED_FUNCTION Real maskingDenominator(const int brdf, ShadingPoint point, Real nDotL) {
    if (brdf == BRDF_COURSE) return nDotL * point.maskingSlope + point.maskingOffset;
    return nDotL * point.maskingSlope + point.maskingOffset * smithRoot(nDotL, point.alpha2);
}

// F - F0 over 1 - F0, where v·h = |t| / 2. Schlick, "An inexpensive BRDF model for physically-based rendering", 1994.
SHARED_FUNCTION Real schlickWeight(Real t2) {
    return fifthPower(max(1.0f - 0.5f * sqrt(max(t2, 1.0e-30f)), 0.0f));
}

// ---- The equation

// 1 - E_s, kept from falling below 0 by rounding.
SHARED_FUNCTION Real3 transmitted(Real3 specularAlbedo) {
    Real3 rest = Real3(1.0f) - specularAlbedo;
    return Real3(max(rest.x, 0.0f), max(rest.y, 0.0f), max(rest.z, 0.0f));
}

// `way` points towards the eye and has any length over 0.
SHARED_FUNCTION ShadingPoint shadingPoint(const int brdf, SurfaceLobes lobes, Real3 normal, Real3 position, Real3 way, AlbedoTable table) {
    // `precise`: what a compiler makes of these numbers does not depend on the lights' code that reads them, so that pictures with and without
    // shadows are the same bit for bit.
    precise ShadingPoint point;
    point.position = position;
    point.normal = normal;
    point.toEye = way * inversesqrt(dot(way, way));
    point.nDotV = dot(normal, point.toEye);
    Real alpha = max(lobes.roughness * lobes.roughness, MIN_ALPHA);
    Real nDotV = max(point.nDotV, MIN_N_DOT_V);
    point.alpha2 = alpha * alpha;
    LobeAlbedo lobe = lobeAlbedo(brdf, table, nDotV, lobes.roughness, alpha);
    point.fresnelBase = reflectanceAtNormalIncidence(lobes);
    point.fresnelSlope = Real3(1.0f) - point.fresnelBase;
    if (brdf == BRDF_COURSE) {
        Real k = schlickSmithK(lobes.roughness);
        point.maskingSlope = 1.0f - k;
        point.maskingOffset = k;
        point.viewLobe = point.alpha2 / (4.0f * PI * (nDotV * (1.0f - k) + k));
    } else {
        point.maskingSlope = smithRoot(nDotV, point.alpha2);
        point.maskingOffset = nDotV;
        point.viewLobe = point.alpha2 * (1.0f / (2.0f * PI));
        Real3 compensation = energyCompensation(point.fresnelBase, lobe.albedo);
        point.fresnelBase = point.fresnelBase * compensation;
        point.fresnelSlope = point.fresnelSlope * compensation;
    }
    point.specularAlbedo = (point.fresnelBase + point.fresnelSlope * lobe.fresnelWeight) * lobe.albedo;
    point.diffuse = diffuseLobe(lobes) * transmitted(point.specularAlbedo);
    return point;
}

// D G / (4 (n·l) (n·v)), D after Walter et al. 2007, equation 33. `t2` is |t|² and `nDotT2` is (n·t)²; `tangential2` is their difference,
// computed without cancellation.
SHARED_FUNCTION Real specularLobe(const int brdf, ShadingPoint point, Real tangential2, Real nDotT2, Real t2, Real nDotL) {
    // |t|² ((n·h)² (alpha² - 1) + 1). The minimum only guards l = -v, where t is 0.
    Real q = max(tangential2 + point.alpha2 * nDotT2, 1.0e-15f);
    return fastDivide(point.viewLobe * t2 * t2, q * q * maskingDenominator(brdf, point, nDotL));
}

// f(l, v) for a unit vector l above the horizon, where `nDotL` is dot(normal, l).
SHARED_FUNCTION Real3 evaluateBrdf(const int brdf, ShadingPoint point, Real3 l, Real nDotL) {
    Real3 t = l + point.toEye;
    Real nDotT = nDotL + point.nDotV;
    Real3 tangential = t - point.normal * nDotT;
    Real tangential2 = dot(tangential, tangential);
    Real nDotT2 = nDotT * nDotT;
    Real t2 = tangential2 + nDotT2;
    Real lobe = specularLobe(brdf, point, tangential2, nDotT2, t2, max(nDotL, 0.0f));
    Real3 fresnel = point.fresnelBase + point.fresnelSlope * schlickWeight(t2);
    return point.diffuse + fresnel * lobe;
}

// KHR_lights_punctual's window: 1 - (d / range)^4, or 0.
SHARED_FUNCTION Real rangeWindow(Real d2, Real inverseRange2) {
    Real relative2 = d2 * inverseRange2;
    return max(1.0f - relative2 * relative2, 0.0f);
}

// KHR_lights_punctual's ramp between the cone angles, before it is squared. `l` points to the light.
SHARED_FUNCTION Real coneRamp(LightCone cone, Real3 l) {
    return min(max(cone.offset - dot(l, cone.axis), 0.0f), 1.0f);
}

// How a point or spot light reaches a surface. `attenuation` is the window over the squared distance. Where the light lies on the surface,
// l is 0: it has no direction and gives nothing.
struct LightPath {
    Real3 l;
    Real nDotL;
    Real attenuation;
};

SHARED_FUNCTION LightPath pathToLight(ShadingPoint point, LocalLight light) {
    LightPath path;
    Real3 d = light.position - point.position;
    Real d2 = dot(d, d);
    Real window = rangeWindow(d2, light.inverseRange2);
    Real inverse = inversesqrt(max(d2, 1.0e-24f));
    path.l = d * inverse;
    path.nDotL = dot(point.normal, path.l);
    path.attenuation = window * min(inverse * inverse, 1.0f / (MIN_DISTANCE * MIN_DISTANCE));
    return path;
}

// The radiance that leaves the surface towards the eye by a light.
SHARED_FUNCTION Real3 pointLightRadiance(const int brdf, ShadingPoint point, LocalLight light) {
    LightPath path = pathToLight(point, light);
    return evaluateBrdf(brdf, point, path.l, path.nDotL) * (light.intensity * (path.attenuation * max(path.nDotL, 0.0f)));
}

SHARED_FUNCTION Real3 spotLightRadiance(const int brdf, ShadingPoint point, LocalLight light, LightCone cone) {
    LightPath path = pathToLight(point, light);
    Real ramp = coneRamp(cone, path.l);
    Real attenuation = path.attenuation * ramp * ramp;
    return evaluateBrdf(brdf, point, path.l, path.nDotL) * (light.intensity * (attenuation * max(path.nDotL, 0.0f)));
}

// `l` points against its direction; `illuminance` is colour × lux in the working space.
SHARED_FUNCTION Real3 directionalLightRadiance(const int brdf, ShadingPoint point, Real3 l, Real3 illuminance) {
    Real nDotL = dot(point.normal, l);
    return evaluateBrdf(brdf, point, l, nDotL) * (illuminance * max(nDotL, 0.0f));
}

// The radiance that leaves the surface towards the eye by light from everywhere: `irradiance` of its normal, and `reflected`, the radiance that
// its specular lobe gathers. Split sum: Karis, "Real shading in Unreal Engine 4", 2013.
SHARED_FUNCTION Real3 environmentRadiance(ShadingPoint point, Real3 irradiance, Real3 reflected) {
    return point.diffuse * irradiance + point.specularAlbedo * reflected;
}
