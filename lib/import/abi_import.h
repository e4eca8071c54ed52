#pragma once

#include "import/abi_reader.h"
#include "import/note_list.h"

#include <candela/import.h>
#include <candela/plugin.h>
#include <candela/scene.h>

namespace candela {

// Elements that a plugin adds, checked and copied. `source` is the host's copy of the struct, of this
// version's size; the arrays and strings that it points to are the plugin's. Indices have to refer to
// elements that `scene` has already. Each function throws `Error` (badInput) whose text begins with the
// element.

Image imageFrom(const candela_image& source, const AbiReader& element);
Material materialFrom(const candela_material& source, const AbiReader& element, const Scene& scene);
Mesh meshFrom(const candela_mesh& source, const AbiReader& element, const Scene& scene, NoteList& notes);
Cage cageFrom(const candela_cage& source, const AbiReader& element, const Scene& scene);
Skin skinFrom(const candela_skin& source, const AbiReader& element, const Scene& scene);
Node nodeFrom(const candela_node& source, const AbiReader& element, const Scene& scene);
Camera cameraFrom(const candela_camera& source, const AbiReader& element, const Scene& scene);
Light lightFrom(const candela_light& source, const AbiReader& element, const Scene& scene);
Environment environmentFrom(const candela_environment& source, const AbiReader& element);
Animation animationFrom(const candela_animation& source, const AbiReader& element, const Scene& scene);

/// Adds an instance of a cage to its node.
void addCageInstance(const candela_cage_instance& source, Scene& scene);

/// Gives a node that shows a mesh its skin and its morph weights.
void addDeformation(const candela_deformation& source, Scene& scene);

/// What a plugin says of the whole scene.
SceneInfo sceneInfoFrom(const candela_scene_info& source, const AbiReader& call);

/// Puts all that is at the top of the scene below a node of its own that turns and scales it to metres with
/// +Y up. Nothing is done where the file has these.
void bringToMetres(const SceneInfo& info, Scene& scene);

/// Adds the attributes that a plugin may leave out: flat normals, and tangents where a normal texture or
/// anisotropy needs them. Appends a note for each attribute that cannot be generated.
void addMissingAttributes(Scene& scene, NoteList& notes);

/// Sets `Scene::origin` where the scene stands so far from the origin of its file that floats lose what its
/// size needs: farther than 8 km, or than 100 times its size. Lights and cameras without a node, which are in
/// world space then, keep their places.
void chooseOrigin(Scene& scene);

}  // namespace candela
