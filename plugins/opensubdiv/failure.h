#pragma once

#include <cstdint>
#include <string>

namespace candela_opensubdiv {

/// Why the cage is rejected. It travels as far as the plugin's entry, which hands it to the host.
struct Failure {
    std::string element;  ///< Such as "face 7"; empty where the whole cage is at fault.
    std::string reason;
};

/// The host refused the result and has recorded why.
struct HostRefused {};

/// "face 7"
std::string elementName(const char* noun, std::uint64_t index);

/// "edge 3-8"
std::string edgeName(std::uint32_t vertex0, std::uint32_t vertex1);

}  // namespace candela_opensubdiv
