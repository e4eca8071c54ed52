#pragma once

/// The shaders of the textbook programs, as a graphics programmer writes them in a day.
namespace textbook {

constexpr const char* geometryVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 world;
layout(location = 3) uniform mat4 clipFromWorld;
layout(location = 0) out vec3 worldPosition;
layout(location = 1) out vec3 worldNormal;
void main() {
    vec4 p = world * vec4(position, 1.0);
    worldPosition = p.xyz;
    worldNormal = transpose(inverse(mat3(world))) * normal;
    gl_Position = clipFromWorld * p;
}
)";

constexpr const char* geometryFragment = R"(#version 450 core
layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;
layout(location = 1) uniform vec3 baseColor;
layout(location = 2) uniform vec2 metallicRoughness;
layout(location = 0) out vec4 outPosition;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outColor;
void main() {
    outPosition = vec4(worldPosition, 1.0);
    outNormal = vec4(normalize(worldNormal), metallicRoughness.y);
    outColor = vec4(baseColor, metallicRoughness.x);
}
)";

/// The reflection model `course`, term by term, and the contribution of one light.
constexpr const char* lightingFunctions = R"(
layout(binding = 0) uniform sampler2D positions;
layout(binding = 1) uniform sampler2D normals;
layout(binding = 2) uniform sampler2D colors;
layout(binding = 4) uniform sampler2D splitSum;  // A and B over n.v and roughness, as Karis 2013
layout(location = 4) uniform vec3 eye;

const float PI = 3.14159265358979;

float distributionGgx(float nDotH, float alpha) {
    float a2 = alpha * alpha;
    float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
    return a2 / (PI * d * d);
}

float geometrySchlickGgx(float nDotX, float k) { return nDotX / (nDotX * (1.0 - k) + k); }

float geometrySmith(float nDotL, float nDotV, float roughness) {
    float k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    return geometrySchlickGgx(nDotL, k) * geometrySchlickGgx(nDotV, k);
}

vec3 fresnelSchlick(float cosTheta, vec3 f0) { return f0 + (1.0 - f0) * pow(clamp(1.0 - cosTheta, 0.0, 1.0), 5.0); }

struct Surface {
    vec3 position, normal, color;
    float roughness, metallic;
    bool covered;
};

Surface readSurface() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 position = texelFetch(positions, pixel, 0);
    vec4 normal = texelFetch(normals, pixel, 0);
    vec4 color = texelFetch(colors, pixel, 0);
    return Surface(position.xyz, normalize(normal.xyz), color.rgb, normal.w, color.a, position.a != 0.0);
}

vec3 shade(Surface s, vec3 lightPosition, float range, vec3 intensity) {
    vec3 toLight = lightPosition - s.position;
    float distance = length(toLight);
    if (!s.covered || distance > range) return vec3(0.0);
    vec3 v = normalize(eye - s.position);
    vec3 l = toLight / distance;
    vec3 h = normalize(l + v);
    float nDotL = max(dot(s.normal, l), 0.0);
    float nDotV = max(dot(s.normal, v), 1e-4);
    float alpha = max(s.roughness * s.roughness, 1e-3);
    vec3 f0 = mix(vec3(0.04), s.color, s.metallic);
    vec3 f = fresnelSchlick(max(dot(v, h), 0.0), f0);
    float d = distributionGgx(max(dot(s.normal, h), 0.0), alpha);
    float g = geometrySmith(nDotL, nDotV, s.roughness);
    vec3 specular = f * d * g / (4.0 * max(nDotL, 1e-6) * nDotV);
    vec2 ab = texture(splitSum, vec2(nDotV, s.roughness)).rg;
    vec3 diffuse = (1.0 - (f0 * ab.x + ab.y)) * (1.0 - s.metallic) * s.color / PI;
    float window = max(1.0 - pow(distance / range, 4.0), 0.0);
    return (diffuse + specular) * intensity * (window / (distance * distance)) * nDotL;
}
)";

constexpr const char* fullscreenVertex = R"(#version 450 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";

constexpr const char* fullscreenFragment = R"(
layout(binding = 3) uniform samplerBuffer lights;
layout(location = 5) uniform int lightCount;
layout(location = 0) out vec4 radiance;
void main() {
    Surface surface = readSurface();
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lightCount; ++i) {
        vec4 positionRange = texelFetch(lights, 2 * i);
        sum += shade(surface, positionRange.xyz, positionRange.w, texelFetch(lights, 2 * i + 1).rgb);
    }
    radiance = vec4(sum, 1.0);
}
)";

constexpr const char* volumeVertex = R"(#version 450 core
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec4 positionRange;
layout(location = 2) in vec4 intensity;
layout(location = 3) uniform mat4 clipFromWorld;
layout(location = 0) flat out vec4 lightPositionRange;
layout(location = 1) flat out vec3 lightIntensity;
void main() {
    lightPositionRange = positionRange;
    lightIntensity = intensity.rgb;
    gl_Position = clipFromWorld * vec4(positionRange.xyz + vertex * positionRange.w, 1.0);
}
)";

constexpr const char* volumeFragment = R"(
layout(location = 0) flat in vec4 lightPositionRange;
layout(location = 1) flat in vec3 lightIntensity;
layout(location = 0) out vec4 radiance;
void main() {
    radiance = vec4(shade(readSurface(), lightPositionRange.xyz, lightPositionRange.w, lightIntensity), 1.0);
}
)";

constexpr const char* volumeCountFragment = R"(
layout(location = 0) out vec4 pairs;
void main() { pairs = vec4(1.0); }
)";

constexpr const char* shadowVertex = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 world;
layout(location = 3) uniform mat4 clipFromWorld;
void main() { gl_Position = clipFromWorld * (world * vec4(position, 1.0)); }
)";

constexpr const char* shadowFragment = R"(#version 450 core
void main() {}
)";

constexpr const char* displayFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D radianceTexture;
layout(location = 0) out vec4 code;
void main() {
    vec3 c = clamp(texelFetch(radianceTexture, ivec2(gl_FragCoord.xy), 0).rgb, 0.0, 1.0);
    code = vec4(mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, c * 12.92, lessThan(c, vec3(0.0031308))), 1.0);
}
)";

}  // namespace textbook
