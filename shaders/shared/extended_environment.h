// How an environment reaches a surface with more lobes; docs/lighting.md, "More lobes". Follows shared/environment.h and
// shared/extended_lobes.h, and is compiled over the same types.

// A lobe as `specularDirection`, `environmentLevel` and `specularVisibility` read it.

// The base: an isotropic lobe of the same solid angle, about a normal that is bent into the plane of the wide direction's fan: the formula
// of KHR_materials_anisotropy.
SHARED_FUNCTION ShadingPoint baseInEnvironment(ExtendedPoint point) {
    ShadingPoint lobe = point.base;
    if (!anyAbove(point.anisotropy)) return lobe;
    Real3 fan = lobe.toEye - point.bitangent * dot(point.bitangent, lobe.toEye);
    Real keep = 1.0f - point.anisotropy * (1.0f - sqrt(sqrt(point.bitangentAlpha2)));
    keep = keep * keep * (keep * keep);
    Real3 bent = fan + (lobe.normal - fan) * keep;
    Real3 normal = bent * inversesqrt(max(dot(bent, bent), 1.0e-12f));
    lobe.normal = Real3(whereAbove(point.anisotropy, normal.x, lobe.normal.x), whereAbove(point.anisotropy, normal.y, lobe.normal.y),
                        whereAbove(point.anisotropy, normal.z, lobe.normal.z));
    lobe.nDotV = dot(lobe.normal, lobe.toEye);
    return lobe;
}

SHARED_FUNCTION ShadingPoint sheenInEnvironment(ExtendedPoint point) {
    ShadingPoint lobe = point.base;
    lobe.alpha2 = point.sheenAlpha2;
    return lobe;
}

// What the lobes of a surface gather: the irradiance of both sides, and the radiance around each lobe's direction.
struct GatheredLight {
    Real3 irradiance;
    Real3 irradianceBehind;
    Real3 base;
    Real3 coat;
    Real3 sheen;
};

SHARED_FUNCTION Real3 extendedEnvironmentRadiance(ExtendedPoint point, GatheredLight light) {
    Real3 scattered = point.base.diffuse * light.irradiance + point.through * light.irradianceBehind;
    Real3 reflected = point.base.specularAlbedo * light.base + point.coat.specularAlbedo * light.coat + point.sheenAlbedo * light.sheen;
    return scattered + reflected;
}
