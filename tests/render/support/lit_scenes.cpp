#include "support/lit_scenes.h"

#include "support/procedural_scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace candela::test {

namespace {

glm::mat4 floorAt(float y) {
    return glm::rotate(glm::translate(glm::mat4(1.0f), {0, y, 0}), glm::radians(-90.0f), glm::vec3(1, 0, 0));
}

glm::mat4 at(const glm::vec3& position) {
    return glm::translate(glm::mat4(1.0f), position);
}

Material surface(const glm::vec3& color, float metallic, float roughness) {
    Material material;
    material.baseColor = glm::vec4(color, 1.0f);
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

glm::vec3 saturated(std::uint32_t index) {
    return glm::vec3(hashed(1, index), hashed(2, index), hashed(3, index)) + 0.05f;
}

/// A normal map whose normals deviate by up to 40 degrees.
Image bumps() {
    return makeImage(32, 32, [](std::uint32_t x, std::uint32_t y) {
        const float u = 0.6f * std::sin(float(x) * 0.8f), v = 0.6f * std::cos(float(y) * 0.6f);
        const auto code = [](float n) { return static_cast<std::uint8_t>(std::lround(127.5f + 127.5f * n)); };
        const float z = std::sqrt(1.0f - 0.5f * (u * u + v * v));
        return glm::u8vec4(code(u * 0.7f), code(v * 0.7f), code(z), 255);
    });
}

Image noise(std::uint32_t seed) {
    return makeImage(16, 16, [seed](std::uint32_t x, std::uint32_t y) {
        const auto code = [&](std::uint32_t i) {
            return static_cast<std::uint8_t>(40 + 200 * hashed(seed + i, y * 16 + x));
        };
        return glm::u8vec4(code(0), code(1), code(2), 255);
    });
}

Texture textureOf(std::uint32_t image) {
    Texture texture;
    texture.image = image;
    return texture;
}

}  // namespace

LitScene spheresOnAFloor() {
    LitScene lit{"plaza",
                 sceneOf(makeQuad(20.0f), surface({0.5f, 0.5f, 0.5f}, 0.0f, 0.8f), floorAt(0.0f)),
                 {},
                 lookAt({0, 4, 9}, {0, 0.5f, 0}, 0.8f)};
    for (int column = 0; column < 6; ++column) {
        for (int row = 0; row < 2; ++row) {
            const auto index = static_cast<std::uint32_t>(2 * column + row);
            place(lit.scene, makeSphere(0.8f),
                  surface(glm::min(saturated(index + 90), 1.0f), float(row), 0.05f + 0.19f * float(column)),
                  at({2.2f * float(column) - 5.5f, 0.8f, 2.5f * float(row) - 2.0f}));
        }
    }
    for (std::uint32_t i = 0; i < 48; ++i) {
        const glm::vec3 position(14.0f * hashed(4, i) - 7.0f, 0.3f + 2.7f * hashed(5, i),
                                 10.0f * hashed(6, i) - 5.0f);
        lit.lights.push_back(pointLight(position, 3.0f, 8.0f * saturated(i)));
    }
    return lit;
}

LitScene textured() {
    LitScene lit{"textured", {}, {}, lookAt({0.5f, 0.8f, 3}, {0, 0, 0}, 0.8f)};
    lit.scene.images = {noise(1), noise(2), bumps()};
    Material material = surface({0.9f, 0.8f, 0.7f}, 1.0f, 1.0f);
    material.baseColorTexture = textureOf(0);
    material.metallicRoughnessTexture = textureOf(1);
    material.normalTexture = textureOf(2);
    material.emissionTexture = textureOf(1);
    material.emission = {0.3f, 0.2f, 0.1f};
    Mesh quad = makeQuad(1.5f);
    quad.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    place(lit.scene, quad, material);
    lit.lights = {spotLight({-1, 1, 1.5f}, {0, 0, 0}, 6.0f, {30, 25, 20}, 0.2f, 0.5f),
                  spotLight({1, 0.3f, 1}, {0.5f, 0, 0}, 0.0f, {5, 9, 14}, 0.0f, 1.2f),
                  pointLight({0.2f, -0.8f, 0.6f}, 0.0f, {3, 2, 4})};
    return lit;
}

LitScene sunAndSpots() {
    LitScene lit{"sun and spots",
                 sceneOf(makeQuad(10.0f), surface({0.4f, 0.6f, 0.3f}, 0.0f, 0.4f), floorAt(0.0f)),
                 {},
                 lookAt({3, 2, 6}, {0, 0.5f, 0}, 0.9f)};
    place(lit.scene, makeSphere(1.0f), surface({0.9f, 0.6f, 0.2f}, 1.0f, 0.3f), at({-1, 1, 0}));
    place(lit.scene, makeSphere(0.7f), surface({0.2f, 0.3f, 0.9f}, 0.0f, 0.6f), at({1.5f, 0.7f, 1}));
    lit.lights = {directionalLight({0.3f, -1, -0.5f}, {3, 2.9f, 2.7f}),
                  directionalLight({-1, -0.2f, 0.1f}, {0.2f, 0.3f, 0.6f}),
                  spotLight({0, 4, 3}, {-1, 1, 0}, 12.0f, {200, 150, 100}, 0.1f, 0.101f),
                  spotLight({4, 3, 0}, {1, 0, 1}, 0.0f, {40, 90, 60}, 0.3f, 0.6f),
                  spotLight({-4, 0.5f, 3}, {0, 0.5f, 0}, 9.0f, {60, 20, 80}, 0.0f, 1.5707963f)};
    return lit;
}

namespace {

/// A sphere whose tangents run along its parallels.
Mesh sphereWithTangents(float radius) {
    Mesh mesh = makeSphere(radius, 48, 24);
    for (const glm::vec3& n : mesh.normals) {
        const glm::vec3 along(n.z, 0.0f, -n.x);
        const bool isPole = glm::length(along) < 1e-3f;
        mesh.tangents.emplace_back(isPole ? glm::vec3(1, 0, 0) : glm::normalize(along), 1.0f);
    }
    return mesh;
}

/// One lobe each below 7, then stacks of them. Without transmission: such surfaces are drawn in layers.
Material lobedMaterial(std::uint32_t index) {
    const auto random = [index](std::uint32_t seed) { return hashed(60 + seed, index); };
    const auto has = [&](std::uint32_t lobe) { return index == lobe || (index >= 7 && random(lobe) < 0.6f); };
    Material material = surface(glm::min(saturated(index), 1.0f), index < 7 ? 0.0f : random(10), 0.3f);
    material.roughness = 0.15f + 0.7f * random(11);
    if (has(0)) material.ior = 1.0f + random(12);
    if (has(1)) {
        material.specular.factor = random(13);
        material.specular.color = {random(14), random(15), 1.0f};
    }
    if (has(2)) {
        material.clearcoat.factor = 0.3f + 0.7f * random(16);
        material.clearcoat.roughness = 0.1f + 0.4f * random(17);
    }
    if (has(3)) {
        material.sheen.color = {random(18), random(19), 0.9f};
        material.sheen.roughness = 0.2f + 0.8f * random(20);
    }
    if (has(4)) {
        material.anisotropy.strength = 0.2f + 0.8f * random(21);
        material.anisotropy.rotation = 3.0f * random(22);
    }
    if (has(5)) {
        material.iridescence.factor = 1.0f;
        material.iridescence.maxThickness = 200.0f + 400.0f * random(23);
    }
    if (has(6)) {
        material.diffuseTransmission.factor = 0.8f;
        material.diffuseTransmission.color = {0.9f, random(24), 0.2f};
    }
    return material;
}

}  // namespace

LitScene manyLobes() {
    LitScene lit{"many lobes",
                 sceneOf(makeQuad(20.0f), surface({0.5f, 0.5f, 0.5f}, 0.0f, 0.8f), floorAt(0.0f)),
                 {},
                 lookAt({0, 3, 8}, {0, 0.8f, 0}, 0.8f)};
    for (std::uint32_t i = 0; i < 18; ++i) {
        place(lit.scene, sphereWithTangents(0.65f), lobedMaterial(i),
              at({1.5f * float(i % 6) - 3.75f, 0.7f + 0.6f * float(i / 6), 2.0f - 2.0f * float(i / 6)}));
    }
    Material sheet = lobedMaterial(6);
    sheet.doubleSided = true;
    place(lit.scene, makeQuad(0.6f), sheet, glm::rotate(at({-1.5f, 0.7f, 3.2f}), 0.5f, {0, 1, 0}));
    place(lit.scene, makeQuad(0.6f), sheet, glm::rotate(at({1.5f, 0.7f, 3.2f}), 2.8f, {0, 1, 0}));
    lit.lights = mixedLocalLights(12, 6.0f);
    for (WorldLight& light : lit.lights) light.intensity *= 6.0f;
    lit.lights.push_back(directionalLight({0.3f, -1, -0.5f}, {0.9f, 0.8f, 0.7f}));
    lit.lights.push_back(directionalLight({-0.2f, -0.3f, 1}, {0.4f, 0.6f, 0.9f}));
    lit.lights.push_back(pointLight({-1.6f, 0.9f, 2.6f}, 3.0f, {4, 4, 3}));
    return lit;
}

LitScene nearAndFar() {
    LitScene lit{"near and far",
                 sceneOf(makeQuad(2.0f), surface({0.7f, 0.7f, 0.7f}, 0.0f, 0.5f)),
                 {},
                 lookAt({0, -1.5f, 2}, {0, 0, 0}, 0.9f)};
    place(lit.scene, makeSphere(0.4f), surface({0.8f, 0.3f, 0.2f}, 1.0f, 0.35f), at({0.9f, 0.2f, 0.4f}));
    for (std::uint32_t i = 0; i < 12; ++i) {
        const glm::vec3 position(3.0f * hashed(7, i) - 1.5f, 3.0f * hashed(8, i) - 1.5f,
                                 0.002f + 0.03f * hashed(9, i) * float(i));
        lit.lights.push_back(pointLight(position, 0.5f, 0.05f * saturated(i)));
    }
    lit.lights.push_back(pointLight({3.0e3f, 5.0e3f, 8.0e3f}, 0.0f, {1.0e8f, 1.0e8f, 2.0e8f}));
    lit.lights.push_back(pointLight({-3.0e3f, 2.0e3f, 6.0e3f}, 1.0e4f, {4.0e7f, 9.0e7f, 3.0e7f}));
    return lit;
}

LitScene smoothAndBright() {
    LitScene lit{"smooth and bright",
                 sceneOf(makeQuad(10.0f), surface({0.3f, 0.3f, 0.3f}, 0.0f, 0.0f), floorAt(0.0f)),
                 {},
                 lookAt({0, 2, 6}, {0, 0.7f, 0}, 0.8f)};
    for (int i = 0; i < 4; ++i) {
        place(lit.scene, makeSphere(0.8f, 48, 24),
              surface({0.95f, 0.9f, 0.8f}, float(i % 2), 0.04f * float(i)),
              at({2.0f * float(i) - 3.0f, 0.8f, 0}));
    }
    for (std::uint32_t i = 0; i < 10; ++i) {
        lit.lights.push_back(pointLight(
            {8.0f * hashed(10, i) - 4.0f, 1.0f + 3.0f * hashed(11, i), 6.0f * hashed(12, i) - 2.0f}, 0.0f,
            1.0e6f * saturated(i)));
    }
    return lit;
}

LitScene grazing() {
    LitScene lit{"grazing",
                 sceneOf(makeQuad(10.0f), surface({0.6f, 0.5f, 0.4f}, 0.0f, 0.3f), floorAt(0.0f)),
                 {},
                 lookAt({0, 0.05f, 6}, {0, 0, -4}, 0.5f)};
    place(lit.scene, makeQuad(0.5f), surface({0.9f, 0.9f, 0.2f}, 1.0f, 0.2f),
          glm::rotate(at({1, 0.5f, 0}), glm::radians(88.0f), glm::vec3(0, 1, 0)));
    for (std::uint32_t i = 0; i < 16; ++i) {
        lit.lights.push_back(pointLight(
            {12.0f * hashed(13, i) - 6.0f, 0.004f + 0.05f * hashed(14, i), 12.0f * hashed(15, i) - 9.0f},
            8.0f, 20.0f * saturated(i)));
    }
    lit.lights.push_back(directionalLight({1, -0.002f, 0.3f}, {50, 40, 30}));
    return lit;
}

LitScene orthographic() {
    LitScene lit = spheresOnAFloor();
    lit.name = "orthographic";
    lit.view = lookAt({4, 5, 9}, {0, 0.5f, 0}, 0.8f);
    lit.view.orthographicHeight = 8.0f;
    lit.view.nearPlane = 0.0f;
    lit.lights.push_back(directionalLight({0.3f, -1, -0.2f}, {0.4f, 0.5f, 0.6f}));
    return lit;
}

LitScene withFarPlane() {
    LitScene lit = spheresOnAFloor();
    lit.name = "with a far plane";
    lit.view.farPlane = 11.0f;
    return lit;
}

std::vector<LitScene> litScenes() {
    return {spheresOnAFloor(), textured(), sunAndSpots(),  nearAndFar(),
            smoothAndBright(), grazing(),  orthographic(), withFarPlane()};
}

std::vector<WorldLight> mixedLocalLights(std::uint32_t count, float range) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 position(10 * hashed(43, i) - 5, 8 * hashed(44, i) - 4, 12 * hashed(45, i) - 6);
        const glm::vec3 intensity = glm::vec3(hashed(46, i), hashed(47, i), hashed(48, i)) + 0.1f;
        if (i % 3 == 2) {
            lights.push_back(spotLight(position, position + glm::vec3(hashed(49, i) - 0.5f, 0.2f, -1), range,
                                       5.0f * intensity, 0.1f, 0.3f + hashed(50, i)));
        } else {
            lights.push_back(pointLight(position, range, intensity));
        }
    }
    return lights;
}

}  // namespace candela::test
