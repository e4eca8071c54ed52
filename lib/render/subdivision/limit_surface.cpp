#include "render/subdivision/limit_surface.h"

#include "render/layout.h"

#include <algorithm>

namespace candela {

namespace {

// Vertex buffer bindings.
constexpr GLuint positions = 0, draws = 1, defaults = 2, normals = 3, uvs = 4, tangents = 5;

void feedPositions(const gl::VertexArray& vertexArray, const gl::Buffer& buffer) {
    glVertexArrayVertexBuffer(vertexArray.name(), positions, buffer.name(), 0, sizeof(glm::vec3));
    feedFloats(vertexArray, layout::POSITION_ATTRIBUTE, 3, positions, 0);
}

}  // namespace

LimitSurface::LimitSurface(CageTables& tables, std::uint32_t firstLevel)
    : tables_(&tables), table_(&tables.table(firstLevel)) {
    setPoints(tables.cage().positions);
}

void LimitSurface::setPoints(std::span<const glm::vec3> points) {
    if (std::ranges::equal(points_, points)) return;
    points_.assign(points.begin(), points.end());
    sphere_ = boundingSphere(points_);
    stale_ = true;
}

void LimitSurface::setTangents(Tangents tangents) {
    if (tangents == tangents_) return;
    tangents_ = tangents;
    described_ = false;
}

bool LimitSurface::setLevel(std::uint32_t level, const gl::Buffer& drawRecords,
                            const DefaultDetail& defaultDetail) {
    if (level_ == level && described_) return false;
    table_ = &tables_->table(level);
    level_ = level;
    stale_ = true;
    buffers_.surface.reserve(LimitBuffers::surfaceBytes(vertexCount()));
    if (tangents_ == Tangents::needed && table_->uvs() != nullptr)
        buffers_.tangents.reserve(vertexCount() * sizeof(glm::vec4));
    describe(drawRecords, defaultDetail);
    described_ = true;
    return true;
}

void LimitSurface::describe(const gl::Buffer& drawRecords, const DefaultDetail& defaultDetail) {
    const GLuint name = vertexArray_.name();
    glVertexArrayElementBuffer(name, table_->indices().name());
    feedPositions(vertexArray_, buffers_.surface);
    glVertexArrayVertexBuffer(name, normals, buffers_.surface.name(),
                              static_cast<GLintptr>(vertexCount() * sizeof(glm::vec3)), sizeof(glm::vec3));
    feedFloats(vertexArray_, layout::NORMAL_ATTRIBUTE, 3, normals, 0);
    feedDraws(vertexArray_, draws, drawRecords);
    defaultDetail.describe(vertexArray_, defaults);
    if (table_->uvs() == nullptr) return;
    glVertexArrayVertexBuffer(name, uvs, table_->uvs()->name(), 0, sizeof(glm::vec2));
    feedFloats(vertexArray_, layout::UV0_ATTRIBUTE, 2, uvs, 0);
    if (tangents_ == Tangents::none) return;
    glVertexArrayVertexBuffer(name, tangents, buffers_.tangents.name(), 0, sizeof(glm::vec4));
    feedFloats(vertexArray_, layout::TANGENT_ATTRIBUTE, 4, tangents, 0);
}

void LimitSurface::evaluate(EvaluatorBackend& evaluator) {
    pointBuffer_.upload(std::span<const glm::vec3>(points_));
    EvaluationRequest request{*table_, points_, pointBuffer_, {}, buffers_};
    if (tangents_ == Tangents::needed) request.uvDerivatives = table_->uvDerivatives(tables_->cage());
    evaluator.evaluate(request);
    stale_ = false;
    ++version_;
}

std::vector<glm::vec3> LimitSurface::positionsAt(std::span<const glm::vec3> points,
                                                 EvaluatorBackend& evaluator) const {
    gl::Buffer pointBuffer("previous cage points", gl::BufferUsage::dynamic);
    pointBuffer.upload(points);
    LimitBuffers buffers;
    buffers.surface.reserve(LimitBuffers::surfaceBytes(vertexCount()));
    evaluator.evaluate({*table_, points, pointBuffer, {}, buffers});
    return buffers.surface.read<glm::vec3>(0, vertexCount());
}

std::vector<glm::vec3> LimitSurface::readPositions() const {
    return buffers_.surface.read<glm::vec3>(0, vertexCount());
}

std::vector<std::uint32_t> LimitSurface::readIndices(const IndexRange& range) const {
    return table_->indices().read<std::uint32_t>(range.first, range.count);
}

std::vector<glm::vec2> LimitSurface::readUvs() const {
    return table_->uvs() == nullptr ? std::vector<glm::vec2>{}
                                    : table_->uvs()->read<glm::vec2>(0, vertexCount());
}

CageLines LimitSurface::lines(CageLineKind kind, std::uint32_t instance) {
    const bool ofFaces = kind == CageLineKind::faceEdges;
    const EdgeIndices& indices = ofFaces ? table_->faceEdges() : tables_->cageEdges();
    std::optional<gl::VertexArray>& vertexArray = ofFaces ? faceLines_ : cageLines_;
    if (!vertexArray) {
        vertexArray.emplace("cage lines");
        feedPositions(*vertexArray, ofFaces ? buffers_.surface : pointBuffer_);
    }
    glVertexArrayElementBuffer(vertexArray->name(), indices.buffer.name());
    return {vertexArray->name(), indices.count, instance};
}

}  // namespace candela
