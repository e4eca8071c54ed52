#pragma once

#include <locale>
#include <sstream>
#include <string>
#include <string_view>

namespace candela {

/// The parts as text, concatenated. Floating-point numbers have at most 6 significant digits; the locale does
/// not matter.
template <class... Parts>
std::string joined(const Parts&... parts) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    (stream << ... << parts);
    return stream.str();
}

/// `text` as valid UTF-8: each byte that belongs to no well-formed sequence becomes U+FFFD (Unicode 15.0,
/// table 3-7). NULL gives an empty string.
std::string validUtf8(const char* text);
std::string validUtf8(std::string_view text);

/// For messages: valid UTF-8 in one line. Control characters become spaces, and what is over `maxBytes` is
/// cut off and shown as "...".
std::string oneLine(std::string_view text, std::size_t maxBytes = 2000);

/// ASCII letters in lower case, everything else unchanged; independent of the locale.
std::string lowerCase(std::string_view text);

}  // namespace candela
