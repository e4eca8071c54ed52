#pragma once

#include "gl/buffer.h"
#include "render/gpu_scene/vertex_streams.h"
#include "render/subdivision/cage_levels.h"
#include "render/subdivision/cage_lines.h"
#include "render/subdivision/evaluator_backend.h"
#include "render/subdivision/limit_streams.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// A limit surface as it stands: that of a cage for all nodes that show it as it is, or that of a node which
/// moves its points.
class CageShape {
  public:
    /// The points are the cage's own. The table of `firstLevel` stands in until there is a level.
    CageShape(CageLevels& levels, std::uint32_t firstLevel);

    CageLevels& levels() const { return *levels_; }
    std::span<const glm::vec3> points() const { return points_; }
    /// The sphere around the points.
    const glm::vec3& center() const { return center_; }
    float radius() const { return radius_; }

    void move(std::span<const glm::vec3> points);
    /// Does any material of the cage want tangents?
    enum class Tangents { none, wanted };
    void setTangents(Tangents tangents);

    /// None before the first `setLevel`.
    std::optional<std::uint32_t> level() const { return level_; }
    /// Refines to `level`, from which on the vertex array reads the records of `draws`. Returns whether that
    /// changes anything.
    bool setLevel(std::uint32_t level, const gl::Buffer& draws, const DefaultDetail& defaultDetail);

    /// Are the vertices not yet where the points ask for them?
    bool isStale() const { return stale_; }
    std::uint64_t triangles() const { return table_->triangles(); }
    /// Of the indices, one a material of the cage.
    std::span<const IndexRange> ranges() const { return table_->ranges(); }
    std::size_t vertexCount() const { return table_->refined().vertexCount(); }
    /// Lets the evaluator decide on its form with this shape. The level has to be set.
    void chooseForm(EvaluatorBackend& evaluator);
    /// Brings the vertices to where the points ask for them.
    void evaluate(EvaluatorBackend& evaluator);

    /// As of the last `evaluate`.
    const LimitStreams& streams() const { return streams_; }
    GLuint vertexArray() const { return vertexArray_.name(); }
    /// Lines as of the last `evaluate`; `instance` is whose they are.
    CageLines lines(CageLineKind kind, std::uint32_t instance);

  private:
    void describe(const gl::Buffer& draws, const DefaultDetail& defaultDetail);
    LimitRequest request();

    CageLevels* levels_;
    std::vector<glm::vec3> points_;
    glm::vec3 center_{0.0f};
    float radius_ = 0.0f;
    std::optional<std::uint32_t> level_;
    GpuStencilTable* table_;
    bool described_ = false, stale_ = true;
    Tangents tangents_ = Tangents::none;
    gl::Buffer pointBuffer_{"cage points"};
    LimitStreams streams_;
    gl::VertexArray vertexArray_{"cage"};
    std::optional<gl::VertexArray> faceLines_, cageLines_;
};

}  // namespace candela
