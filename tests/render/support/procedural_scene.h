#pragma once

#include <candela/scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <functional>

namespace candela::test {

/// A square in the plane z = 0 that faces +Z, x and y from -halfSize to halfSize. Texture coordinates have
/// (0, 0) at its upper left corner; tangents point along +X.
Mesh makeQuad(float halfSize);

/// A sphere around the origin with smooth normals.
Mesh makeSphere(float radius, int segments = 24, int rings = 12);

/// An 8-bit image whose texels `color` gives, x from the left and y from the top.
Image makeImage(std::uint32_t width, std::uint32_t height,
                const std::function<glm::u8vec4(std::uint32_t x, std::uint32_t y)>& color);

/// Adds a mesh of `material`, and a node that shows it. Returns the node's index.
std::uint32_t place(Scene& scene, Mesh mesh, const Material& material,
                    const glm::mat4& transform = glm::mat4(1.0f));

/// A scene of one object.
Scene sceneOf(Mesh mesh, const Material& material, const glm::mat4& transform = glm::mat4(1.0f));

WorldLight pointLight(const glm::vec3& position, float range, const glm::vec3& intensity);
WorldLight spotLight(const glm::vec3& position, const glm::vec3& target, float range,
                     const glm::vec3& intensity, float inner, float outer);
WorldLight directionalLight(const glm::vec3& direction, const glm::vec3& illuminance);

/// A number from 0 to 1 that depends on `seed` and `index` alone.
float hashed(std::uint32_t seed, std::uint32_t index);

/// A direction, uniformly distributed over the sphere; uses the numbers of `seed` and `seed + 1`.
glm::vec3 hashedDirection(std::uint32_t seed, std::uint32_t index);

}  // namespace candela::test
