#pragma once

#include <candela/scene.h>

#include <string>
#include <vector>

namespace candela {

/// Adds what a plugin may leave out: flat normals, and tangents where a normal texture needs them. `notes` is
/// told what could not be made.
void addMissingAttributes(Scene& scene, std::vector<std::string>& notes);

}  // namespace candela
