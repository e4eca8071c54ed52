#include "images.h"

#include <algorithm>
#include <climits>
#include <cstring>
#include <string_view>

namespace candela_gltf {
namespace {

constexpr std::uint8_t pngSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::uint8_t jpegSignature[] = {0xFF, 0xD8, 0xFF};

template <std::size_t size>
bool startsWith(const Bytes& bytes, const std::uint8_t (&signature)[size]) {
    return bytes.size >= size && std::memcmp(bytes.data, signature, size) == 0;
}

/// The decoder fills the missing part of a cut JPEG with grey and says nothing.
bool hasJpegEnd(const Bytes& bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data), bytes.size);
    return text.rfind("\xFF\xD9") != std::string_view::npos;
}

void markTexture(const Document& document, int texture, std::vector<bool>& used) {
    if (texture < 0) return;
    const int image = document.model.textures.at(static_cast<std::size_t>(texture)).source;
    if (image >= 0) used.at(static_cast<std::size_t>(image)) = true;
}

std::vector<bool> imagesInUse(const Document& document) {
    std::vector<bool> used(document.imageSources.size());
    for (const tinygltf::Material& material : document.model.materials) {
        markTexture(document, material.pbrMetallicRoughness.baseColorTexture.index, used);
        markTexture(document, material.pbrMetallicRoughness.metallicRoughnessTexture.index, used);
        markTexture(document, material.normalTexture.index, used);
        markTexture(document, material.occlusionTexture.index, used);
        markTexture(document, material.emissiveTexture.index, used);
    }
    return used;
}

Bytes fileOf(const Document& document, const Source& source, const std::string& element, Storage& storage,
             const Host& host) {
    if (source.uri && source.bufferView) throw Failure{element, "has both a URI and a bufferView"};
    if (source.uri) return loadUri(*source.uri, element, storage, host);
    if (source.bufferView) return viewBytes(document, *source.bufferView, element);
    throw Failure{element, "has neither a URI nor a bufferView"};
}

tinygltf::Image decode(const Bytes& file, const std::string& element) {
    const bool png = startsWith(file, pngSignature), jpeg = startsWith(file, jpegSignature);
    if (!png && !jpeg) throw Failure{element, "is neither a PNG nor a JPEG file"};
    if (jpeg && !hasJpegEnd(file)) throw Failure{element, "the JPEG file is cut off"};
    if (file.size > INT_MAX) throw Failure{element, "is larger than 2 GiB"};
    tinygltf::Image image;
    std::string errors, warnings;
    const bool decoded = tinygltf::LoadImageData(&image, 0, &errors, &warnings, 0, 0, file.data,
                                                 static_cast<int>(file.size), nullptr);
    if (!decoded) throw Failure{element, std::string("the ") + (png ? "PNG" : "JPEG") + " file is broken"};
    return image;
}

std::int32_t push(const Source& source, const tinygltf::Image& image, const Host& host) {
    candela_image pushed{};
    pushed.struct_size = sizeof pushed;
    pushed.name = source.name.c_str();
    pushed.width = static_cast<std::uint32_t>(image.width);
    pushed.height = static_cast<std::uint32_t>(image.height);
    pushed.format = image.bits == 16 ? CANDELA_PIXELS_RGBA16 : CANDELA_PIXELS_RGBA8;
    pushed.pixels = image.image.data();
    pushed.pixels_size = image.image.size();
    return host.add(pushed);
}

}  // namespace

std::vector<std::int32_t> pushImages(const Document& document, Storage& storage, const Host& host,
                                     double from, double to) {
    const std::vector<bool> used = imagesInUse(document);
    const auto count = static_cast<double>(used.size());
    std::vector<std::int32_t> indices(used.size(), -1);
    for (std::size_t i = 0; i < used.size(); ++i) {
        host.progress(from + (to - from) * static_cast<double>(i) / count);
        if (!used[i]) continue;
        const Source& source = document.imageSources[i];
        const std::string element = elementName("image", i, source.name);
        const Bytes file = fileOf(document, source, element, storage, host);
        indices[i] = push(source, decode(file, element), host);
    }
    return indices;
}

}  // namespace candela_gltf
