#include "plugin_call.h"

#include <dlfcn.h>

#include <cstddef>
#include <stdexcept>

namespace candela {
namespace {

const candela_subdivider& subdivider() {
    static const candela_subdivider* const found = [] {
        void* library = dlopen(CANDELA_TEST_PLUGINS "/candela-opensubdiv.so", RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) throw std::runtime_error(dlerror());
        const auto query =
            reinterpret_cast<candela_plugin_query_function>(dlsym(library, "candela_plugin_query"));
        return query(CANDELA_PLUGIN_MAJOR, CANDELA_PLUGIN_MINOR)->subdivider;
    }();
    return *found;
}

void fail(void* self, const char* element, const char* reason) {
    auto& result = *static_cast<CallResult*>(self);
    ++result.failures;
    result.element = element == nullptr ? "" : element;
    result.reason = reason;
}

candela_status setResult(void* self, const candela_refined_cage*) {
    static_cast<CallResult*>(self)->hasResult = true;
    return CANDELA_OK;
}

}  // namespace

CallResult callPlugin(const candela_cage& cage, std::uint32_t level) {
    CallResult result;
    // As a host of version 1.1, which has no parallel loops.
    candela_refinement refinement{};
    refinement.struct_size = offsetof(candela_refinement, worker_count);
    refinement.self = &result;
    refinement.fail = fail;
    refinement.set_result = setResult;
    result.status = subdivider().refine(&refinement, &cage, level);
    return result;
}

CageArrays::CageArrays() {
    cage.struct_size = sizeof(cage);
    cage.boundary_interpolation = CANDELA_BOUNDARY_EDGES;
    cage.vertex_count = 6;
    cage.positions = positions;
    cage.face_count = 2;
    cage.face_sizes = faceSizes;
    cage.face_vertices = faceVertices;
    cage.uv_count = 4;
    cage.uvs = uvs;
    cage.face_uvs = faceUvs;
    cage.crease_count = 2;
    cage.crease_edges = creaseEdges;
    cage.crease_sharpness = creaseSharpness;
    cage.corner_count = 1;
    cage.corner_vertices = cornerVertices;
    cage.corner_sharpness = cornerSharpness;
}

}  // namespace candela
