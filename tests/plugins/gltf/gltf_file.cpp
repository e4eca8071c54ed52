#include "gltf_file.h"

#include <algorithm>

namespace candela_test {
namespace {

void append32(Bytes& out, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::string withComma(const std::string& members) {
    return members.empty() ? members : "," + members;
}

}  // namespace

std::string base64(const Bytes& bytes) {
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

Bytes fromBase64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    Bytes bytes;
    std::uint32_t group = 0, bits = 0;
    for (const char c : text.substr(0, text.find('='))) {
        group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(group >> bits));
    }
    return bytes;
}

int GltfFile::add(const std::string& array, const std::string& object) {
    arrays_[array].push_back(object);
    return static_cast<int>(arrays_[array].size()) - 1;
}

int GltfFile::addView(const Bytes& bytes, const std::string& more) {
    binary_.resize((binary_.size() + 3) / 4 * 4);
    const std::size_t offset = binary_.size();
    binary_.insert(binary_.end(), bytes.begin(), bytes.end());
    return add("bufferViews", "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
                                  ",\"byteLength\":" + std::to_string(bytes.size()) + withComma(more) + "}");
}

int GltfFile::addAccessor(int view, const std::string& type, int componentType, std::size_t count,
                          const std::string& more) {
    const std::string viewMember = view < 0 ? "" : "\"bufferView\":" + std::to_string(view) + ",";
    return add("accessors", "{" + viewMember + "\"type\":\"" + type +
                                "\",\"componentType\":" + std::to_string(componentType) +
                                ",\"count\":" + std::to_string(count) + withComma(more) + "}");
}

int GltfFile::addMeshNode(const std::string& primitive, const std::string& name) {
    const std::string nameMember = name.empty() ? "" : "\"name\":\"" + name + "\",";
    const int mesh = add("meshes", "{" + nameMember + "\"primitives\":[{" + primitive + "}]}");
    add("nodes", "{\"mesh\":" + std::to_string(mesh) + "}");
    return mesh;
}

std::string GltfFile::document(const std::string& bufferUri) const {
    std::string text = "{";
    for (const auto& [member, value] : members_) text += "\"" + member + "\":" + value + ",";
    for (const auto& [array, elements] : arrays_) {
        text += "\"" + array + "\":[";
        for (const std::string& element : elements) text += element + ",";
        text.back() = ']';
        text += ",";
    }
    if (!binary_.empty() && !arrays_.contains("buffers")) {
        const std::string uri = bufferUri.empty() ? "" : ",\"uri\":\"" + bufferUri + "\"";
        text += "\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + uri + "}],";
    }
    text.back() = '}';
    return text;
}

std::string GltfFile::text() const {
    return document("data:application/octet-stream;base64," + base64(binary_));
}

std::string GltfFile::textWithBufferFile(const std::string& uri) const {
    return document(uri);
}

Bytes GltfFile::glb() const {
    return makeGlb(document(""), binary_);
}

Bytes makeGlb(std::string json, Bytes binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    Bytes out{'g', 'l', 'T', 'F'};
    append32(out, 2);
    append32(out, 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size()));
    append32(out, json.size());
    append32(out, 0x4E4F534A);
    out.insert(out.end(), json.begin(), json.end());
    if (binary.empty()) return out;
    append32(out, binary.size());
    append32(out, 0x004E4942);
    out.insert(out.end(), binary.begin(), binary.end());
    return out;
}

TriangleAccessors addTriangle(GltfFile& file) {
    const int positions = file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = file.addData<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    return {positions, normals};
}

GltfFile triangleFile(const std::string& members) {
    GltfFile file;
    addTriangle(file);
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1})" + withComma(members));
    return file;
}

}  // namespace candela_test
