#pragma once

#include <vector>

#include "document.h"
#include "host.h"

namespace candela_gltf {

struct DrawnNode {
    int node = -1;    ///< Of the file.
    int parent = -1;  ///< Of the file; -1 for a root.
};

/// The nodes of the scene to draw, parents before children: the default scene, else scene 0, else all nodes
/// when the file has no scenes. Throws `Failure` when a node has two parents or is its own ancestor, anywhere
/// in the file, and when a scene begins with a node that is a child. Notes further scenes.
std::vector<DrawnNode> drawnNodes(const Document& document, const Host& host);

}  // namespace candela_gltf
