#include "render/gpu_scene/gpu_meshes.h"

#include "base/runs.h"
#include "render/gpu_scene/mesh_vertices.h"
#include "render/layout.h"
#include "scene/model/uv_sets.h"

#include <candela/error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace candela {

namespace {

void requireCounts(std::uint64_t vertices, std::uint64_t indices) {
    if (vertices <= std::numeric_limits<std::int32_t>::max() &&
        indices <= std::numeric_limits<std::uint32_t>::max()) {
        return;
    }
    throw Error(ErrorKind::limit, "",
                "the scene has " + std::to_string(vertices) + " vertices and " + std::to_string(indices) +
                    " indices; candela draws 2,147,483,647 and 4,294,967,295 at most");
}

/// A buffer of `elements`, each `count` values of type T; `write` gets a mesh, the first of its own elements
/// and where to write values.
template <typename T, typename Write>
gl::Buffer bufferOf(const char* label, const MeshElements& elements, std::size_t count,
                    GpuMeshes::Access access, const Write& write) {
    const std::size_t size = count * sizeof(T);
    const auto fill = [&](std::size_t offset, std::span<std::byte> bytes) {
        T* const values = reinterpret_cast<T*>(bytes.data());
        const std::size_t first = offset / size;
        elements.visit(first, first + bytes.size() / size, [&](const MeshElements::Run& run) {
            write(run.mesh, run.firstOfMesh,
                  std::span(values + (run.first - first) * count, run.count * count));
        });
    };
    const gl::Buffer::Layout layout{elements.count(), size};
    return access == GpuMeshes::Access::deviceAndCpu ? gl::Buffer::filledMapped(label, layout, fill)
                                                     : gl::Buffer::filled(label, layout, fill);
}

std::vector<glm::vec3> positionsIn(const gl::Buffer& surface, std::size_t first, std::size_t count) {
    const auto vertices = surface.read<SurfaceVertex>(first, count);
    std::vector<glm::vec3> positions(count);
    for (std::size_t i = 0; i < count; ++i) positions[i] = vertices[i].position;
    return positions;
}

// A tangent or a coordinate pair starts at the first float, a colour at the fifth.
constexpr std::array<float, 8> detail{0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f, 1.0f};
constexpr std::size_t colorOffset = 4 * sizeof(float);

}  // namespace

void feedFloats(const gl::VertexArray& vertexArray, int location, int components, GLuint binding,
                std::size_t offset) {
    const GLuint name = vertexArray.name();
    const auto index = static_cast<GLuint>(location);
    glEnableVertexArrayAttrib(name, index);
    glVertexArrayAttribFormat(name, index, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(name, index, binding);
}

void feedDraws(const gl::VertexArray& vertexArray, GLuint binding, const gl::Buffer& draws) {
    const GLuint name = vertexArray.name();
    glVertexArrayVertexBuffer(name, binding, draws.name(), 0, 3 * sizeof(std::uint32_t));
    glVertexArrayBindingDivisor(name, binding, 1);
    glEnableVertexArrayAttrib(name, layout::DRAW_ATTRIBUTE);
    glVertexArrayAttribIFormat(name, layout::DRAW_ATTRIBUTE, 3, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(name, layout::DRAW_ATTRIBUTE, binding);
}

DefaultDetail::DefaultDetail()
    : vertex_(gl::Buffer::immutable("default detail", std::span<const float>(detail))) {}

void DefaultDetail::describe(const gl::VertexArray& vertexArray, GLuint binding) const {
    // A stride of 0 gives every vertex the same element.
    glVertexArrayVertexBuffer(vertexArray.name(), binding, vertex_.name(), 0, 0);
    feedFloats(vertexArray, layout::TANGENT_ATTRIBUTE, 4, binding, 0);
    feedFloats(vertexArray, layout::UV0_ATTRIBUTE, 2, binding, 0);
    feedFloats(vertexArray, layout::UV1_ATTRIBUTE, 2, binding, 0);
    feedFloats(vertexArray, layout::COLOR_ATTRIBUTE, 4, binding, colorOffset);
}

GpuMeshes::GpuMeshes(std::span<const Mesh> meshes, Detail detail, Access access)
    : detail_(detail), access_(access), versions_(meshes.size(), 1) {
    place(meshes);
    vertexPool_ = RangePool(vertexCount_);
    indexPool_ = RangePool(indexCount_);
    uploadSurface(meshes);
    if (detail_ != Detail::everything) return;
    uploadDetail(meshes);
    if (furtherPairs_ != 0) uploadFurtherUvs(meshes);
}

void GpuMeshes::place(std::span<const Mesh> meshes) {
    order_.resize(meshes.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::ranges::stable_partition(order_, [&](std::uint32_t i) { return !meshes[i].furtherUvs.empty(); });
    places_.resize(meshes.size());
    forEachElement(
        meshes.size(), [&](std::size_t i) { return meshes[i].positions.size(); },
        [&](std::size_t i) { places_[i].sphere = boundingSphere(meshes[i].positions); });
    for (const std::uint32_t i : order_) {
        const Mesh& mesh = meshes[i];
        places_[i].firstIndex = static_cast<std::uint32_t>(indexCount_);
        places_[i].baseVertex = static_cast<std::int32_t>(vertexCount_);
        places_[i].vertexCount = static_cast<std::uint32_t>(mesh.positions.size());
        places_[i].indexCount = static_cast<std::uint32_t>(mesh.indices.size());
        vertexCount_ += mesh.positions.size();
        indexCount_ += mesh.indices.size();
        if (detail_ != Detail::everything || mesh.furtherUvs.empty()) continue;
        furtherVertices_ = vertexCount_;
        furtherPairs_ = std::max(furtherPairs_, (mesh.furtherUvs.size() + 1) / 2);
    }
    requireCounts(vertexCount_, indexCount_);
}

void GpuMeshes::uploadSurface(std::span<const Mesh> meshes) {
    MeshElements vertices, indices;
    for (const std::uint32_t mesh : order_) {
        vertices.append(mesh, places_[mesh].vertexCount);
        indices.append(mesh, places_[mesh].indexCount);
    }
    surface_ = bufferOf<SurfaceVertex>(
        "mesh positions and normals", vertices, 1, access_,
        [&](std::uint32_t mesh, std::size_t first, auto to) { writeSurface(meshes[mesh], first, to); });
    indices_ = bufferOf<std::uint32_t>(
        "mesh indices", indices, 1, access_,
        [&](std::uint32_t mesh, std::size_t first, auto to) { writeIndices(meshes[mesh], first, to); });
}

void GpuMeshes::uploadDetail(std::span<const Mesh> meshes) {
    MeshElements vertices;
    for (const std::uint32_t mesh : order_) vertices.append(mesh, places_[mesh].vertexCount);
    details_ = bufferOf<DetailVertex>(
        "mesh details", vertices, 1, access_,
        [&](std::uint32_t mesh, std::size_t first, auto to) { writeDetails(meshes[mesh], first, to); });
}

void GpuMeshes::uploadFurtherUvs(std::span<const Mesh> meshes) {
    MeshElements vertices;
    for (const std::uint32_t mesh : order_) {
        if (!meshes[mesh].furtherUvs.empty()) vertices.append(mesh, places_[mesh].vertexCount);
    }
    furtherUvs_ = bufferOf<glm::vec2>("further texture coordinates", vertices, 2 * furtherPairs_, access_,
                                      [&](std::uint32_t mesh, std::size_t first, auto to) {
                                          writeFurtherUvs(meshes[mesh], first, furtherPairs_, to);
                                      });
}

GpuMeshes::Buffers GpuMeshes::reserve(std::uint64_t vertices, std::uint64_t indices, MeshPlace& place) {
    const auto grownCapacity = [](std::uint64_t capacity, std::uint64_t more, std::uint64_t max) {
        return std::min(std::max(capacity + capacity / 2, capacity + more), std::max(max, capacity + more));
    };
    RangePool vertexPool = vertexPool_, indexPool = indexPool_;
    std::optional<std::uint64_t> firstVertex = vertexPool.take(vertices),
                                 firstIndex = indexPool.take(indices);
    Buffers result = Buffers::same;
    gl::Buffer surface, details, indexBuffer;
    if (!firstVertex) {
        constexpr std::uint64_t max = std::numeric_limits<std::int32_t>::max();
        vertexPool.growTo(grownCapacity(vertexPool.capacity(), vertices, max));
        requireCounts(vertexPool.capacity(), 0);
        firstVertex = vertexPool.take(vertices);
        surface = gl::Buffer::grown("mesh positions and normals", surface_,
                                    vertexPool.capacity() * sizeof(SurfaceVertex));
        if (hasDetail())
            details =
                gl::Buffer::grown("mesh details", details_, vertexPool.capacity() * sizeof(DetailVertex));
    }
    if (!firstIndex) {
        constexpr std::uint64_t max = std::numeric_limits<std::uint32_t>::max();
        indexPool.growTo(grownCapacity(indexPool.capacity(), indices, max));
        requireCounts(0, indexPool.capacity());
        firstIndex = indexPool.take(indices);
        indexBuffer =
            gl::Buffer::grown("mesh indices", indices_, indexPool.capacity() * sizeof(std::uint32_t));
    }
    const auto replace = [&](gl::Buffer& buffer, gl::Buffer& by) {
        if (by.name() == 0) return;
        buffer = std::move(by);
        result = Buffers::replaced;
    };
    replace(surface_, surface);
    replace(details_, details);
    replace(indices_, indexBuffer);
    vertexPool_ = std::move(vertexPool);
    indexPool_ = std::move(indexPool);
    place.firstIndex = static_cast<std::uint32_t>(*firstIndex);
    place.baseVertex = static_cast<std::int32_t>(*firstVertex);
    return result;
}

void GpuMeshes::write(const MeshPlace& place, const Mesh& mesh) {
    std::vector<SurfaceVertex> surface(place.vertexCount);
    writeSurface(mesh, 0, surface);
    const auto first = static_cast<std::size_t>(place.baseVertex);
    surface_.write(first, std::span<const SurfaceVertex>(surface));
    indices_.write(place.firstIndex, std::span<const std::uint32_t>(mesh.indices));
    if (hasDetail()) {
        std::vector<DetailVertex> details(place.vertexCount);
        writeDetails(mesh, 0, details);
        details_.write(first, std::span<const DetailVertex>(details));
    }
    settle();
}

/// The CPU reads what the device writes.
void GpuMeshes::settle() const {
    if (access_ == Access::deviceAndCpu) glFinish();
}

GpuMeshes::Buffers GpuMeshes::set(std::uint32_t mesh, const Mesh& from) {
    MeshPlace place;
    place.vertexCount = static_cast<std::uint32_t>(from.positions.size());
    place.indexCount = static_cast<std::uint32_t>(from.indices.size());
    place.sphere = boundingSphere(from.positions);
    const Buffers result = reserve(place.vertexCount, place.indexCount, place);
    write(place, from);
    if (mesh >= places_.size()) {
        places_.resize(mesh + 1);
        versions_.resize(mesh + 1);
    }
    remove(mesh);
    places_[mesh] = place;
    return result;
}

void GpuMeshes::remove(std::uint32_t mesh) {
    const MeshPlace& old = places_[mesh];
    vertexPool_.free(static_cast<std::uint64_t>(old.baseVertex), old.vertexCount);
    indexPool_.free(old.firstIndex, old.indexCount);
    places_[mesh] = {};
    ++versions_[mesh];
}

void GpuMeshes::setSurface(std::uint32_t mesh, std::span<const glm::vec3> positions,
                           std::span<const glm::vec3> normals) {
    const auto first = static_cast<std::size_t>(places_[mesh].baseVertex);
    std::vector<SurfaceVertex> vertices(positions.size());
    if (normals.empty()) vertices = surface_.read<SurfaceVertex>(first, positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        vertices[i].position = positions[i];
        if (!normals.empty()) vertices[i].normal = normals[i];
    }
    surface_.write(first, std::span<const SurfaceVertex>(vertices));
    settle();
    places_[mesh].sphere = boundingSphere(positions);
    ++versions_[mesh];
}

void GpuMeshes::copySurface(std::uint32_t mesh, const BufferRange& from, const BoundingSphere& sphere) {
    MeshPlace& place = places_[mesh];
    surface_.copyFrom(from.name, from.offset, static_cast<std::size_t>(place.baseVertex) * surfaceBytes(),
                      place.vertexCount * surfaceBytes());
    settle();
    place.sphere = sphere;
    ++versions_[mesh];
}

std::size_t GpuMeshes::surfaceBytes() {
    return sizeof(SurfaceVertex);
}

std::vector<glm::vec3> GpuMeshes::readPositions(std::uint32_t mesh) const {
    return positionsIn(surface_, static_cast<std::size_t>(places_[mesh].baseVertex),
                       places_[mesh].vertexCount);
}

std::vector<glm::vec3> GpuMeshes::readPositions(std::uint32_t mesh, const DeformedStreams& deformed) const {
    return positionsIn(deformed.surface, 0, places_[mesh].vertexCount);
}

std::vector<std::uint32_t> GpuMeshes::readIndices(const IndexRange& range) const {
    return indices_.read<std::uint32_t>(range.first, range.count);
}

std::vector<GpuMeshes::AlphaVertex> GpuMeshes::readAlphaVertices(std::uint32_t mesh) const {
    const MeshPlace& place = places_[mesh];
    std::vector<AlphaVertex> vertices(place.vertexCount);
    if (detail_ != Detail::everything) return vertices;
    const auto details =
        details_.read<DetailVertex>(static_cast<std::size_t>(place.baseVertex), place.vertexCount);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {details[i].uv0, details[i].uv1, details[i].color.a};
    return vertices;
}

std::vector<glm::vec2> GpuMeshes::readFurtherUvs(std::uint32_t mesh, std::uint32_t set) const {
    const MeshPlace& place = places_[mesh];
    const std::size_t stride = 2 * furtherPairs_;
    const auto all = furtherUvs_.read<glm::vec2>(static_cast<std::size_t>(place.baseVertex) * stride,
                                                 place.vertexCount * stride);
    std::vector<glm::vec2> uvs(place.vertexCount);
    for (std::size_t i = 0; i < uvs.size(); ++i) uvs[i] = all[i * stride + set - basicUvSets];
    return uvs;
}

void GpuMeshes::describe(const gl::VertexArray& vertexArray, const gl::Buffer& draws,
                         const DefaultDetail& defaultDetail) const {
    describe(vertexArray, surface_, 0, draws, defaultDetail);
}

void GpuMeshes::describeDeformed(const gl::VertexArray& vertexArray, std::uint32_t mesh,
                                 const DeformedStreams& deformed, const gl::Buffer& draws,
                                 const DefaultDetail& defaultDetail) const {
    describe(vertexArray, deformed.surface, static_cast<std::size_t>(places_[mesh].baseVertex), draws,
             defaultDetail);
    const auto first = static_cast<std::size_t>(places_[mesh].baseVertex);
    if (first < furtherVertices_) describeFurtherUvs(vertexArray, first);
    if (deformed.tangents == nullptr) return;
    glVertexArrayVertexBuffer(vertexArray.name(), 3, deformed.tangents->name(), 0, sizeof(glm::vec4));
    feedFloats(vertexArray, layout::TANGENT_ATTRIBUTE, 4, 3, 0);
}

void GpuMeshes::describeFurtherUvs(const gl::VertexArray& vertexArray) const {
    describeFurtherUvs(vertexArray, 0);
}

void GpuMeshes::describeFurtherUvs(const gl::VertexArray& vertexArray, std::size_t firstVertex) const {
    constexpr GLuint binding = 4;
    const std::size_t stride = furtherPairs_ * sizeof(glm::vec4);
    glVertexArrayVertexBuffer(vertexArray.name(), binding, furtherUvs_.name(),
                              static_cast<GLintptr>(firstVertex * stride), static_cast<GLsizei>(stride));
    for (std::size_t pair = 0; pair < furtherPairs_; ++pair)
        feedFloats(vertexArray, layout::FURTHER_UVS_ATTRIBUTE + static_cast<int>(pair), 4, binding,
                   pair * sizeof(glm::vec4));
}

void GpuMeshes::describe(const gl::VertexArray& vertexArray, const gl::Buffer& surface,
                         std::size_t firstDetail, const gl::Buffer& draws,
                         const DefaultDetail& defaultDetail) const {
    const GLuint name = vertexArray.name();
    glVertexArrayElementBuffer(name, indices_.name());
    glVertexArrayVertexBuffer(name, 0, surface.name(), 0, sizeof(SurfaceVertex));
    feedFloats(vertexArray, layout::POSITION_ATTRIBUTE, 3, 0, offsetof(SurfaceVertex, position));
    feedFloats(vertexArray, layout::NORMAL_ATTRIBUTE, 3, 0, offsetof(SurfaceVertex, normal));
    feedDraws(vertexArray, 1, draws);
    if (detail_ != Detail::everything) {
        defaultDetail.describe(vertexArray, 2);
        return;
    }
    glVertexArrayVertexBuffer(name, 2, details_.name(),
                              static_cast<GLintptr>(firstDetail * sizeof(DetailVertex)),
                              sizeof(DetailVertex));
    feedFloats(vertexArray, layout::TANGENT_ATTRIBUTE, 4, 2, offsetof(DetailVertex, tangent));
    feedFloats(vertexArray, layout::UV0_ATTRIBUTE, 2, 2, offsetof(DetailVertex, uv0));
    feedFloats(vertexArray, layout::UV1_ATTRIBUTE, 2, 2, offsetof(DetailVertex, uv1));
    feedFloats(vertexArray, layout::COLOR_ATTRIBUTE, 4, 2, offsetof(DetailVertex, color));
}

}  // namespace candela
