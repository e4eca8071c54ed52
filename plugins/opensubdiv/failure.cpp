#include "failure.h"

namespace candela_opensubdiv {

std::string elementName(const char* noun, std::uint64_t index) {
    return std::string(noun) + " " + std::to_string(index);
}

std::string edgeName(std::uint32_t vertex0, std::uint32_t vertex1) {
    return "edge " + std::to_string(vertex0) + "-" + std::to_string(vertex1);
}

}  // namespace candela_opensubdiv
