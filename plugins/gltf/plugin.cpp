#include <candela/plugin.h>

#include <exception>
#include <new>

#include "host.h"
#include "import.h"

namespace candela_gltf {
namespace {

/// The border: no exception goes beyond it.
candela_status importScene(const candela_host* host, const candela_request* request) {
    try {
        if (const char* query = candela_importers::queryOf(*request))
            throw Failure{"query", "'" + readable(query) + "': a glTF scene takes none"};
        importFile(request->name, Host(*host));
        return CANDELA_OK;
    } catch (const Failure& failure) {
        host->fail(host->self, failure.element.c_str(), failure.reason.c_str());
    } catch (const HostRefused&) {
        // The host knows why.
    } catch (const std::bad_alloc&) {
        host->fail(host->self, nullptr, "there is not enough memory");
    } catch (const std::exception& error) {
        host->fail(host->self, nullptr, error.what());
    } catch (...) {
        host->fail(host->self, nullptr, "an unknown error");
    }
    return CANDELA_FAILED;
}

constexpr const char* extensions[] = {"gltf", "glb", nullptr};
constexpr candela_importer importer{sizeof(candela_importer), extensions, nullptr, importScene};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "gltf",
                                CANDELA_GLTF_VERSION,
                                "Reads glTF 2.0 scenes: .gltf and .glb",
                                &importer,
                                nullptr};

}  // namespace
}  // namespace candela_gltf

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t) {
    return hostMajor == CANDELA_PLUGIN_MAJOR ? &candela_gltf::plugin : nullptr;
}
