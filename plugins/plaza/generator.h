#pragma once

#include <candela/plugin.h>

#include <stdexcept>
#include <string>

namespace plaza {

/// What is wrong with the request: the part at fault and what was expected.
struct BadRequest : std::runtime_error {
    BadRequest(std::string part, const std::string& reason)
        : std::runtime_error(reason), element(std::move(part)) {}
    std::string element;
};

/// The host has refused something and recorded why.
struct HostRefused {};

/// Makes one kind of scene. `arguments` is what follows "scheme:". Throws `BadRequest` or `HostRefused`.
using Generator = void (*)(const candela_host& host, const std::string& arguments);

/// The index that an add function of the host gave; throws `HostRefused` when it refused.
inline int32_t accepted(int32_t index) {
    if (index < 0) throw HostRefused{};
    return index;
}

}  // namespace plaza
