#include "import.h"

#include "cages.h"
#include "materials.h"
#include "meshes.h"
#include "parser.h"

namespace candela_obj {

void importFile(const std::string& name, const Query& query, const Host& host) {
    // Where the import stands, of 1: rough shares of the time of scenes with large textures.
    constexpr double documentRead = 0.3, materialsPushed = 0.7;
    host.progress(0.0);
    Document document = parseObj(host.readFile(name), host, documentRead);
    const bool asCages = query.subdivide || !document.tags.empty();
    if (!asCages && document.normalFault) throw *document.normalFault;
    const std::vector<PushedMaterial> materials =
        pushMaterials(document, host, documentRead, materialsPushed);
    if (asCages)
        pushCages(document, query, materials, host, materialsPushed);
    else
        pushMeshes(document, materials, host, materialsPushed);
    host.progress(1.0);
}

}  // namespace candela_obj
