#include "import.h"

#include "animations.h"
#include "buffers.h"
#include "cage_instances.h"
#include "cages.h"
#include "cameras.h"
#include "container.h"
#include "document.h"
#include "hierarchy.h"
#include "images.h"
#include "lights.h"
#include "materials.h"
#include "meshes.h"
#include "nodes.h"
#include "skins.h"

namespace candela_gltf {
namespace {

// Where the import stands, of 1, once each of its long parts is done: rough shares of the time of scenes with
// large textures.
constexpr double documentRead = 0.1, imagesPushed = 0.6, meshesPushed = 0.85, cagesPushed = 0.95;

std::vector<bool> meshesInUse(const Document& document, const std::vector<DrawnNode>& drawn) {
    std::vector<bool> used(document.model.meshes.size());
    for (const DrawnNode& placed : drawn) {
        const int mesh = document.model.nodes[static_cast<std::size_t>(placed.node)].mesh;
        if (mesh >= 0) used.at(static_cast<std::size_t>(mesh)) = true;
    }
    return used;
}

}  // namespace

void importFile(const std::string& name, const Host& host) {
    host.progress(0.0);
    const Container container = openContainer(host.readFile(name));
    Document document = readDocument(container.json, host);
    Storage storage;
    loadBuffers(document, container, storage, host);
    const std::vector<DrawnNode> drawn = drawnNodes(document, host);
    host.progress(documentRead);

    const std::vector<std::int32_t> images = pushImages(document, storage, host, documentRead, imagesPushed);
    const PushedMaterials materials = pushMaterials(document, images, host);
    const std::vector<bool> used = meshesInUse(document, drawn);
    const MeshParts meshes = pushMeshes(document, used, materials.uvSets, host, imagesPushed, meshesPushed);
    const PushedCages cages = pushCages(document, used, materials, host, meshesPushed, cagesPushed);
    host.progress(cagesPushed);

    const std::vector<std::int32_t> nodes = pushNodes(document, drawn, meshes, host);
    pushCameras(document, drawn, nodes, host);
    pushLights(document, drawn, nodes, host);
    const std::vector<std::int32_t> skins = pushSkins(document, drawn, nodes, cages, host);
    showCages(document, drawn, nodes, cages, skins, host);
    pushAnimations(document, nodes, cages, host);
    host.progress(1.0);
}

}  // namespace candela_gltf
