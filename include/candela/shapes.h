#pragma once

#include <candela/export.h>
#include <candela/mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace candela {

// Meshes of simple shapes around the origin, with normals and one set of texture coordinates, and of one
// submesh without a material. Lengths are metres, finite and over 0. Around an axis the texture coordinate u
// grows counter-clockwise as seen from above, and v downwards; seen from outside a picture is upright and not
// mirrored. Discs, also those that close cylinders and cones, show the circle that the picture holds. Each
// throws `Error` (badInput) that names the value which is out of its range.

/// The largest number of parts that a shape may be divided into in one direction.
inline constexpr std::uint32_t maxShapeParts = 8192;

/// A sphere whose poles lie on Y, of 3 or more segments around its axis and 2 or more rings along it.
CANDELA_API Mesh sphereMesh(float radius = 1.0f, std::uint32_t segments = 64, std::uint32_t rings = 32);
/// A box with sharp edges: 24 vertices. Each side shows all of the texture.
CANDELA_API Mesh boxMesh(const glm::vec3& size = glm::vec3(1.0f));
/// A rectangle that faces +Y, `width` along X and `depth` along Z, of 1 or more `parts` in both directions.
CANDELA_API Mesh planeMesh(float width = 1.0f, float depth = 1.0f, std::uint32_t parts = 1);
/// A disc that faces +Y, of 3 or more segments.
CANDELA_API Mesh discMesh(float radius = 1.0f, std::uint32_t segments = 64);
/// A closed cylinder along Y, of 3 or more segments.
CANDELA_API Mesh cylinderMesh(float radius = 1.0f, float height = 2.0f, std::uint32_t segments = 64);
/// A closed cone along Y, whose tip is at `height` / 2, of 3 or more segments.
CANDELA_API Mesh coneMesh(float radius = 1.0f, float height = 2.0f, std::uint32_t segments = 64);
/// A ring about Y, of 3 or more segments about its axis and 3 or more around its tube. `radius` is that of
/// the circle in the middle of the tube, and at least `tubeRadius`.
CANDELA_API Mesh torusMesh(float radius = 1.0f, float tubeRadius = 0.25f, std::uint32_t segments = 64,
                           std::uint32_t tubeSegments = 32);

}  // namespace candela
