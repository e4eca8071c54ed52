// Surfaces with more lobes than metallic and roughness have, in the merged form: docs/lighting.md, "More lobes". Follows shared/shading.h, and is
// compiled over the same types. A pixel without such lobes never gets here.
//
// The includer defines, besides what that file asks for,
//   bool anyAbove(Real x)                      is x over 0, of vectors in any lane
//   Real whereAbove(Real x, Real a, Real b)    a where x is over 0, else b
//   log2, exp2

// A surface with all that does not depend on the light. `base` is the metallic-roughness surface with F0 and F90 of its own, dimmed by the layers
// above it; `coat` is the clearcoat, as strong as it is there, without a diffuse part.
struct ExtendedPoint {
    ShadingPoint base;
    ShadingPoint coat;
    Real clearcoat;      // 0: none
    Real anisotropy;     // 0: none
    Real3 tangent;       // the wide direction
    Real3 bitangent;
    Real tangentAlpha2;  // alpha² along them
    Real bitangentAlpha2;
    Real stretch;        // alpha of the bitangent over that of the tangent
    Real sheen;          // 0: none
    Real sheenExponent;  // half of the exponent of Charlie's distribution
    Real sheenAlpha2;
    Real3 sheenLobe;     // the factor of the lobe that does not depend on l
    Real3 sheenAlbedo;   // what the lobe reflects of light from everywhere
    Real passing;        // 0: no light from behind passes
    Real3 through;       // what of the light from behind is scattered through, over pi
    Real3 transmission;  // see transmissionWeight
};

SHARED_FUNCTION Real3 crossProduct(Real3 a, Real3 b) {
    return Real3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

SHARED_FUNCTION Real maxChannel(Real3 color) {
    return max(max(color.x, color.y), color.z);
}

// ---- Anisotropy. Burley, "Physically based shading at Disney", 2012, for GGX; alphas after KHR_materials_anisotropy.

// A vector in the frame of tangent, bitangent and normal.
struct LocalVector {
    Real t;
    Real b;
    Real n;
};

// Its length with the tangential part scaled by the alphas, squared: Smith's root times n·w.
SHARED_FUNCTION Real stretchedLength2(LocalVector w, Real tangentAlpha2, Real bitangentAlpha2) {
    return w.t * w.t * tangentAlpha2 + w.b * w.b * bitangentAlpha2 + w.n * w.n;
}

// alpha² of the isotropic masking of `course`: that of the cut along v at grazing angles, the product of both alphas along the normal.
SHARED_FUNCTION Real cutAlpha2(LocalVector v, Real tangentAlpha2, Real bitangentAlpha2) {
    return v.t * v.t * tangentAlpha2 + v.b * v.b * bitangentAlpha2 + v.n * v.n * sqrt(tangentAlpha2 * bitangentAlpha2);
}

// The weight of a reflection l among those of the normals visible from v: f_s (n·l) for F = 1 over their density. `length` is v's stretched one.
SHARED_FUNCTION Real visibleWeight(const int brdf, LocalVector v, Real length, LocalVector l, Real k, Real tangentAlpha2, Real bitangentAlpha2) {
    if (brdf == BRDF_COURSE) return l.n * (length + v.n) / ((l.n * (1.0f - k) + k) * (v.n * (1.0f - k) + k) * 2.0f);
    Real lit = (length + v.n) * l.n;
    return lit / (lit + (sqrt(stretchedLength2(l, tangentAlpha2, bitangentAlpha2)) - l.n) * v.n);
}

// Directional albedo has no table for two alphas: it is the mean over 64 normals visible from v, and a little more (ANISOTROPIC_BIAS), so that no
// surface returns more than it receives. The normals come from points of a spherical cap: Dupuy and Benyoub, "Sampling visible GGX normals with
// spherical caps", 2023.
const int ALBEDO_HEIGHTS = 8;
const int ALBEDO_AZIMUTHS = 8;

SHARED_FUNCTION LobeAlbedo anisotropicAlbedo(const int brdf, LocalVector v, Real tangentAlpha2, Real bitangentAlpha2, Real k) {
    Real tangentAlpha = sqrt(tangentAlpha2), bitangentAlpha = sqrt(bitangentAlpha2);
    Real length = sqrt(stretchedLength2(v, tangentAlpha2, bitangentAlpha2)), inverse = 1.0f / length;
    Real capT = v.t * tangentAlpha * inverse, capB = v.b * bitangentAlpha * inverse, capN = v.n * inverse;
    Real sum = capN * 0.0f, grazing = sum;
    for (int i = 0; i < ALBEDO_HEIGHTS; ++i) {
        // Squeezed towards the horizon, where the integrand is steep; odd rows lie between even ones.
        Scalar place = (Scalar(i) + 0.5f) / Scalar(ALBEDO_HEIGHTS), root = sqrt(place);
        bool odd = (i & 1) == 1;
        Scalar x = odd ? 0.98078528f : 0.83146961f, y = odd ? 0.19509032f : 0.55557023f;
        Real height = (capN + 1.0f) * (place * root);
        Real radius = sqrt(max(1.0f - (height - capN) * (height - capN), 0.0f));
        for (int j = 0; j < ALBEDO_AZIMUTHS; ++j) {
            Scalar before = x;
            x = (x - y) * 0.70710678f;
            y = (before + y) * 0.70710678f;
            Real t = (capT + radius * x) * tangentAlpha, b = (capB + radius * y) * bitangentAlpha;
            Real scale = inversesqrt(max(t * t + b * b + height * height, 1.0e-30f));
            Real vDotH = (v.t * t + v.b * b + v.n * height) * scale;
            Real twice = vDotH * scale * 2.0f;
            LocalVector l;
            l.t = t * twice - v.t;
            l.b = b * twice - v.b;
            l.n = height * twice - v.n;
            Real weight = whereAbove(l.n, visibleWeight(brdf, v, length, l, k, tangentAlpha2, bitangentAlpha2) * root, l.n * 0.0f);
            sum = sum + weight;
            grazing = grazing + weight * fifthPower(max(1.0f - vDotH, 0.0f));
        }
    }
    LobeAlbedo lobe;
    lobe.albedo = min(sum * ((1.0f + ANISOTROPIC_BIAS) * 1.5f / Scalar(ALBEDO_HEIGHTS * ALBEDO_AZIMUTHS)), 1.0f);
    lobe.fresnelWeight = min(grazing / max(sum, 1.0e-6f) * (1.0f + ANISOTROPIC_BIAS) + ANISOTROPIC_FRESNEL_BIAS, 1.0f);
    return lobe;
}

// f of the base: as `evaluateBrdf`, with a stretched distribution.
SHARED_FUNCTION Real3 anisotropicBrdf(const int brdf, ExtendedPoint point, Real3 l, Real nDotL) {
    Real3 t = l + point.base.toEye;
    Real nDotT = nDotL + point.base.nDotV;
    Real across = dot(t, point.tangent), along = dot(t, point.bitangent);
    Real nDotT2 = nDotT * nDotT;
    Real t2 = across * across + along * along + nDotT2;
    // |t|² times D's denominator, times both alphas.
    Real q = max(across * across * point.stretch + along * along / point.stretch + point.base.alpha2 * nDotT2, 1.0e-15f);
    Real cosine = max(nDotL, 0.0f);
    Real masking = cosine * point.base.maskingSlope + point.base.maskingOffset;
    if (brdf == BRDF_GLTF) {
        LocalVector light;
        light.t = dot(l, point.tangent);
        light.b = dot(l, point.bitangent);
        light.n = nDotL;
        Real root = sqrt(max(stretchedLength2(light, point.tangentAlpha2, point.bitangentAlpha2), 1.0e-12f));
        masking = cosine * point.base.maskingSlope + point.base.maskingOffset * root;
    }
    Real lobe = fastDivide(point.base.viewLobe * t2 * t2, q * q * masking);
    Real3 fresnel = point.base.fresnelBase + point.base.fresnelSlope * schlickWeight(t2);
    return point.base.diffuse + fresnel * lobe;
}

// ---- Sheen. The distribution of Estevez and Kulla, "Production friendly microfacet sheen BRDF", 2017, with the visibility of Neubelt and
// Pettineo, "Crafting a next-gen material pipeline for The Order: 1886", 2013, as KHR_materials_sheen recommends.

// The lobe's directional albedo for colour 1: over 1 at grazing angles of smooth cloth, where the lobe is divided by it.
SHARED_FUNCTION Real sheenAlbedoAt(AlbedoTable sheenTable, Real nDotV, Real roughness) {
    return readAlbedoTable(sheenTable, sqrt(nDotV), (roughness - MIN_SHEEN_ROUGHNESS) * (1.0f / (1.0f - MIN_SHEEN_ROUGHNESS))).albedo;
}

SHARED_FUNCTION Real3 sheenBrdf(ExtendedPoint point, Real3 l, Real nDotL) {
    Real3 t = l + point.base.toEye;
    Real nDotT = nDotL + point.base.nDotV;
    Real3 tangential = t - point.base.normal * nDotT;
    Real tangential2 = dot(tangential, tangential);
    Real sine2 = min(max(tangential2 / max(tangential2 + nDotT * nDotT, 1.0e-30f), 1.0e-30f), 1.0f);
    Real distribution = exp2(max(log2(sine2) * point.sheenExponent, -100.0f));
    Real nDotV = max(point.base.nDotV, MIN_N_DOT_V), cosine = max(nDotL, 0.0f);
    return point.sheenLobe * (distribution / (cosine + nDotV - cosine * nDotV));
}

// ---- The surface

SHARED_FUNCTION ShadingPoint scaledPoint(ShadingPoint point, Real scale) {
    point.fresnelBase = point.fresnelBase * scale;
    point.fresnelSlope = point.fresnelSlope * scale;
    point.specularAlbedo = point.specularAlbedo * scale;
    point.diffuse = point.diffuse * scale;
    return point;
}

// As `shadingPoint`, with F0 and F90 of `extended` and two alphas. The diffuse part is that of a surface through which nothing passes.
SHARED_FUNCTION ExtendedPoint pointWithBase(const int brdf, SurfaceLobes lobes, ExtendedLobes extended, Real3 normal, Real3 position, Real3 way,
                                            AlbedoTable table) {
    precise ExtendedPoint point;
    precise ShadingPoint base;
    base.position = position;
    base.normal = normal;
    base.toEye = way * inversesqrt(dot(way, way));
    base.nDotV = dot(normal, base.toEye);
    Real nDotV = max(base.nDotV, MIN_N_DOT_V);
    Real alpha = max(lobes.roughness * lobes.roughness, MIN_ALPHA);
    Real tangentAlpha = alpha + (1.0f - alpha) * extended.anisotropy * extended.anisotropy;
    point.anisotropy = extended.anisotropy;
    point.tangent = extended.anisotropyDirection;
    point.bitangent = crossProduct(normal, extended.anisotropyDirection);
    point.tangentAlpha2 = tangentAlpha * tangentAlpha;
    point.bitangentAlpha2 = alpha * alpha;
    point.stretch = alpha / tangentAlpha;
    base.alpha2 = tangentAlpha * alpha;
    LocalVector v;
    v.t = dot(base.toEye, point.tangent);
    v.b = dot(base.toEye, point.bitangent);
    v.n = nDotV;
    Real k = schlickSmithK(lobes.roughness);
    LobeAlbedo albedo = lobeAlbedo(brdf, table, nDotV, lobes.roughness, alpha);
    if (anyAbove(extended.anisotropy)) {
        Real cutRoughness = sqrt(sqrt(min(cutAlpha2(v, point.tangentAlpha2, point.bitangentAlpha2), 1.0f)));
        k = whereAbove(extended.anisotropy, schlickSmithK(cutRoughness), k);
        LobeAlbedo stretched = anisotropicAlbedo(brdf, v, point.tangentAlpha2, point.bitangentAlpha2, k);
        albedo.albedo = whereAbove(extended.anisotropy, stretched.albedo, albedo.albedo);
        albedo.fresnelWeight = whereAbove(extended.anisotropy, stretched.fresnelWeight, albedo.fresnelWeight);
    }
    base.fresnelBase = extended.f0;
    // Never darker towards grazing angles: the albedo's bias relies on it.
    Real3 rise = Real3(extended.f90) - extended.f0;
    base.fresnelSlope = Real3(max(rise.x, 0.0f), max(rise.y, 0.0f), max(rise.z, 0.0f));
    if (brdf == BRDF_COURSE) {
        base.maskingSlope = 1.0f - k;
        base.maskingOffset = k;
        base.viewLobe = base.alpha2 / (4.0f * PI * (nDotV * (1.0f - k) + k));
    } else {
        base.maskingSlope = sqrt(stretchedLength2(v, point.tangentAlpha2, point.bitangentAlpha2));
        base.maskingOffset = nDotV;
        base.viewLobe = base.alpha2 * (1.0f / (2.0f * PI));
        Real3 compensation = energyCompensation(extended.f0, albedo.albedo);
        base.fresnelBase = base.fresnelBase * compensation;
        base.fresnelSlope = base.fresnelSlope * compensation;
    }
    base.specularAlbedo = (base.fresnelBase + base.fresnelSlope * albedo.fresnelWeight) * albedo.albedo;
    base.diffuse = diffuseLobe(lobes) * transmitted(base.specularAlbedo);
    point.base = base;
    return point;
}

// The clearcoat's normal, turned to be perpendicular to the way to the eye where it points away from it: a lobe that is seen from behind its own
// normal reflects more than its albedo. `toEye` has unit length.
SHARED_FUNCTION Real3 seenCoatNormal(Real3 normal, Real3 toEye) {
    Real3 turned = normal + toEye * max(-dot(normal, toEye), 0.0f);
    return turned * inversesqrt(max(dot(turned, turned), 1.0e-12f));
}

// The clearcoat: the model's own lobe on an interface of index 1.5.
SHARED_FUNCTION ExtendedPoint withCoat(const int brdf, ExtendedPoint point, ExtendedLobes extended, AlbedoTable table) {
    SurfaceLobes lobes;
    lobes.baseColor = Real3(0.0f);
    lobes.metallic = extended.clearcoat * 0.0f;
    lobes.roughness = extended.clearcoatRoughness;
    Real3 normal = seenCoatNormal(extended.clearcoatNormal, point.base.toEye);
    ShadingPoint coat = shadingPoint(brdf, lobes, normal, point.base.position, point.base.toEye, table);
    point.clearcoat = extended.clearcoat;
    point.coat = scaledPoint(coat, extended.clearcoat);
    return point;
}

SHARED_FUNCTION ExtendedPoint withSheen(ExtendedPoint point, ExtendedLobes extended, AlbedoTable sheenTable) {
    Real roughness = max(extended.sheenRoughness, MIN_SHEEN_ROUGHNESS);
    Real albedo = sheenAlbedoAt(sheenTable, min(max(point.base.nDotV, MIN_N_DOT_V), 1.0f), roughness);
    Real inverseAlpha = 1.0f / (roughness * roughness);
    point.sheen = maxChannel(extended.sheenColor);
    point.sheenExponent = inverseAlpha * 0.5f;
    point.sheenAlpha2 = roughness * roughness * (roughness * roughness);
    point.sheenLobe = extended.sheenColor * ((inverseAlpha + 2.0f) * (1.0f / (8.0f * PI)) / max(albedo, 1.0f));
    point.sheenAlbedo = extended.sheenColor * min(albedo, 1.0f);
    return point;
}

// `way` points towards the eye and has any length over 0.
SHARED_FUNCTION ExtendedPoint extendedPoint(const int brdf, SurfaceLobes lobes, ExtendedLobes extended, Real3 normal, Real3 position, Real3 way,
                                            AlbedoTable table, AlbedoTable sheenTable) {
    precise ExtendedPoint point = pointWithBase(brdf, lobes, extended, normal, position, way, table);
    point = withCoat(brdf, point, extended, table);
    point = withSheen(point, extended, sheenTable);
    // What the coat leaves, and the sheen below it.
    Real belowCoat = max(1.0f - point.coat.specularAlbedo.x, 0.0f);
    Real belowSheen = belowCoat * max(1.0f - maxChannel(point.sheenAlbedo), 0.0f);
    point.sheenLobe = point.sheenLobe * belowCoat;
    point.sheenAlbedo = point.sheenAlbedo * belowCoat;
    Real inside = (1.0f - lobes.metallic) * belowSheen;
    Real3 entering = transmitted(point.base.specularAlbedo) * inside;
    Real scattered = 1.0f - extended.transmission;
    point.base = scaledPoint(point.base, belowSheen);
    point.base.diffuse = point.base.diffuse * (scattered * (1.0f - extended.diffuseTransmission));
    point.passing = extended.diffuseTransmission;
    point.through = extended.diffuseTransmissionColor * entering * (scattered * extended.diffuseTransmission * (1.0f / PI));
    point.transmission = lobes.baseColor * entering * extended.transmission;
    return point;
}

// The share of the radiance behind the surface that reaches the eye through it: transmission and base colour, and what the lobes above leave of
// them. KHR_materials_transmission.
SHARED_FUNCTION Real3 transmissionWeight(ExtendedPoint point) {
    return point.transmission;
}

// ---- The equation

// Over 0 where light from direction `d`, of any length, is reflected or scattered towards the eye: light in front of the surface, in front of
// its clearcoat or, where some passes, behind it.
SHARED_FUNCTION Real facingOfLobes(Real3 normal, Real clearcoat, Real3 clearcoatNormal, Real passing, Real3 d) {
    Real cosine = dot(normal, d);
    Real facing = max(cosine, whereAbove(clearcoat, dot(clearcoatNormal, d), cosine));
    return max(facing, whereAbove(passing, -cosine, cosine));
}

// f(l, v) times the cosine, of all lobes; l is a unit vector or 0.
SHARED_FUNCTION Real3 extendedReflection(const int brdf, ExtendedPoint point, Real3 l) {
    Real nDotL = dot(point.base.normal, l);
    Real3 sum;
    if (anyAbove(point.anisotropy)) {
        sum = anisotropicBrdf(brdf, point, l, nDotL);
    } else {
        sum = evaluateBrdf(brdf, point.base, l, nDotL);
    }
    if (anyAbove(point.sheen)) sum = sum + sheenBrdf(point, l, nDotL);
    sum = sum * max(nDotL, 0.0f);
    if (anyAbove(point.clearcoat)) {
        Real coatDotL = dot(point.coat.normal, l);
        sum = sum + evaluateBrdf(brdf, point.coat, l, coatDotL) * max(coatDotL, 0.0f);
    }
    if (anyAbove(point.passing)) sum = sum + point.through * max(-nDotL, 0.0f);
    return sum;
}

SHARED_FUNCTION Real3 extendedPointLightRadiance(const int brdf, ExtendedPoint point, LocalLight light) {
    LightPath path = pathToLight(point.base, light);
    return extendedReflection(brdf, point, path.l) * (light.intensity * path.attenuation);
}

SHARED_FUNCTION Real3 extendedSpotLightRadiance(const int brdf, ExtendedPoint point, LocalLight light, LightCone cone) {
    LightPath path = pathToLight(point.base, light);
    Real ramp = coneRamp(cone, path.l);
    return extendedReflection(brdf, point, path.l) * (light.intensity * (path.attenuation * ramp * ramp));
}

SHARED_FUNCTION Real3 extendedDirectionalLightRadiance(const int brdf, ExtendedPoint point, Real3 l, Real3 illuminance) {
    return extendedReflection(brdf, point, l) * illuminance;
}
