#pragma once

#include <map>
#include <vector>

#include "../common/host.h"
#include "cages.h"
#include "deformation.h"
#include "document.h"
#include "meshes.h"
#include "nodes.h"

namespace candela_plugins::gltf {

/// A node of the host whose mesh or cage has morph targets.
struct MorphedNode {
    std::int32_t node = -1;
    std::uint32_t targets = 0;
};

/// For each node of the file the nodes of the host whose morph weights are its own.
using MorphedNodes = std::map<std::size_t, std::vector<MorphedNode>>;

MorphedNodes morphedNodes(const Document& document, const std::vector<DrawnNode>& drawn,
                          const AddedNodes& nodes, const MeshParts& meshes, const AddedCages& cages);

/// Gives the nodes that show meshes their skins and morph weights. Notes what is not applied.
void addMeshDeformations(const Document& document, const std::vector<DrawnNode>& drawn,
                         const AddedNodes& nodes, const MeshParts& meshes, Skins& skins, const Host& host);

}  // namespace candela_plugins::gltf
