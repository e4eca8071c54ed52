#include <candela/plugin.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../common/host.h"
#include "animations.h"
#include "buffers.h"
#include "cages.h"
#include "compressed_primitives.h"
#include "compressed_views.h"
#include "document.h"
#include "image_based_light.h"
#include "images.h"
#include "lights.h"
#include "materials.h"
#include "mesh_deformations.h"
#include "meshes.h"
#include "nodes.h"
#include "primitives.h"
#include "variants.h"

namespace candela_plugins::gltf {

namespace {

// The progress at the end of each long part of the import: rough fractions of the time of scenes with large
// textures.
constexpr double documentRead = 0.1, imagesAdded = 0.6, meshesAdded = 0.85, cagesAdded = 0.95;

std::vector<bool> meshesInUse(const Document& document, const std::vector<DrawnNode>& drawn) {
    std::vector<bool> used(document.model.meshes.size());
    for (const DrawnNode& placed : drawn) {
        const int mesh = document.model.nodes[static_cast<std::size_t>(placed.node)].mesh;
        if (mesh >= 0 && !placed.hidden) used.at(static_cast<std::size_t>(mesh)) = true;
    }
    return used;
}

/// A scene of which nothing is left for what is broken in it is no scene.
void requireGeometry(const Document& document, const MeshParts& meshes, const AddedCages& cages) {
    const bool isDrawn = !cages.empty() || std::any_of(meshes.begin(), meshes.end(),
                                                       [](const auto& parts) { return !parts.empty(); });
    if (!isDrawn && document.lostGeometry) throw *document.lostGeometry;
}

void importFile(const std::string& name, const Host& host) {
    host.progress(0.0);
    const Container container = openContainer(host.readFile(name), host);
    Document document = readDocument(container.json, host);
    Storage storage;
    loadBuffers(document, container, storage, host);
    decodeViews(document, storage, host);
    const std::vector<DrawnNode> drawn = drawnNodes(document, host);
    const std::vector<bool> used = meshesInUse(document, drawn);
    decodePrimitives(document, used, storage, host);
    limitAbsentElements(document);
    host.progress(documentRead);

    addVariants(document, host);
    const AddedImages images = addImages(document, storage, host, documentRead, imagesAdded);
    AddedMaterials materials = addMaterials(document, images, used, host);
    const MeshParts meshes = addMeshes(document, used, materials, host, imagesAdded, meshesAdded);
    const AddedCages cages = addCages(document, used, materials, host, meshesAdded, cagesAdded);
    requireGeometry(document, meshes, cages);
    host.progress(cagesAdded);

    const AddedNodes nodes = addNodes(document, drawn, meshes, host);
    AddedCameras cameras = addCameras(document, drawn, nodes.indices, host);
    AddedLights lights = addLights(document, drawn, nodes.indices, host);
    addEnvironment(document, storage, host);
    Skins skins(document, nodes.indices, host);
    addCageInstances(document, drawn, nodes.indices, cages, skins, host);
    addMeshDeformations(document, drawn, nodes, meshes, skins, host);
    addAnimations(document,
                  {nodes.indices, morphedNodes(document, drawn, nodes, meshes, cages), materials,
                   std::move(lights), std::move(cameras)},
                  host);
    host.progress(1.0);
}

candela_status importScene(const candela_host* host, const candela_request* request) {
    return runGuarded(*host, [&] {
        if (const char* query = queryOf(*request))
            throw Failure{"query", "'" + readable(query) + "': a glTF scene takes none"};
        importFile(request->name, Host(*host));
    });
}

constexpr const char* extensions[] = {"gltf", "glb", nullptr};
constexpr candela_importer importer{sizeof(candela_importer), extensions, nullptr, importScene, 0, nullptr};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "gltf",
                                CANDELA_GLTF_VERSION,
                                "Reads glTF 2.0 scenes: .gltf and .glb",
                                &importer,
                                nullptr,
                                nullptr};

}  // namespace
}  // namespace candela_plugins::gltf

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t) {
    return hostMajor == CANDELA_PLUGIN_MAJOR ? &candela_plugins::gltf::plugin : nullptr;
}
