#include <candela/plugin.h>

#include <iterator>
#include <string>
#include <vector>

#include "document.h"
#include "materials.h"
#include "parts.h"

namespace candela_plugins::obj {
namespace {

/// Imports a file of the scene's folder: as polygons, or as cages where the query asks for them or the file
/// has a tag.
void importFile(const std::string& name, const Query& query, const Host& host) {
    // The progress at the end of each part: rough fractions of the time of scenes with large textures.
    constexpr double documentRead = 0.3, materialsAdded = 0.7;
    host.progress(0.0);
    Document document = parseObj(host.readFile(name), host, documentRead);
    const bool asCages = query.subdivide || !document.tags.empty();
    if (asCages || !host.takesLinesAndPoints()) leaveOutLooseElements(document, host);
    repairFaces(document, asCages ? Surface::cages : Surface::polygons, host);
    repairLooseElements(document, host);
    recentre(document);
    const std::vector<AddedMaterial> materials =
        addMaterials(document, name, host, documentRead, materialsAdded);
    if (asCages)
        addCages(document, query, materials, host, materialsAdded);
    else
        addMeshes(document, materials, host, materialsAdded);
    host.progress(1.0);
}

candela_status importScene(const candela_host* host, const candela_request* request) {
    return runGuarded(*host, [&] { importFile(request->name, parseQuery(queryOf(*request)), Host(*host)); });
}

constexpr const char* extensions[] = {"obj", nullptr};
constexpr const char* schemes[] = {"catmullClark", "loop", "bilinear", nullptr};
constexpr candela_option options[] = {{"subdivide", "polygons become subdivision cages of this scheme",
                                       CANDELA_OPTION_KEYWORD, 0, 0.0, 0.0, schemes},
                                      {"level", "they become cages that are refined to this level",
                                       CANDELA_OPTION_INTEGER, 0, 1.0, 8.0, nullptr}};
constexpr candela_importer importer{sizeof(candela_importer), extensions, nullptr, importScene,
                                    std::size(options),       options};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "obj",
                                CANDELA_OBJ_VERSION,
                                "Reads Wavefront OBJ: polygons, and subdivision cages by tags or ?subdivide",
                                &importer,
                                nullptr,
                                nullptr};

// Polygons, cages and queries came with 1.1.
constexpr uint32_t minMinor = 1;

}  // namespace

}  // namespace candela_plugins::obj

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t hostMinor) {
    const bool serves = hostMajor == CANDELA_PLUGIN_MAJOR && hostMinor >= candela_plugins::obj::minMinor;
    return serves ? &candela_plugins::obj::plugin : nullptr;
}
