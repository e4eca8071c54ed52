#pragma once

#include <candela/camera.h>
#include <candela/scene.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace candela::test {

// Whether lights reach surfaces, by a test of all triangles in double precision.

/// In world space.
struct Triangle {
    glm::dvec3 corners[3];
};

void addTriangles(std::vector<Triangle>& triangles, const Mesh& mesh, const glm::mat4& world);

/// The triangles of a scene's meshes that cast shadows.
std::vector<Triangle> trianglesOf(const Scene& scene);

/// What a light at `from` has to pass to `to`, a point of a surface that the eye sees.
struct Segment {
    glm::dvec3 from, to, eye;
    double margin;  ///< Metres by which the ends may be off.
};

/// `grazing` where moving the segment by its margin may decide. A surface on which the segment ends, on the
/// side of the eye, hides nothing.
enum class Visibility { clear, blocked, grazing };

Visibility visibilityOf(const std::vector<Triangle>& triangles, const Segment& segment);

/// Not less than `shadowRayEnd` moves a ray's end, nor than single precision and the G-buffer's depth are
/// off, in a picture of `height` pixels.
double marginAt(const glm::dvec3& position, const CameraView& view, int height);

}  // namespace candela::test
