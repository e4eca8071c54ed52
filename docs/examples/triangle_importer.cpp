// Reads .tri files: a text of nine numbers a triangle, the x, y and z of its three corners in metres.

#include <candela/plugin.h>

#include <exception>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace {

bool addTriangles(const candela_host& host, const std::vector<float>& positions) {
    std::vector<uint32_t> indices(positions.size() / 3);
    std::iota(indices.begin(), indices.end(), 0u);
    const auto count = static_cast<uint32_t>(indices.size());
    const candela_submesh submesh{0, count, -1};

    candela_mesh mesh{};  // What stays NULL is absent: the host makes flat normals.
    mesh.struct_size = sizeof mesh;
    mesh.vertex_count = count;
    mesh.positions = positions.data();
    mesh.index_count = count;
    mesh.indices = indices.data();
    mesh.submesh_count = 1;
    mesh.submeshes = &submesh;

    candela_node node{};
    node.struct_size = sizeof node;
    node.parent = -1;
    node.rotation[3] = 1.0f;
    node.scale[0] = node.scale[1] = node.scale[2] = 1.0f;
    node.mesh = host.add_mesh(host.self, &mesh);
    return node.mesh >= 0 && host.add_node(host.self, &node) >= 0;
}

candela_status readTriangles(const candela_host& host, const candela_request& request) {
    if (request.query) {
        host.fail(host.self, "query", "a file of triangles takes none");
        return CANDELA_FAILED;
    }
    candela_bytes file{};
    if (host.read_file(host.self, request.name, &file) != CANDELA_OK) return CANDELA_FAILED;

    std::istringstream text(std::string(file.data, file.data + file.size));
    std::vector<float> positions;
    for (float number; text >> number;) positions.push_back(number);
    if (!text.eof() || positions.empty() || positions.size() % 9 != 0) {
        const std::string element = "after number " + std::to_string(positions.size());
        host.fail(host.self, element.c_str(), "nine numbers a triangle were expected");
        return CANDELA_FAILED;
    }
    return addTriangles(host, positions) ? CANDELA_OK : CANDELA_FAILED;
}

candela_status importScene(const candela_host* host, const candela_request* request) {
    try {
        return readTriangles(*host, *request);
    } catch (const std::exception& error) {  // No exception may leave a plugin.
        host->fail(host->self, nullptr, error.what());
        return CANDELA_FAILED;
    }
}

const char* const extensions[] = {"tri", nullptr};
const candela_importer importer{sizeof(candela_importer), extensions, nullptr, importScene, 0, nullptr};
const candela_plugin plugin{sizeof(candela_plugin),
                            CANDELA_PLUGIN_MAJOR,
                            CANDELA_PLUGIN_MINOR,
                            "triangles",
                            "1.0",
                            "triangles in plain text",
                            &importer,
                            nullptr,
                            nullptr};  // It subdivides no cages and decodes no images.

}  // namespace

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t) {
    return hostMajor == CANDELA_PLUGIN_MAJOR ? &plugin : nullptr;
}
