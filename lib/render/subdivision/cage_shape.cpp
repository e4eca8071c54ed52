#include "render/subdivision/cage_shape.h"

#include "render/layout.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace candela {

namespace {

// Vertex buffer bindings.
constexpr GLuint positions = 0, draws = 1, defaults = 2, normals = 3, uvs = 4, tangents = 5;

void feedPositions(const gl::VertexArray& vertexArray, const gl::Buffer& buffer) {
    glVertexArrayVertexBuffer(vertexArray.name(), positions, buffer.name(), 0, sizeof(glm::vec3));
    feedFloats(vertexArray, layout::POSITION_ATTRIBUTE, 3, positions, 0);
}

}  // namespace

CageShape::CageShape(CageLevels& levels, std::uint32_t firstLevel)
    : levels_(&levels), table_(&levels.table(firstLevel)) {
    move(levels.cage().positions);
}

void CageShape::move(std::span<const glm::vec3> points) {
    if (std::ranges::equal(points_, points)) return;
    points_.assign(points.begin(), points.end());
    stale_ = true;
    glm::vec3 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
    for (const glm::vec3& point : points_) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    center_ = 0.5f * low + 0.5f * high;
    radius_ = 0.0f;
    for (const glm::vec3& point : points_) radius_ = std::max(radius_, glm::distance(point, center_));
}

void CageShape::setTangents(Tangents wanted) {
    if (wanted == tangents_) return;
    tangents_ = wanted;
    described_ = false;
}

bool CageShape::setLevel(std::uint32_t level, const gl::Buffer& drawRecords,
                         const DefaultDetail& defaultDetail) {
    if (level_ == level && described_) return false;
    table_ = &levels_->table(level);
    level_ = level;
    stale_ = true;
    streams_.surface.reserve(LimitStreams::surfaceBytes(vertexCount()));
    if (tangents_ == Tangents::wanted && table_->uvs() != nullptr)
        streams_.tangents.reserve(vertexCount() * sizeof(glm::vec4));
    describe(drawRecords, defaultDetail);
    described_ = true;
    return true;
}

void CageShape::describe(const gl::Buffer& drawRecords, const DefaultDetail& defaultDetail) {
    const GLuint name = vertexArray_.name();
    glVertexArrayElementBuffer(name, table_->indices().name());
    feedPositions(vertexArray_, streams_.surface);
    glVertexArrayVertexBuffer(name, normals, streams_.surface.name(),
                              static_cast<GLintptr>(vertexCount() * sizeof(glm::vec3)), sizeof(glm::vec3));
    feedFloats(vertexArray_, layout::NORMAL_ATTRIBUTE, 3, normals, 0);
    feedDraws(vertexArray_, draws, drawRecords);
    defaultDetail.describe(vertexArray_, defaults);
    if (table_->uvs() == nullptr) return;
    glVertexArrayVertexBuffer(name, uvs, table_->uvs()->name(), 0, sizeof(glm::vec2));
    feedFloats(vertexArray_, layout::UV0_ATTRIBUTE, 2, uvs, 0);
    if (tangents_ == Tangents::none) return;
    glVertexArrayVertexBuffer(name, tangents, streams_.tangents.name(), 0, sizeof(glm::vec4));
    feedFloats(vertexArray_, layout::TANGENT_ATTRIBUTE, 4, tangents, 0);
}

LimitRequest CageShape::request() {
    LimitRequest request{*table_, points_, pointBuffer_, {}, streams_};
    if (tangents_ == Tangents::wanted) request.uvDerivatives = table_->uvDerivatives(levels_->cage());
    return request;
}

void CageShape::chooseForm(EvaluatorBackend& evaluator) {
    pointBuffer_.upload(std::span<const glm::vec3>(points_));
    evaluator.choose(request());
}

void CageShape::evaluate(EvaluatorBackend& evaluator) {
    pointBuffer_.upload(std::span<const glm::vec3>(points_));
    evaluator.evaluate(request());
    stale_ = false;
}

CageLines CageShape::lines(CageLineKind kind, std::uint32_t instance) {
    const bool ofFaces = kind == CageLineKind::faceEdges;
    const LineIndices& indices = ofFaces ? table_->faceLines() : levels_->edgeLines();
    std::optional<gl::VertexArray>& vertexArray = ofFaces ? faceLines_ : cageLines_;
    if (!vertexArray) {
        vertexArray.emplace("cage lines");
        feedPositions(*vertexArray, ofFaces ? streams_.surface : pointBuffer_);
    }
    glVertexArrayElementBuffer(vertexArray->name(), indices.buffer.name());
    return {vertexArray->name(), indices.count, instance};
}

}  // namespace candela
