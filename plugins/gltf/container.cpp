#include "container.h"

#include <cstring>

namespace candela_gltf {
namespace {

constexpr std::uint64_t headerSize = 12, chunkHeaderSize = 8;
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

std::uint32_t littleEndian32(const std::uint8_t* p) {
    return p[0] | std::uint32_t(p[1]) << 8 | std::uint32_t(p[2]) << 16 | std::uint32_t(p[3]) << 24;
}

[[noreturn]] void failBinary(const std::string& reason) {
    throw Failure{"binary glTF", reason};
}

struct Chunk {
    std::uint32_t type = 0;
    Bytes content;
};

Chunk readChunk(const Bytes& file, std::uint64_t offset, int number) {
    const std::string which = "chunk " + std::to_string(number);
    if (file.size - offset < chunkHeaderSize) failBinary(which + " is cut off within its header");
    const std::uint64_t length = littleEndian32(file.data + offset);
    const std::uint64_t available = file.size - offset - chunkHeaderSize;
    if (length > available) {
        failBinary(which + " has a length of " + std::to_string(length) + " bytes, but only " +
                   std::to_string(available) + " are left");
    }
    if (length % 4 != 0) failBinary(which + " has a length that is not a multiple of 4");
    return {littleEndian32(file.data + offset + 4), {file.data + offset + chunkHeaderSize, length}};
}

Container openBinary(Bytes file) {
    if (file.size < headerSize) failBinary("the file is cut off within its header");
    const std::uint32_t version = littleEndian32(file.data + 4);
    if (version != 2) failBinary("container version " + std::to_string(version) + ", expected 2");
    const std::uint64_t length = littleEndian32(file.data + 8);
    if (length < headerSize || length > file.size) {
        failBinary("the header tells of " + std::to_string(length) + " bytes, the file has " +
                   std::to_string(file.size));
    }
    file.size = length;

    const Chunk first = readChunk(file, headerSize, 0);
    if (first.type != jsonChunk) failBinary("chunk 0 is not of type JSON");
    Container container{first.content, std::nullopt};
    const std::uint64_t next = headerSize + chunkHeaderSize + first.content.size;
    if (next == file.size) return container;
    // Only the second chunk may be BIN; what follows it belongs to extensions.
    const Chunk second = readChunk(file, next, 1);
    if (second.type == binaryChunk) container.binary = second.content;
    return container;
}

}  // namespace

Container openContainer(const Bytes& file) {
    const bool binary = file.size >= 4 && std::memcmp(file.data, "glTF", 4) == 0;
    return binary ? openBinary(file) : Container{file, std::nullopt};
}

}  // namespace candela_gltf
