// What surfaces that transmit show of what is behind them (KHR_materials_transmission, _volume and _dispersion). Follows
// lib/layer_output.glsl and, with EXTENDED, lib/extended_material.glsl.

layout(location = REFRACTION_OUTPUT) out uvec2 refractionWords;

// Of a surface through which nothing is seen.
void writeNoRefraction(float coverage) {
    writeLayer(coverage);
    refractionWords = uvec2(0u);
}

#ifdef EXTENDED
// The pixel of a position relative to the eye, not rounded.
vec2 pixelOf(vec3 position) {
    vec4 clip = frame.clipFromWorld * vec4(frame.eye.xyz + position, 1.0);
    return clip.w > 0.0 ? (clip.xy / clip.w * 0.5 + 0.5) * vec2(frame.size.xy) : gl_FragCoord.xy;
}

// How far from the surface, in pixels, a ray leaves the volume behind it that is refracted by `ior` and `path` metres long.
vec2 exitOffset(LobeFrame surface, vec3 position, float ior, float path) {
    return pixelOf(position + refract(-surface.toEye, surface.normal, 1.0 / ior) * path) - pixelOf(position);
}

// `position` is relative to the eye, `scale` that of the instance. A thin wall and the back of a volume, which its front accounts for,
// neither refract nor absorb. Transmittance is that of the volume, linear Rec.709: lighting knows the surface's own.
Refraction refractionOf(uint material, LobeFrame surface, vec3 position, float roughness, float scale) {
    float ior = lobeTexel(material, LOBE_SPECULAR).x;
    vec4 absorption = lobeTexel(material, LOBE_ABSORPTION), volume = lobeTexel(material, LOBE_VOLUME);
    float path = volume.x * lobeSample(material, THICKNESS_SLOT).g * scale;
    Refraction refraction = Refraction(vec2(0.0), roughness * clamp(2.0 * ior - 2.0, 0.0, 1.0), 0.0, vec3(1.0));
    if (!gl_FrontFacing || path <= 0.0) return refraction;
    refraction.transmittance = exp(-absorption.rgb * path);
    // Far beyond any picture, and half of what a half float holds.
    refraction.offset = clamp(exitOffset(surface, position, ior, path), vec2(-32768.0), vec2(32768.0));
    // KHR_materials_dispersion: the indices of red and blue differ by as much from that of green.
    if (volume.y <= 0.0) return refraction;
    float halfSpread = (ior - 1.0) * 0.025 * volume.y;
    vec2 blue = exitOffset(surface, position, ior + halfSpread, path);
    refraction.spread = length(blue - refraction.offset) / max(length(refraction.offset), 1.0e-3);
    return refraction;
}

void writeRefraction(float coverage, Refraction refraction) {
    writeLayer(coverage);
    layerWord |= packBlurAndSpread(refraction);
    refractionWords = uvec2(packHalf2x16(refraction.offset), packTransmittance(refraction.transmittance));
}
#endif
