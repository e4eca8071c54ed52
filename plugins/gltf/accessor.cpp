#include "accessor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "buffers.h"

namespace candela_plugins::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are read without byte swapping");

constexpr Encoding indexEncodings[] = {uint8, uint16, uint32};

bool contains(Encodings encodings, const Encoding& encoding) {
    return std::find(encodings.begin(), encodings.end(), encoding) != encodings.end();
}

std::uint64_t componentSize(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        default:
            return 4;
    }
}

std::string encodingName(const Encoding& encoding) {
    std::string name = encoding.normalized ? "normalised " : "";
    switch (encoding.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return name + "BYTE";
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return name + "UNSIGNED_BYTE";
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return name + "SHORT";
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return name + "UNSIGNED_SHORT";
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return name + "UNSIGNED_INT";
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return name + "FLOAT";
        default:
            return name + "component type " + std::to_string(encoding.componentType);
    }
}

std::string typeName(int components) {
    if (components > 4) return components == 9 ? "MAT3" : "MAT4";
    return components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
}

std::string expectation(int components, Encodings allowed) {
    std::string text = typeName(components) + " of ";
    std::size_t left = allowed.size();
    for (const Encoding& encoding : allowed) {
        text += encodingName(encoding);
        --left;
        if (left > 0) text += left == 1 ? " or " : ", ";
    }
    return text;
}

/// "normalized" means nothing for 32-bit numbers, and for indices.
Encoding encodingOf(const tinygltf::Accessor& accessor, Encodings allowed) {
    const bool isIndex = allowed.data() == indexEncodings;
    const bool is32Bit = componentSize(accessor.componentType) == 4;
    return {accessor.componentType, accessor.normalized && !isIndex && !is32Bit};
}

/// An accessor of validated type, and its name in messages.
struct Checked {
    const tinygltf::Accessor& accessor;
    std::string element;  ///< The element that uses the accessor.
    std::string name;     ///< "accessor 7"
    std::uint64_t elementSize;

    [[noreturn]] void fail(const std::string& reason) const { throw Failure{element, name + " " + reason}; }
};

Checked check(const Document& document, int index, int components, Encodings allowed,
              const std::string& element) {
    requireAccessor(document, index, element);
    const tinygltf::Accessor& accessor = document.model.accessors.at(static_cast<std::size_t>(index));
    const Encoding encoding = encodingOf(accessor, allowed);
    const int found = componentCount(accessor);
    Checked checked{accessor, element, "accessor " + std::to_string(index),
                    componentSize(accessor.componentType) * static_cast<std::uint64_t>(components)};
    // It has as many numbers as a VEC4.
    const bool isMat2 = accessor.type == TINYGLTF_TYPE_MAT2;
    if (isMat2 || found != components || !contains(allowed, encoding)) {
        checked.fail("is " + (isMat2 ? "MAT2" : typeName(found)) + " of " + encodingName(encoding) +
                     ", expected " + expectation(components, allowed));
    }
    if (accessor.count == 0) checked.fail("has no elements");
    return checked;
}

/// Checks that `count` elements fit behind `offset`, and returns their first byte.
const std::uint8_t* elementsAt(const Bytes& view, std::uint64_t offset, std::uint64_t stride,
                               std::uint64_t size, std::uint64_t count, const Checked& checked,
                               const char* what) {
    const std::uint64_t end = offset + stride * (count - 1) + size;
    if (end > view.size) {
        checked.fail(std::string(what) + " end at byte " + std::to_string(end) + " of a bufferView of " +
                     std::to_string(view.size));
    }
    return view.data + offset;
}

/// Any stride that holds an element can be read, also one that is no multiple of 4.
std::uint64_t strideOf(const BufferView& view, const Checked& checked) {
    if (view.byteStride == 0) return checked.elementSize;
    if (view.byteStride < checked.elementSize) {
        checked.fail("has elements of " + std::to_string(checked.elementSize) + " bytes at a byteStride of " +
                     std::to_string(view.byteStride));
    }
    return view.byteStride;
}

/// Elements as they lie in a buffer; `first` is null where there is no buffer, which stands for zeros.
struct Elements {
    const std::uint8_t* first = nullptr;
    std::uint64_t stride = 0;
};

Elements findElements(const Document& document, const Checked& checked) {
    const tinygltf::Accessor& accessor = checked.accessor;
    if (accessor.bufferView < 0) {
        if (accessor.count <= maxElementsWithoutView) return {};
        checked.fail("has no bufferView and " + std::to_string(accessor.count) +
                     " elements, expected at most " + std::to_string(maxElementsWithoutView));
    }
    const auto viewIndex = static_cast<std::size_t>(accessor.bufferView);
    const Bytes view = viewBytes(document, viewIndex, checked.element);
    const std::uint64_t stride = strideOf(document.bufferViews[viewIndex], checked);
    return {elementsAt(view, accessor.byteOffset, stride, checked.elementSize, accessor.count, checked,
                       "has elements that"),
            stride};
}

/// A copy of the elements, one after the other.
std::vector<std::uint8_t> packedElements(const Elements& elements, const Checked& checked) {
    const std::uint64_t size = checked.elementSize, count = checked.accessor.count;
    std::vector<std::uint8_t> packed(size * count);
    if (!elements.first) return packed;
    for (std::uint64_t i = 0; i < count; ++i) {
        std::memcpy(packed.data() + i * size, elements.first + i * elements.stride, size);
    }
    return packed;
}

std::uint32_t unsignedAt(const std::uint8_t* bytes, std::uint64_t index, std::uint64_t size) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes + index * size, size);
    return value;
}

void applySparse(const Document& document, const Checked& checked, std::vector<std::uint8_t>& packed) {
    const auto& sparse = checked.accessor.sparse;
    const auto count = static_cast<std::uint64_t>(sparse.count);
    if (count == 0) return;
    const Encoding encoding{sparse.indices.componentType, false};
    if (!contains(indexEncodings, encoding)) {
        checked.fail("has sparse indices of " + encodingName(encoding) + ", expected " +
                     expectation(1, indexEncodings));
    }
    const std::uint64_t indexSize = componentSize(encoding.componentType), size = checked.elementSize;
    const Bytes indexView =
        viewBytes(document, static_cast<std::size_t>(sparse.indices.bufferView), checked.element);
    const Bytes valueView =
        viewBytes(document, static_cast<std::size_t>(sparse.values.bufferView), checked.element);
    const std::uint8_t* indices = elementsAt(indexView, static_cast<std::uint64_t>(sparse.indices.byteOffset),
                                             indexSize, indexSize, count, checked, "has sparse indices that");
    const std::uint8_t* values = elementsAt(valueView, static_cast<std::uint64_t>(sparse.values.byteOffset),
                                            size, size, count, checked, "has sparse values that");
    std::uint64_t minIndex = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t index = unsignedAt(indices, i, indexSize);
        if (index < minIndex || index >= checked.accessor.count) {
            checked.fail("has the sparse index " + std::to_string(index) + " at position " +
                         std::to_string(i) + ", expected indices that grow and lie below " +
                         std::to_string(checked.accessor.count));
        }
        std::memcpy(packed.data() + index * size, values + i * size, size);
        minIndex = index + 1;
    }
}

/// The elements of an accessor: where they lie in a buffer, or, of a sparse one, in memory of its own.
struct StoredElements {
    Elements elements;
    std::vector<std::uint8_t> memory = {};
};

StoredElements storedElements(const Document& document, const Checked& checked) {
    StoredElements stored{findElements(document, checked)};
    if (!checked.accessor.sparse.isSparse) return stored;
    stored.memory = packedElements(stored.elements, checked);
    applySparse(document, checked, stored.memory);
    stored.elements = {stored.memory.data(), checked.elementSize};
    return stored;
}

/// Whether numbers of type Stored lie one after the other where they can be read as such.
template <typename Stored>
bool areInPlace(const Elements& elements, const Checked& checked) {
    const bool isAligned = reinterpret_cast<std::uintptr_t>(elements.first) % alignof(Stored) == 0;
    return elements.first && isAligned && elements.stride == checked.elementSize;
}

/// Calls `visit` for each number of the elements, of `components` each, which are there.
template <typename Stored, typename Visit>
void forEachNumber(const Elements& elements, std::uint64_t count, int components, const Visit& visit) {
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint8_t* number = elements.first + i * elements.stride;
        for (int c = 0; c < components; ++c, number += sizeof(Stored)) {
            Stored stored;
            std::memcpy(&stored, number, sizeof(Stored));
            visit(stored);
        }
    }
}

/// The numbers of the elements as they are, where they are if they lie in a buffer as such.
template <typename Stored>
Numbers<Stored> plainNumbers(StoredElements&& stored, const Checked& checked, int components) {
    const std::uint64_t count = checked.accessor.count * static_cast<std::uint64_t>(components);
    const Elements& elements = stored.elements;
    if (!elements.first) return Numbers(std::vector<Stored>(count));
    if (stored.memory.empty() && areInPlace<Stored>(elements, checked))
        return Numbers(std::span(reinterpret_cast<const Stored*>(elements.first), count));
    std::vector<Stored> numbers;
    numbers.reserve(count);
    forEachNumber<Stored>(elements, checked.accessor.count, components,
                          [&](Stored number) { numbers.push_back(number); });
    return Numbers(std::move(numbers));
}

template <typename Stored>
Numbers<float> toFloats(const Elements& elements, const Checked& checked, int components) {
    std::vector<float> numbers(checked.accessor.count * static_cast<std::uint64_t>(components));
    if (!elements.first) return Numbers(std::move(numbers));
    // It means nothing for 32 bits.
    const bool normalized = checked.accessor.normalized && sizeof(Stored) < 4;
    const float scale = normalized ? 1.0f / static_cast<float>(std::numeric_limits<Stored>::max()) : 1.0f;
    float* out = numbers.data();
    forEachNumber<Stored>(elements, checked.accessor.count, components, [&](Stored stored) {
        const float value = static_cast<float>(stored) * scale;
        // The minimum has no positive counterpart and is -1 as well.
        *out++ = normalized ? std::max(value, -1.0f) : value;
    });
    return Numbers(std::move(numbers));
}

Numbers<float> floatsOf(StoredElements&& stored, const Checked& checked, int components) {
    const Elements& elements = stored.elements;
    switch (checked.accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return toFloats<std::int8_t>(elements, checked, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return toFloats<std::uint8_t>(elements, checked, components);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return toFloats<std::int16_t>(elements, checked, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return toFloats<std::uint16_t>(elements, checked, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return toFloats<std::uint32_t>(elements, checked, components);
        default:
            return plainNumbers<float>(std::move(stored), checked, components);
    }
}

template <typename Stored>
Numbers<std::uint32_t> widened(const Elements& elements, const Checked& checked) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(checked.accessor.count);
    if (!elements.first)
        numbers.resize(checked.accessor.count);
    else
        forEachNumber<Stored>(elements, checked.accessor.count, 1,
                              [&](Stored number) { numbers.push_back(number); });
    return Numbers(std::move(numbers));
}

void requireFinite(std::span<const float> numbers, int components, const Checked& checked) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (std::isfinite(numbers[i])) continue;
        checked.fail("has a number in element " + std::to_string(i / static_cast<std::size_t>(components)) +
                     " that is not finite");
    }
}

}  // namespace

int componentCount(const tinygltf::Accessor& accessor) {
    return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
}

void requireAccessor(const Document& document, int accessor, const std::string& element) {
    const auto index = static_cast<std::size_t>(accessor);
    requireUsable(document, elementName("accessor", index, document.model.accessors.at(index).name), element);
}

void checkAccessor(const Document& document, int accessor, int components, Encodings allowed,
                   const std::string& element) {
    const Checked checked = check(document, accessor, components, allowed, element);
    findElements(document, checked);
    // Whether the values of a sparse accessor fit is found out by applying them.
    if (checked.accessor.sparse.isSparse) storedElements(document, checked);
}

Numbers<float> findFloats(const Document& document, int accessor, int components, Encodings allowed,
                          const std::string& element, Finiteness finiteness) {
    const Checked checked = check(document, accessor, components, allowed, element);
    Numbers<float> numbers = floatsOf(storedElements(document, checked), checked, components);
    if (finiteness == Finiteness::required) requireFinite(numbers.view(), components, checked);
    return numbers;
}

std::vector<float> readFloats(const Document& document, int accessor, int components, Encodings allowed,
                              const std::string& element, Finiteness finiteness) {
    return findFloats(document, accessor, components, allowed, element, finiteness).take();
}

Numbers<std::uint32_t> findIndices(const Document& document, int accessor, const std::string& element) {
    const Checked checked = check(document, accessor, 1, indexEncodings, element);
    StoredElements stored = storedElements(document, checked);
    switch (checked.elementSize) {
        case 1:
            return widened<std::uint8_t>(stored.elements, checked);
        case 2:
            return widened<std::uint16_t>(stored.elements, checked);
        default:
            return plainNumbers<std::uint32_t>(std::move(stored), checked, 1);
    }
}

}  // namespace candela_plugins::gltf
