#include <candela/plugin.h>

#include <exception>
#include <new>

#include "failure.h"
#include "refine.h"

namespace candela_opensubdiv {
namespace {

/// The border: no exception goes beyond it.
candela_status refineCage(const candela_refinement* host, const candela_cage* cage, uint32_t level) {
    try {
        refine(*host, *cage, level);
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

constexpr candela_subdivider subdivider{sizeof(candela_subdivider), refineCage};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "opensubdiv",
                                CANDELA_OPENSUBDIV_VERSION,
                                "Refines subdivision cages with OpenSubdiv",
                                nullptr,
                                &subdivider};

}  // namespace
}  // namespace candela_opensubdiv

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t) {
    return hostMajor == CANDELA_PLUGIN_MAJOR ? &candela_opensubdiv::plugin : nullptr;
}
