#include "compressed_primitives.h"

#include <draco/compression/decode.h>

#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "accessor.h"
#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

/// The sizes that the header of a Draco stream claims. Draco allocates by them before it looks at the rest.
/// "Draco Bitstream Specification", 2017, sections 4.1 and 5.
class HeaderReader {
  public:
    explicit HeaderReader(const Bytes& stream) : stream_(stream) {}

    /// The sum of vertices and faces; none where the header is cut off, or of a kind that glTF does not
    /// allow.
    std::optional<std::uint64_t> elementCount() {
        if (stream_.size < fixedSize || std::memcmp(stream_.data, "DRACO", 5) != 0) return std::nullopt;
        const int major = stream_.data[5], minor = stream_.data[6];
        const std::uint8_t geometry = stream_.data[7], method = stream_.data[8];
        const bool hasMetadata = (stream_.data[10] & 0x80) != 0;
        if (major != 2 || geometry != triangularMesh || hasMetadata) return std::nullopt;
        variableLength_ = minor >= 2;
        if (method == edgebreaker) at_ += 1;  // The kind of traversal.
        const std::optional<std::uint64_t> first = number(), second = number();
        if (!first || !second) return std::nullopt;
        return *first + *second;
    }

  private:
    static constexpr std::uint64_t fixedSize = 11;
    static constexpr std::uint8_t triangularMesh = 1, edgebreaker = 1;

    std::optional<std::uint64_t> number() {
        std::uint64_t value = 0;
        const int maxBytes = variableLength_ ? 5 : 4, bits = variableLength_ ? 7 : 8;
        for (int i = 0; i < maxBytes; ++i) {
            if (at_ >= stream_.size) return std::nullopt;
            const std::uint8_t byte = stream_.data[at_++];
            value |= std::uint64_t(variableLength_ ? byte & 0x7F : byte) << bits * i;
            if (variableLength_ && (byte & 0x80) == 0) break;
        }
        return value;
    }

    const Bytes& stream_;
    std::uint64_t at_ = fixedSize;
    bool variableLength_ = true;
};

/// A flat grid of a million vertices takes a few hundred bytes a thousand vertices at least.
void checkSize(const Bytes& stream) {
    constexpr std::uint64_t maxElementsPerByte = 4096;
    const std::optional<std::uint64_t> count = HeaderReader(stream).elementCount();
    if (count && *count > stream.size * maxElementsPerByte) {
        throw Failure{"", std::to_string(stream.size) + " compressed bytes cannot hold " +
                              std::to_string(*count) + " vertices and faces"};
    }
}

/// An accessor with data of its own.
struct DecodedAccessor {
    std::string attribute;
    int type, componentType;
    bool normalized;
    std::size_t count;
    std::vector<std::uint8_t> bytes;
};

template <typename Component>
std::vector<std::uint8_t> convert(const draco::PointAttribute& source, std::uint32_t points, int components) {
    const auto size = static_cast<std::size_t>(components) * sizeof(Component);
    std::vector<std::uint8_t> bytes(points * size);
    std::vector<Component> element(static_cast<std::size_t>(components));
    for (std::uint32_t i = 0; i < points; ++i) {
        const draco::AttributeValueIndex value = source.mapped_index(draco::PointIndex(i));
        if (!source.ConvertValue<Component>(value, static_cast<std::int8_t>(components), element.data()))
            throw Failure{"", "the compressed data is damaged"};
        std::memcpy(&bytes[i * size], element.data(), size);
    }
    return bytes;
}

std::vector<std::uint8_t> convert(const draco::PointAttribute& source, std::uint32_t points, int components,
                                  int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return convert<std::int8_t>(source, points, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return convert<std::uint8_t>(source, points, components);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return convert<std::int16_t>(source, points, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return convert<std::uint16_t>(source, points, components);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return convert<std::uint32_t>(source, points, components);
        default:
            return convert<float>(source, points, components);
    }
}

DecodedAccessor decodeIndices(const draco::Mesh& mesh) {
    std::vector<std::uint8_t> bytes(std::size_t(mesh.num_faces()) * 3 * sizeof(std::uint32_t));
    for (std::uint32_t face = 0; face < mesh.num_faces(); ++face) {
        const draco::Mesh::Face& corners = mesh.face(draco::FaceIndex(face));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = corners[corner].value();
            std::memcpy(&bytes[(std::size_t(face) * 3 + corner) * sizeof vertex], &vertex, sizeof vertex);
        }
    }
    return {indicesAttribute,
            TINYGLTF_TYPE_SCALAR,
            TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
            false,
            std::size_t(mesh.num_faces()) * 3,
            std::move(bytes)};
}

std::unique_ptr<draco::Mesh> decodeMesh(const Bytes& stream) {
    checkSize(stream);
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(stream.data), stream.size);
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
        throw Failure{"", "the compressed data is damaged (" + decoded.status().error_msg_string() + ")"};
    std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    if (mesh->num_faces() == 0 || mesh->num_points() == 0) throw Failure{"", "no triangles"};
    return mesh;
}

std::vector<DecodedAccessor> decode(const Document& document, const tinygltf::Primitive& primitive,
                                    const CompressedPrimitive& compressed, const std::string& element) {
    const Bytes stream = viewBytes(document, compressed.bufferView, element);
    const std::unique_ptr<draco::Mesh> mesh = decodeMesh(stream);
    std::vector<DecodedAccessor> accessors{decodeIndices(*mesh)};
    for (const auto& [name, id] : compressed.attributes) {
        const int index = accessorOf(primitive, name);
        if (index < 0) continue;
        const draco::PointAttribute* source = mesh->GetAttributeByUniqueId(id);
        if (!source) throw Failure{"", "attribute " + std::to_string(id) + " does not exist"};
        const tinygltf::Accessor& accessor = document.model.accessors.at(static_cast<std::size_t>(index));
        accessors.push_back(
            {name, accessor.type, accessor.componentType, accessor.normalized, mesh->num_points(),
             convert(*source, mesh->num_points(), componentCount(accessor), accessor.componentType)});
    }
    return accessors;
}

/// A primitive to be decoded, and what becomes of it.
struct Job {
    tinygltf::Primitive* primitive;
    const CompressedPrimitive* compressed;
    std::string element;
    std::vector<DecodedAccessor> accessors;
    std::optional<Failure> failure;
};

std::vector<Job> jobsOf(Document& document, const std::vector<bool>& used) {
    std::vector<Job> jobs;
    for (const auto& [place, compressed] : document.compressedPrimitives) {
        const auto& [meshIndex, primitiveIndex] = place;
        if (!used.at(meshIndex)) continue;
        tinygltf::Mesh& mesh = document.model.meshes.at(meshIndex);
        jobs.push_back(
            {&mesh.primitives.at(primitiveIndex),
             &compressed,
             elementName("mesh", meshIndex, mesh.name) + ", primitive " + std::to_string(primitiveIndex),
             {},
             {}});
    }
    return jobs;
}

void addAccessor(Document& document, tinygltf::Primitive& primitive, DecodedAccessor&& decoded,
                 Storage& storage) {
    const std::vector<std::uint8_t>& bytes = storage.emplace_back(std::move(decoded.bytes));
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(document.bufferViews.size());
    accessor.type = decoded.type;
    accessor.componentType = decoded.componentType;
    accessor.normalized = decoded.normalized;
    accessor.count = decoded.count;
    BufferView view;
    view.byteLength = bytes.size();
    view.decoded = Bytes{bytes.data(), bytes.size()};
    document.bufferViews.push_back(std::move(view));
    primitive.attributes[decoded.attribute] = static_cast<int>(document.model.accessors.size());
    document.model.accessors.push_back(std::move(accessor));
}

bool hasPlainData(const Document& document, const tinygltf::Primitive& primitive) {
    const int position = accessorOf(primitive, "POSITION");
    if (position < 0) return false;
    const tinygltf::Accessor& accessor = document.model.accessors.at(static_cast<std::size_t>(position));
    return accessor.bufferView >= 0 || accessor.sparse.isSparse;
}

void finish(Document& document, Job& job, Storage& storage, const Host& host) {
    if (!job.failure) {
        for (DecodedAccessor& decoded : job.accessors)
            addAccessor(document, *job.primitive, std::move(decoded), storage);
        job.primitive->mode = TINYGLTF_MODE_TRIANGLES;
        return;
    }
    const std::string where = job.element + ", KHR_draco_mesh_compression";
    const std::string& reason = job.failure->reason;
    if (hasPlainData(document, *job.primitive)) {
        host.note(CANDELA_NOTE_REPAIRED, where, reason + ": the uncompressed data is read");
    } else {
        document.faults.emplace(job.element, Failure{where, reason});
    }
}

}  // namespace

void decodePrimitives(Document& document, const std::vector<bool>& used, Storage& storage, const Host& host) {
    std::vector<Job> jobs = jobsOf(document, used);
    host.parallelFor(jobs.size(), [&](std::size_t i) {
        Job& job = jobs[i];
        try {
            job.accessors = decode(document, *job.primitive, *job.compressed, job.element);
        } catch (const Failure& failure) {
            job.failure = failure;
        }
    });
    for (Job& job : jobs) finish(document, job, storage, host);
}

}  // namespace candela_plugins::gltf
