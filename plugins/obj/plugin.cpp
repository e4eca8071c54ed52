#include <candela/plugin.h>

#include <exception>
#include <new>

#include "import.h"

namespace candela_obj {
namespace {

/// The border: no exception goes beyond it.
candela_status importScene(const candela_host* host, const candela_request* request) {
    try {
        importFile(request->name, parseQuery(candela_importers::queryOf(*request)), Host(*host));
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

constexpr const char* extensions[] = {"obj", nullptr};
constexpr candela_importer importer{sizeof(candela_importer), extensions, nullptr, importScene};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "obj",
                                CANDELA_OBJ_VERSION,
                                "Reads Wavefront OBJ: polygons, and subdivision cages by tags or ?subdivide",
                                &importer,
                                nullptr};

// Polygons, cages and queries came with 1.1.
constexpr uint32_t minMinor = 1;

}  // namespace
}  // namespace candela_obj

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t hostMinor) {
    const bool serves = hostMajor == CANDELA_PLUGIN_MAJOR && hostMinor >= candela_obj::minMinor;
    return serves ? &candela_obj::plugin : nullptr;
}
