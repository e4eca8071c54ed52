#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace candela_test {

using Bytes = std::vector<std::uint8_t>;

std::string base64(const Bytes& bytes);
/// The bytes of a text of base64.
Bytes fromBase64(const std::string& text);

template <typename T>
Bytes bytesOf(const std::vector<T>& values) {
    Bytes bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

template <typename T>
constexpr int componentTypeOf();
template <>
constexpr int componentTypeOf<std::int8_t>() {
    return 5120;
}
template <>
constexpr int componentTypeOf<std::uint8_t>() {
    return 5121;
}
template <>
constexpr int componentTypeOf<std::int16_t>() {
    return 5122;
}
template <>
constexpr int componentTypeOf<std::uint16_t>() {
    return 5123;
}
template <>
constexpr int componentTypeOf<std::uint32_t>() {
    return 5125;
}
template <>
constexpr int componentTypeOf<float>() {
    return 5126;
}

/// Builds a glTF document. Elements are added as JSON text; binary data is appended to buffer 0.
class GltfFile {
  public:
    /// Adds an element to an array of the document ("nodes") and returns its index.
    int add(const std::string& array, const std::string& object);
    /// Sets a member of the document, as JSON text.
    void set(const std::string& member, const std::string& value) { members_[member] = value; }

    /// Adds a buffer view of `bytes`; `more` are further JSON members, such as "\"byteStride\":16".
    int addView(const Bytes& bytes, const std::string& more = "");
    /// Adds an accessor; `view` -1 for none.
    int addAccessor(int view, const std::string& type, int componentType, std::size_t count,
                    const std::string& more = "");
    /// Adds a buffer view and an accessor over `values`.
    template <typename T>
    int addData(const std::string& type, const std::vector<T>& values, const std::string& more = "") {
        const std::size_t components = type == "SCALAR" ? 1
                                       : type == "MAT4" ? 16
                                                        : static_cast<std::size_t>(type[3] - '0');
        return addAccessor(addView(bytesOf(values)), type, componentTypeOf<T>(), values.size() / components,
                           more);
    }
    /// Adds a mesh of one primitive, given by its members, and a node that instances it.
    int addMeshNode(const std::string& primitive, const std::string& name = "");

    /// The document with the binary data in a data URI.
    std::string text() const;
    /// The document with the binary data in the file `uri`.
    std::string textWithBufferFile(const std::string& uri) const;
    Bytes binary() const { return binary_; }
    Bytes glb() const;

  private:
    std::string document(const std::string& bufferUri) const;

    std::map<std::string, std::vector<std::string>> arrays_;
    std::map<std::string, std::string> members_{{"asset", R"({"version":"2.0"})"}};
    Bytes binary_;
};

/// A .glb file of these chunks.
Bytes makeGlb(std::string json, Bytes binary);

/// A triangle in the plane z = 0 with normals along +Z: accessors for POSITION and NORMAL.
struct TriangleAccessors {
    int positions, normals;
};
TriangleAccessors addTriangle(GltfFile& file);

/// A file with such a triangle as mesh 0, instanced by node 0. `members` are further members of its
/// primitive, such as "\"material\":0".
GltfFile triangleFile(const std::string& members = "");

}  // namespace candela_test
