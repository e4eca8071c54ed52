#include "attributes.h"

#include <numeric>

namespace candela_gltf {

int accessorOf(const tinygltf::Primitive& primitive, const std::string& attribute) {
    const auto found = primitive.attributes.find(attribute);
    return found == primitive.attributes.end() ? -1 : found->second;
}

std::size_t elementCount(const Document& document, int accessor) {
    return document.model.accessors.at(static_cast<std::size_t>(accessor)).count;
}

std::vector<float> readAttribute(const Document& document, int accessor, const std::string& attribute,
                                 const AttributeForm& form, std::size_t vertices,
                                 const std::string& element) {
    const std::string where = element + ", attribute " + attribute;
    const std::size_t count = elementCount(document, accessor);
    if (count != vertices) {
        throw Failure{where, "accessor " + std::to_string(accessor) + " has " + std::to_string(count) +
                                 " elements, expected " + std::to_string(vertices)};
    }
    const Encodings allowed = document.quantized ? form.quantized : form.plain;
    return readFloats(document, accessor, static_cast<int>(form.components), allowed, where);
}

std::vector<std::uint32_t> readCorners(const Document& document, const tinygltf::Primitive& primitive,
                                       std::uint32_t vertices, const std::string& element) {
    const int accessor = accessorOf(primitive, indicesAttribute);
    if (accessor < 0) {
        std::vector<std::uint32_t> corners(vertices);
        std::iota(corners.begin(), corners.end(), 0u);
        return corners;
    }
    const std::string where = element + ", indices";
    std::vector<std::uint32_t> corners = readIndices(document, accessor, where);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < vertices) continue;
        throw Failure{where, "index " + std::to_string(corners[i]) + " at position " + std::to_string(i) +
                                 ", but the primitive has " + std::to_string(vertices) + " vertices"};
    }
    return corners;
}

}  // namespace candela_gltf
