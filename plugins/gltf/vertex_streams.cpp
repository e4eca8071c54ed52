#include "vertex_streams.h"

#include <algorithm>
#include <cmath>

namespace candela_plugins::gltf {
namespace {

struct StreamForm {
    const char* attribute;
    AttributeForm form;
};

/// Those of the streams before texture coordinates.
constexpr std::array<StreamForm, uv0> forms{{{"POSITION", positionForm},
                                             {"NORMAL", normalForm},
                                             {"TANGENT", tangentForm},
                                             {"COLOR_0", {4, fractions, fractions}}}};
constexpr AttributeForm rgbForm{3, fractions, fractions};

std::vector<float> withAlpha(std::span<const float> rgb) {
    std::vector<float> rgba(rgb.size() / 3 * 4, 1.0f);
    for (std::size_t i = 0; i < rgb.size() / 3; ++i) std::copy_n(&rgb[i * 3], 3, &rgba[i * 4]);
    return rgba;
}

}  // namespace

std::size_t componentsOf(std::size_t stream) {
    return isUv(stream) ? uvForm.components : forms[stream].form.components;
}

std::string attributeOf(std::size_t stream, const UvSlots& slots) {
    return isUv(stream) ? slots.attribute(stream - uv0) : forms[stream].attribute;
}

Accessors accessorsOf(const tinygltf::Primitive& primitive, const UvSlots& slots) {
    Accessors accessors;
    for (std::size_t s = 0; s < streamCount; ++s) {
        const std::string attribute = attributeOf(s, slots);
        const bool isRead = isUv(s) && slots.isRead[s - uv0];
        const bool isOmitted = attribute.empty() || (s >= uv0 + 2 && !isRead);
        accessors[s] = isOmitted ? absent : accessorOf(primitive, attribute);
        if (isRead && accessors[s] == absent) accessors[s] = zeros;
    }
    // Tangents without normals are to be ignored (glTF 2.0, 3.7.2.1).
    if (accessors[normal] == absent) accessors[tangent] = absent;
    return accessors;
}

const AttributeForm& formOf(const Document& document, std::size_t stream, int accessor) {
    const bool rgb = stream == color &&
                     componentCount(document.model.accessors.at(static_cast<std::size_t>(accessor))) == 3;
    if (isUv(stream)) return uvForm;
    return rgb ? rgbForm : forms[stream].form;
}

Numbers<float> readStream(const Document& document, std::size_t stream, int accessor,
                          const std::string& attribute, std::size_t vertices, const std::string& element) {
    const AttributeForm& form = formOf(document, stream, accessor);
    Numbers<float> numbers =
        findAttribute(document, accessor, attribute, form, vertices, element, Finiteness::any);
    return &form == &rgbForm ? Numbers(withAlpha(numbers.view())) : numbers;
}

bool replaceNotFinite(Numbers<float>& numbers, float replacement) {
    const auto isFinite = [](float number) { return std::isfinite(number); };
    if (std::all_of(numbers.view().begin(), numbers.view().end(), isFinite)) return false;
    for (float& number : numbers.edit()) {
        if (!isFinite(number)) number = replacement;
    }
    return true;
}

}  // namespace candela_plugins::gltf
