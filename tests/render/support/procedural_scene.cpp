#include "support/procedural_scene.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

namespace candela::test {

Mesh makeQuad(float halfSize) {
    Mesh mesh;
    mesh.positions = {{-halfSize, -halfSize, 0},
                      {halfSize, -halfSize, 0},
                      {halfSize, halfSize, 0},
                      {-halfSize, halfSize, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

Mesh makeSphere(float radius, int segments, int rings) {
    Mesh mesh;
    for (int ring = 0; ring <= rings; ++ring) {
        const float polar = std::numbers::pi_v<float> * float(ring) / float(rings);
        for (int segment = 0; segment <= segments; ++segment) {
            const float azimuth = 2.0f * std::numbers::pi_v<float> * float(segment) / float(segments);
            const glm::vec3 direction(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                      std::sin(polar) * std::cos(azimuth));
            mesh.positions.push_back(direction * radius);
            mesh.normals.push_back(glm::normalize(direction));
            mesh.uv0.emplace_back(float(segment) / float(segments), float(ring) / float(rings));
        }
    }
    const auto vertex = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(ring * (segments + 1) + segment);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const std::uint32_t a = vertex(ring, segment), b = vertex(ring + 1, segment),
                                c = vertex(ring + 1, segment + 1), d = vertex(ring, segment + 1);
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    }
    return mesh;
}

Image makeImage(std::uint32_t width, std::uint32_t height,
                const std::function<glm::u8vec4(std::uint32_t x, std::uint32_t y)>& color) {
    Image image{"test", width, height, PixelFormat::rgba8, {}};
    image.pixels.resize(std::size_t{4} * width * height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::u8vec4 texel = color(x, y);
            std::memcpy(image.pixels.data() + std::size_t{4} * (y * width + x), &texel, 4);
        }
    }
    return image;
}

std::uint32_t place(Scene& scene, Mesh mesh, const Material& material, const glm::mat4& transform) {
    if (mesh.submeshes.empty())
        mesh.submeshes.push_back({0, static_cast<std::uint32_t>(mesh.indices.size()), std::nullopt});
    for (Submesh& submesh : mesh.submeshes)
        submesh.material = static_cast<std::uint32_t>(scene.materials.size());
    Node node;
    node.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    node.transform = transform;
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back(node);
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

Scene sceneOf(Mesh mesh, const Material& material, const glm::mat4& transform) {
    Scene scene;
    place(scene, std::move(mesh), material, transform);
    return scene;
}

WorldLight pointLight(const glm::vec3& position, float range, const glm::vec3& intensity) {
    WorldLight light;
    light.position = position;
    light.range = range;
    light.intensity = intensity;
    return light;
}

WorldLight spotLight(const glm::vec3& position, const glm::vec3& target, float range,
                     const glm::vec3& intensity, float inner, float outer) {
    WorldLight light = pointLight(position, range, intensity);
    light.type = LightType::spot;
    light.direction = glm::normalize(target - position);
    light.innerConeAngle = inner;
    light.outerConeAngle = outer;
    return light;
}

WorldLight directionalLight(const glm::vec3& direction, const glm::vec3& illuminance) {
    WorldLight light;
    light.type = LightType::directional;
    light.direction = glm::normalize(direction);
    light.intensity = illuminance;
    return light;
}

float hashed(std::uint32_t seed, std::uint32_t index) {
    std::uint32_t h = seed * 0x9e3779b9u ^ index * 0x85ebca6bu;
    h = (h ^ h >> 16) * 0x7feb352du;
    h = (h ^ h >> 15) * 0x846ca68bu;
    return static_cast<float>((h ^ h >> 16) >> 8) / 16777216.0f;
}

glm::vec3 hashedDirection(std::uint32_t seed, std::uint32_t index) {
    const double z = 2.0 * hashed(seed, index) - 1.0, side = std::sqrt(1.0 - z * z);
    const double angle = 2.0 * std::numbers::pi * hashed(seed + 1, index);
    return glm::vec3(side * std::cos(angle), side * std::sin(angle), z);
}

}  // namespace candela::test
