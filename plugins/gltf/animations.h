#pragma once

#include <map>
#include <vector>

#include "../common/host.h"
#include "document.h"
#include "lights.h"
#include "materials.h"
#include "mesh_deformations.h"
#include "nodes.h"

namespace candela_plugins::gltf {

/// What animations may change.
struct AnimatedElements {
    const std::vector<std::int32_t>& nodes;  ///< The host's indices of the file's nodes.
    MorphedNodes morphed;
    const AddedMaterials& materials;
    AddedLights lights;
    AddedCameras cameras;
};

/// Adds the animations of drawn nodes' translation, rotation and scale, of morph weights, and of what the
/// pointers of KHR_animation_pointer lead to. Channels that cannot be read are left out with a note.
void addAnimations(const Document& document, const AnimatedElements& elements, const Host& host);

}  // namespace candela_plugins::gltf
