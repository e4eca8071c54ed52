#pragma once

#include <string>

#include "../common/host.h"

namespace candela_plugins::plaza {

// The generators of procedural scenes. `arguments` is the text after "scheme:". Each throws `Failure` or
// `HostRefused`.

/// "plaza:N": a ground of 100 m with 16 × 16 spheres of all roughnesses under N point lights.
void makePlaza(const Host& host, const std::string& arguments);

/// "cloud:N": N lights of 0.3 m range, evenly spaced on a sphere of 50 m around the camera, and a shell just
/// outside of it that they light. Another N moves every light.
void makeCloud(const Host& host, const std::string& arguments);

/// "colonnade:N": four rows of 16 columns under a roof, and N lights in 32 lanterns between them.
void makeColonnade(const Host& host, const std::string& arguments);

/// "crowd:N": N walking characters of 10,000 vertices and 60 joints each, every one with a mesh of its own.
void makeCrowd(const Host& host, const std::string& arguments);

/// "rooms:N": 16 × 16 furnished rooms with doorways on 100 m × 100 m, N lights spread over them, and a camera
/// in one of the rooms.
void makeRooms(const Host& host, const std::string& arguments);

/// "sculpture:N": the plaza with a subdivision cage before the camera, a ring of square section that is
/// twisted by 540 degrees. Two of its four edges are infinitely sharp, the other two are smooth.
void makeSculpture(const Host& host, const std::string& arguments);

/// "triangles:N" or "triangles:N,L": N triangles, 1 to 50,000,000, under L lights, 4096 by default. A quarter
/// are mounds of the ground, the others 256 rocks; those of a mesh are of one size, which between meshes of a
/// kind differs up to 64 times. What does not divide evenly are splinters turned in all directions. No mesh
/// is instanced. Throws `Failure` where memory is short.
void makeTriangles(const Host& host, const std::string& arguments);

}  // namespace candela_plugins::plaza
