#include <candela/plugin.h>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstddef>

#include "cage_file.h"

namespace candela_test {
namespace {

/// A host of version 1.0 with one file, which accepts all meshes and nodes.
struct OldHost {
    Bytes file;
    std::string failure;
    int nextIndex = 0;
    candela_host functions{};

    explicit OldHost(Bytes bytes) : file(std::move(bytes)) {
        functions.struct_size = offsetof(candela_host, add_cage);
        functions.self = this;
        functions.read_file = [](void* self, const char*, candela_bytes* out) {
            const Bytes& content = static_cast<OldHost*>(self)->file;
            *out = {content.data(), content.size()};
            return CANDELA_OK;
        };
        functions.fail = [](void* self, const char* element, const char* reason) {
            static_cast<OldHost*>(self)->failure =
                std::string(element ? element : "") + ": " + (reason ? reason : "");
        };
        functions.note = [](void*, const char*) {};
        functions.progress = [](void*, double) { return CANDELA_OK; };
        functions.add_material = [](void*, const candela_material*) { return 0; };
        functions.add_mesh = [](void* self, const candela_mesh*) {
            return static_cast<OldHost*>(self)->nextIndex++;
        };
        functions.add_node = [](void* self, const candela_node*) {
            return static_cast<OldHost*>(self)->nextIndex++;
        };
    }
};

candela_status importInto(OldHost& host) {
    const std::string path = std::string(CANDELA_TEST_PLUGINS) + "/candela-gltf.so";
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error(dlerror());
    const auto query =
        reinterpret_cast<candela_plugin_query_function>(dlsym(library, "candela_plugin_query"));
    candela_request request{};
    request.struct_size = sizeof request;
    request.uri = request.name = "scene.glb";
    const candela_status status =
        query(CANDELA_PLUGIN_MAJOR, 0)->importer->import_scene(&host.functions, &request);
    dlclose(library);
    return status;
}

TEST(OldHost, cannotImportCages) {
    OldHost host(cubeFile().glb());
    EXPECT_EQ(importInto(host), CANDELA_FAILED);
    EXPECT_NE(host.failure.find("older than version 1.1"), std::string::npos) << host.failure;
}

TEST(OldHost, getsNoLinesAndPoints) {
    GltfFile file = triangleFile();
    file.addMeshNode(R"("attributes":{"POSITION":0},"mode":3)");
    OldHost host(file.glb());
    EXPECT_EQ(importInto(host), CANDELA_OK) << host.failure;
    EXPECT_EQ(host.nextIndex, 3) << "a mesh and two nodes";
}

TEST(OldHost, importsFilesWithoutCages) {
    OldHost host(triangleFile().glb());
    EXPECT_EQ(importInto(host), CANDELA_OK) << host.failure;
    EXPECT_EQ(host.nextIndex, 2);
}

}  // namespace
}  // namespace candela_test
