#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace candela_importers {

/// Bytes lent by somebody else.
struct Bytes {
    const std::uint8_t* data = nullptr;
    std::uint64_t size = 0;
};

/// Why the file cannot be read. It travels as far as the plugin's entry, which hands it to the host.
struct Failure {
    std::string element;  ///< Such as "mesh 3 'wheel', primitive 0".
    std::string reason;
};

/// The host refused something and has recorded why, or asked to stop.
struct HostRefused {};

/// "mesh 3 'wheel'"; "mesh 3" when the name is empty. Control characters of the name become '?', and a very
/// long name is cut, so that it fits into one line of a message.
std::string elementName(const char* noun, std::size_t index, const std::string& name);

/// `text` as one line fit for a message, cut at about 80 bytes.
std::string readable(const std::string& text);

}  // namespace candela_importers
