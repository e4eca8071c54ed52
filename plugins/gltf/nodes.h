#pragma once

#include <map>
#include <vector>

#include "../common/host.h"
#include "document.h"
#include "meshes.h"

namespace candela_plugins::gltf {

struct DrawnNode {
    int node = -1;    ///< Of the file.
    int parent = -1;  ///< Of the file; -1 for a root.
    /// KHR_node_visibility hides its mesh and its light at all times: it, or a node above it, is not visible,
    /// and no animation shows it.
    bool hidden = false;
};

/// The nodes of the scene to draw, each once and parents before children: the default scene, else scene 0,
/// else all nodes when the file has no scenes. A node that the file places more than once, as the child of
/// two parents or of itself, or as a root that is a child, is drawn as the child of the first parent, and
/// noted. Notes further scenes.
std::vector<DrawnNode> drawnNodes(const Document& document, const Host& host);

/// The host's nodes.
struct AddedNodes {
    std::vector<std::int32_t> indices;  ///< Of each node of the file, -1 for those that are not drawn.
    /// For each node of the file the nodes that show the parts of its mesh, in the order of `MeshParts`, for
    /// one instance after the other.
    std::vector<std::vector<std::int32_t>> parts;
};

/// Adds the drawn nodes, and a child for each further part of a node's mesh; where EXT_mesh_gpu_instancing
/// places the mesh, a child for each part of each instance.
AddedNodes addNodes(const Document& document, const std::vector<DrawnNode>& drawn, const MeshParts& meshes,
                    const Host& host);

/// A camera as it was added, but for its name.
struct AddedCamera {
    std::int32_t index = -1;  ///< The host's.
    candela_camera source;
};

/// By camera of the file.
using AddedCameras = std::multimap<std::size_t, AddedCamera>;

/// Adds a camera for each drawn node that has one, and notes broken ones. `nodes` are the host's indices of
/// the file's nodes.
AddedCameras addCameras(const Document& document, const std::vector<DrawnNode>& drawn,
                        const std::vector<std::int32_t>& nodes, const Host& host);

}  // namespace candela_plugins::gltf
