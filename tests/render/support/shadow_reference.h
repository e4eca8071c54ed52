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
    double alpha = 1.0;  ///< Under 1 it lets 1 - alpha of the light through.
};

void addTriangles(std::vector<Triangle>& triangles, const Mesh& mesh, const glm::mat4& world,
                  double alpha = 1.0);

/// The triangles of a scene's meshes that cast shadows, with the alpha of a mesh whose material blends.
std::vector<Triangle> trianglesOf(const Scene& scene);

/// What a light at `from` has to pass to `to`, a point of a surface that the eye sees.
struct Segment {
    glm::dvec3 from, to, eye;
    double margin;  ///< Metres by which the ends may be off.
};

/// `grazing` where moving the segment by its margin may decide. A surface on which the segment ends, on the
/// side of the eye, hides nothing.
enum class Visibility { clear, blocked, grazing };

/// What passes by all triangles, a product of 1 - alpha.
struct Transmittance {
    double share = 1.0;
    bool grazing = false;  ///< Moving the segment by its margin may change it.
};

Transmittance transmittanceOf(const std::vector<Triangle>& triangles, const Segment& segment);

/// Of opaque triangles.
Visibility visibilityOf(const std::vector<Triangle>& triangles, const Segment& segment);

/// Not less than `shadowRayEnd` moves a ray's end, nor than single precision and the G-buffer's depth are
/// off, in a picture of `height` pixels.
double marginAt(const glm::dvec3& position, const CameraView& view, int height);

}  // namespace candela::test
