// The environment's picture where no surface is: the triangle lies at the depth of the background, and the depth test selects it.

#include "lib/frame.glsl"

layout(binding = ENVIRONMENT_PICTURE_UNIT) uniform sampler2D picture;  // equirectangular, linear Rec.709

layout(location = 0) out vec4 radiance;

const float PI = 3.14159265358979323846;

// Bilinear between the centres of texels: across the border of the columns, and constant beyond the last row at the poles.
vec3 interpolated(vec2 place) {
    ivec2 size = textureSize(picture, 0);
    vec2 texel = place * vec2(size) - 0.5;
    ivec2 low = ivec2(floor(texel));
    vec2 weight = texel - vec2(low);
    ivec2 columns = ivec2(low.x < 0 ? low.x + size.x : low.x, (low.x + 1) % size.x);
    ivec2 rows = clamp(ivec2(low.y, low.y + 1), 0, size.y - 1);
    vec3 above = mix(texelFetch(picture, ivec2(columns.x, rows.x), 0).rgb, texelFetch(picture, ivec2(columns.y, rows.x), 0).rgb, weight.x);
    vec3 below = mix(texelFetch(picture, ivec2(columns.x, rows.y), 0).rgb, texelFetch(picture, ivec2(columns.y, rows.y), 0).rgb, weight.x);
    return mix(above, below, weight.y);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = isOrthographic() ? frame.cameraForward.xyz
                                : frame.rayCorner.xyz + float(pixel.x) * frame.rayStepX.xyz + float(pixel.y) * frame.rayStepY.xyz;
    vec3 d = vec3(dot(frame.environmentX.xyz, ray), dot(frame.environmentY.xyz, ray), dot(frame.environmentZ.xyz, ray));
    vec2 place = vec2(0.5 + atan(d.x, -d.z) / (2.0 * PI), atan(length(d.xz), d.y) / PI);
    radiance = vec4(workingFromRec709(interpolated(place)) * frame.environmentX.w, 0.0);
}
