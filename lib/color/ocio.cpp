#include "color/ocio.h"

#include <cctype>

namespace candela {

std::string oneLine(const std::string& message) {
    std::string line;
    for (const char c : message) {
        const bool isSpace = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!isSpace)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

}  // namespace candela
