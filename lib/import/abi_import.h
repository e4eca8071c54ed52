#pragma once

#include "import/abi_reader.h"

#include <candela/plugin.h>
#include <candela/scene.h>

#include <functional>
#include <string>

namespace candela {

/// Takes a note for the load report.
using NoteSink = std::function<void(const std::string&)>;

// What a plugin pushed, checked and copied. The struct is the host's copy of this version's size; the arrays
// and strings that it points to are the plugin's. `scene` is what was pushed so far: all indices have to lie
// within. Each throws `Error` (badInput) that begins with the element.

Image imageFrom(const candela_image& pushed, const AbiReader& element);
Material materialFrom(const candela_material& pushed, const AbiReader& element, const Scene& scene);
Mesh meshFrom(const candela_mesh& pushed, const AbiReader& element, const Scene& scene, const NoteSink& note);
Cage cageFrom(const candela_cage& pushed, const AbiReader& element, const Scene& scene);
Skin skinFrom(const candela_skin& pushed, const AbiReader& element, const Scene& scene);
Node nodeFrom(const candela_node& pushed, const AbiReader& element, const Scene& scene);
Camera cameraFrom(const candela_camera& pushed, const AbiReader& element, const Scene& scene);
Light lightFrom(const candela_light& pushed, const AbiReader& element, const Scene& scene);
Animation animationFrom(const candela_animation& pushed, const AbiReader& element, const Scene& scene);

/// Lets the pushed node show the pushed cage.
void showCage(const candela_cage_instance& pushed, Scene& scene);

}  // namespace candela
