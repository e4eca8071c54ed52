#pragma once

#include "gl/buffer.h"
#include "render/gpu_scene/gpu_instances.h"
#include "render/gpu_scene/gpu_meshes.h"
#include "render/subdivision/evaluator_backend.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// A limit surface at one level, with the vertices of its present pose. All nodes that show a cage in its own
/// pose share one; a node that moves the cage's points has its own.
class LimitSurface {
  public:
    /// The points are the cage's own. The table of `firstLevel` is used until the level is set.
    LimitSurface(CageTables& tables, std::uint32_t firstLevel);

    CageTables& tables() const { return *tables_; }
    std::span<const glm::vec3> points() const { return points_; }
    /// Of the points.
    const BoundingSphere& sphere() const { return sphere_; }

    void setPoints(std::span<const glm::vec3> points);
    /// Does any material of the cage need tangents?
    enum class Tangents { none, needed };
    void setTangents(Tangents tangents);

    /// None before the first `setLevel`.
    std::optional<std::uint32_t> level() const { return level_; }
    /// Refines to `level`. The vertex array feeds the draw attribute from `drawRecords`. Returns whether
    /// anything has changed.
    bool setLevel(std::uint32_t level, const gl::Buffer& drawRecords, const DefaultDetail& defaultDetail);

    /// Have the points or the level changed since the last evaluation?
    bool isStale() const { return stale_; }
    std::uint64_t triangles() const { return table_->triangles(); }
    /// Of the indices, one a material of the cage.
    std::span<const IndexRange> ranges() const { return table_->ranges(); }
    std::size_t vertexCount() const { return table_->refined().vertexCount(); }
    /// Computes the vertices from the points.
    void evaluate(EvaluatorBackend& evaluator);

    /// How often the vertices have been computed.
    std::uint64_t version() const { return version_; }

    /// The positions of the vertices where the points of the cage are these: computed and read back.
    std::vector<glm::vec3> positionsAt(std::span<const glm::vec3> points, EvaluatorBackend& evaluator) const;

    // Read back from the device, as of the last `evaluate`.

    std::vector<glm::vec3> readPositions() const;
    std::vector<std::uint32_t> readIndices(const IndexRange& range) const;
    /// One a vertex; empty where the cage has no texture coordinates.
    std::vector<glm::vec2> readUvs() const;

    /// As of the last `evaluate`.
    const LimitBuffers& buffers() const { return buffers_; }
    GLuint vertexArray() const { return vertexArray_.name(); }
    /// Lines as of the last `evaluate`, for the given instance.
    CageLines lines(CageLineKind kind, std::uint32_t instance);

  private:
    void describe(const gl::Buffer& drawRecords, const DefaultDetail& defaultDetail);

    CageTables* tables_;
    std::vector<glm::vec3> points_;
    BoundingSphere sphere_;
    std::optional<std::uint32_t> level_;
    GpuStencilTable* table_;
    bool described_ = false, stale_ = true;
    std::uint64_t version_ = 0;
    Tangents tangents_ = Tangents::none;
    gl::Buffer pointBuffer_{"cage points", gl::BufferUsage::dynamic};
    LimitBuffers buffers_;
    gl::VertexArray vertexArray_{"cage"};
    std::optional<gl::VertexArray> faceLines_, cageLines_;
};

}  // namespace candela
