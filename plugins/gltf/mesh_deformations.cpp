#include "mesh_deformations.h"

#include <algorithm>

#include "deformation.h"

namespace candela_plugins::gltf {

namespace {

const std::vector<AddedMesh>& partsOf(const Document& document, std::size_t node, const MeshParts& meshes) {
    static const std::vector<AddedMesh> nothing;
    const int mesh = document.model.nodes[node].mesh;
    return mesh < 0 ? nothing : meshes.at(static_cast<std::size_t>(mesh));
}

/// The morph weights of the node's mesh, as many as it has targets.
std::vector<float> fittedWeights(const Document& document, std::size_t node, std::uint32_t targets,
                                 const Host& host) {
    const tinygltf::Node& source = document.model.nodes[node];
    const tinygltf::Mesh& mesh = document.model.meshes.at(static_cast<std::size_t>(source.mesh));
    const std::vector<double>& given = source.weights.empty() ? mesh.weights : source.weights;
    std::vector<float> weights(targets);
    if (!given.empty() && given.size() != targets) {
        host.note(
            CANDELA_NOTE_REPAIRED, elementName("node", node, source.name),
            "the number of morph weights is not that of the mesh's targets: those that are missing are 0");
    }
    std::transform(given.begin(),
                   given.begin() + static_cast<std::ptrdiff_t>(std::min(given.size(), weights.size())),
                   weights.begin(), [](double weight) { return static_cast<float>(weight); });
    return weights;
}

void addDeformation(const Document& document, std::size_t node, std::int32_t hostNode, const AddedMesh& mesh,
                    Skins& skins, const Host& host) {
    candela_deformation deformation{};
    deformation.struct_size = sizeof deformation;
    deformation.node = hostNode;
    deformation.skin = -1;
    const int skin = document.model.nodes[node].skin;
    if (skin >= 0 && mesh.hasJoints) deformation.skin = skins.find(static_cast<std::size_t>(skin));
    const std::vector<float> weights = fittedWeights(document, node, mesh.morphTargetCount, host);
    const bool isMorphed =
        std::any_of(weights.begin(), weights.end(), [](float weight) { return weight != 0.0f; });
    if (deformation.skin < 0 && !isMorphed) return;
    if (isMorphed) {
        deformation.morph_weight_count = mesh.morphTargetCount;
        deformation.morph_weights = weights.data();
    }
    host.add(deformation);
}

void noteOldHost(const Document& document, const std::vector<DrawnNode>& drawn, const Host& host) {
    const bool isDeformed = std::any_of(drawn.begin(), drawn.end(), [&](const DrawnNode& placed) {
        const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(placed.node)];
        if (node.mesh < 0) return false;
        const auto& primitives = document.model.meshes.at(static_cast<std::size_t>(node.mesh)).primitives;
        return node.skin >= 0 || std::any_of(primitives.begin(), primitives.end(), [](const auto& primitive) {
                   return !primitive.targets.empty();
               });
    });
    if (!isDeformed) return;
    host.note(CANDELA_NOTE_MISSING, "",
              "skins and morph targets of meshes: the host is older than version 1.3 of plugin.h");
}

}  // namespace

MorphedNodes morphedNodes(const Document& document, const std::vector<DrawnNode>& drawn,
                          const AddedNodes& nodes, const MeshParts& meshes, const AddedCages& cages) {
    MorphedNodes morphed;
    for (const DrawnNode& placed : drawn) {
        const auto node = static_cast<std::size_t>(placed.node);
        const AddedCage* cage = cageOf(document, node, cages);
        if (placed.hidden) continue;
        if (cage && cage->morphTargetCount > 0)
            morphed[node].push_back({nodes.indices[node], cage->morphTargetCount});
        const std::vector<AddedMesh>& parts = partsOf(document, node, meshes);
        for (std::size_t i = 0; !parts.empty() && i < nodes.parts[node].size(); ++i) {
            const std::uint32_t targets = parts[i % parts.size()].morphTargetCount;
            if (targets > 0) morphed[node].push_back({nodes.parts[node][i], targets});
        }
    }
    return morphed;
}

void addMeshDeformations(const Document& document, const std::vector<DrawnNode>& drawn,
                         const AddedNodes& nodes, const MeshParts& meshes, Skins& skins, const Host& host) {
    if (!host.takesDeformations()) return noteOldHost(document, drawn, host);
    for (const DrawnNode& placed : drawn) {
        if (placed.hidden) continue;
        const auto node = static_cast<std::size_t>(placed.node);
        const std::vector<AddedMesh>& parts = partsOf(document, node, meshes);
        for (std::size_t i = 0; !parts.empty() && i < nodes.parts[node].size(); ++i)
            addDeformation(document, node, nodes.parts[node][i], parts[i % parts.size()], skins, host);
        const bool anyJoints =
            std::any_of(parts.begin(), parts.end(), [](const AddedMesh& part) { return part.hasJoints; });
        const tinygltf::Node& source = document.model.nodes[node];
        if (source.skin >= 0 && !parts.empty() && !anyJoints) {
            host.note(CANDELA_NOTE_MISSING, elementName("node", node, source.name),
                      "a skin, but a mesh without JOINTS_0 and WEIGHTS_0: drawn without the skin");
        }
    }
}

}  // namespace candela_plugins::gltf
