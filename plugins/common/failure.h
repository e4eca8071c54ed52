#pragma once

#include <candela/plugin.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>

namespace candela_plugins {

/// Memory of another owner.
struct Bytes {
    const std::uint8_t* data = nullptr;
    std::uint64_t size = 0;
};

/// Why a scene cannot be imported or a cage not refined. `runGuarded` reports it to the host.
struct Failure {
    std::string element;  ///< Such as "mesh 3 'wheel', primitive 0"; empty where no part is at fault.
    std::string reason;
};

/// The host has refused an element and recorded the reason, or has cancelled the import.
struct HostRefused {};

/// "mesh 3 'wheel'"; "mesh 3" when the name is empty.
std::string elementName(const char* noun, std::size_t index, const std::string& name = {});

/// `text` as one line for a message: control characters become '?', and it is cut at about 80 bytes.
std::string readable(const std::string& text);

/// Calls `action`, and reports its exceptions by `fail` of the host (a `candela_host` or
/// `candela_refinement`): no exception may leave a plugin.
template <typename Host, typename Action>
candela_status runGuarded(const Host& host, const Action& action) {
    try {
        action();
        return CANDELA_OK;
    } catch (const Failure& failure) {
        host.fail(host.self, failure.element.c_str(), failure.reason.c_str());
    } catch (const HostRefused&) {
        // The host has recorded the reason.
    } catch (const std::bad_alloc&) {
        host.fail(host.self, nullptr, "there is not enough memory");
    } catch (const std::exception& error) {
        host.fail(host.self, nullptr, error.what());
    } catch (...) {
        host.fail(host.self, nullptr, "an unknown error");
    }
    return CANDELA_FAILED;
}

}  // namespace candela_plugins
