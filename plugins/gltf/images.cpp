#include "images.h"

#include "../common/push_picture.h"

namespace candela_gltf {
namespace {

using namespace candela_importers;

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

Picture decode(const Bytes& file, const std::string& element) {
    if (isPng(file)) return decodePng(file, element);
    if (isJpeg(file)) return decodeJpeg(file, element);
    throw Failure{element, "is neither a PNG nor a JPEG file"};
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
        indices[i] = pushPicture(source.name, decode(file, element), host);
    }
    return indices;
}

}  // namespace candela_gltf
