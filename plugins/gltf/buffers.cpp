#include "buffers.h"

#include "uri.h"

namespace candela_gltf {
namespace {

Bytes findBytes(const Source& source, std::size_t index, const std::string& element,
                const Container& container, Storage& storage, const Host& host) {
    if (source.uri) return loadUri(*source.uri, element, storage, host);
    // Only the first buffer may stand for the BIN chunk (glTF 2.0, 4.4.3.3).
    if (index == 0 && container.binary) return *container.binary;
    throw Failure{element, index == 0 ? "has no URI, and the file has no BIN chunk" : "has no URI"};
}

}  // namespace

Bytes loadUri(const std::string& uri, const std::string& element, Storage& storage, const Host& host) {
    if (!isDataUri(uri)) return host.readFile(pathOfUri(uri, element));
    const std::vector<std::uint8_t>& data = storage.emplace_back(decodeDataUri(uri, element));
    return {data.data(), data.size()};
}

void loadBuffers(Document& document, const Container& container, Storage& storage, const Host& host) {
    for (std::size_t i = 0; i < document.bufferSources.size(); ++i) {
        Source& source = document.bufferSources[i];
        const std::string element = elementName("buffer", i, source.name);
        const Bytes bytes = findBytes(source, i, element, container, storage, host);
        if (bytes.size < source.byteLength) {
            throw Failure{element, "holds " + std::to_string(bytes.size) +
                                       " bytes, expected byteLength = " + std::to_string(source.byteLength)};
        }
        document.buffers.push_back({bytes.data, source.byteLength});
        source.uri.reset();
    }
}

Bytes viewBytes(const Document& document, std::size_t bufferView, const std::string& element) {
    const tinygltf::BufferView& view = document.model.bufferViews.at(bufferView);
    const Bytes& buffer = document.buffers.at(static_cast<std::size_t>(view.buffer));
    if (view.byteOffset > buffer.size || view.byteLength > buffer.size - view.byteOffset) {
        throw Failure{element, "bufferView " + std::to_string(bufferView) + " ends at byte " +
                                   std::to_string(view.byteOffset + view.byteLength) + ", but buffer " +
                                   std::to_string(view.buffer) + " has " + std::to_string(buffer.size)};
    }
    return {buffer.data + view.byteOffset, view.byteLength};
}

}  // namespace candela_gltf
