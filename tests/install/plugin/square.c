/* A plugin in C: a square of "square:SIZE" metres, lit by two lights, by the initialisers of plugin.h. */
#include <candela/plugin.h>

#include <stdlib.h>

static candela_status import_square(const candela_host* host, const candela_request* request) {
    const float half = 0.5f * (float)atof(request->name);
    const float positions[] = {-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0};
    const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const candela_submesh submesh = {0, 6, 0};
    candela_material red = CANDELA_MATERIAL_INIT;
    candela_mesh mesh = CANDELA_MESH_INIT;
    candela_node nodes[2] = {CANDELA_NODE_INIT, CANDELA_NODE_INIT};
    candela_light lights[2] = {CANDELA_LIGHT_INIT, CANDELA_LIGHT_INIT};
    candela_camera camera = CANDELA_CAMERA_INIT;
    if (!(half > 0)) {
        host->fail(host->self, NULL, "the size of the square has to be over 0");
        return CANDELA_FAILED;
    }
    red.base_color[1] = red.base_color[2] = 0.1f;
    mesh.vertex_count = 4;
    mesh.positions = positions;
    mesh.index_count = 6;
    mesh.indices = indices;
    mesh.submesh_count = 1;
    mesh.submeshes = &submesh;
    nodes[0].mesh = 0;
    nodes[1].translation[2] = 2 * half;
    lights[0].node = lights[1].node = 1;
    lights[1].position[0] = half;
    camera.node = 1;
    if (host->add_material(host->self, &red) < 0 || host->add_mesh(host->self, &mesh) < 0 ||
        host->add_nodes(host->self, nodes, 2) < 0 || host->add_lights(host->self, lights, 2) < 0 ||
        host->add_camera(host->self, &camera) < 0) {
        return CANDELA_FAILED;
    }
    return CANDELA_OK;
}

static const char* const schemes[] = {"square", NULL};
static const candela_importer importer = {sizeof(candela_importer), NULL, schemes, import_square, 0, NULL};
static const candela_plugin plugin = {sizeof(candela_plugin), CANDELA_PLUGIN_MAJOR, CANDELA_PLUGIN_MINOR,
                                      "square",               "1.0",                "a square",
                                      &importer,              NULL,                 NULL};

const candela_plugin* candela_plugin_query(uint32_t host_major, uint32_t host_minor) {
    return host_major == CANDELA_PLUGIN_MAJOR && host_minor >= CANDELA_PLUGIN_MINOR ? &plugin : NULL;
}
