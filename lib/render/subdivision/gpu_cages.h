#pragma once

#include "render/subdivision/cage_levels.h"
#include "render/subdivision/cage_shape.h"
#include "render/subdivision/edge_length.h"
#include "render/subdivision/evaluator_backend.h"

#include <candela/context.h>
#include <candela/gpu_scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// All cages of a scene: their tables, their limit surfaces, and the levels of these. A surface that is out
/// of view keeps its level and its vertices until it comes into view.
class GpuCages {
  public:
    /// Makes the first table of each cage. Of `scene` cages and nodes are read; it and `options` have to
    /// outlive the object.
    GpuCages(const Context& context, const Scene& scene, const GpuSceneOptions& options);

    bool empty() const { return shown_.empty(); }

    /// A node that shows a cage.
    struct Shown {
        std::uint32_t node = 0, cage = 0;
        std::uint32_t shape = 0;          ///< Index for `shape`.
        glm::mat4 worldFromPoints{1.0f};  ///< As of the last `pose`.
        bool placed = false;              ///< By `setPoints`: morph targets and skin move it no longer.
        bool hidden = false;
    };
    std::span<const Shown> shown() const { return shown_; }
    const CageShape& shape(std::uint32_t index) const { return *shapes_[index]; }

    /// Poses the points of all cages that morph targets and skins move. `scene` is that of the constructor.
    void pose(const Scene& scene, const std::vector<glm::mat4>& world, double time);
    /// Moves the points of `shown()[index]`, which gets a shape of its own. To be followed by `pose`.
    void setPoints(std::uint32_t index, std::span<const glm::vec3> points);
    void setVisibility(std::uint32_t index, GpuScene::Visibility visibility);
    void setSettings(const SubdivisionSettings& settings);
    /// Makes tangents for those cages of which any material has a normal texture.
    void setMaterials(std::span<const Material> materials);

    /// Chooses the levels for a picture of `width` × `height` pixels and evaluates the surfaces in view that
    /// are not up to date. Returns the shapes whose levels have changed. `drawRecords` are those of the draw
    /// list.
    std::span<const std::uint32_t> update(const CameraView& view, int width, int height,
                                          const gl::Buffer& drawRecords);

    /// Lines of the cage that `shown()[index]` shows, for the instance `instance`.
    CageLines lines(CageLineKind kind, std::uint32_t index, std::uint32_t instance);
    CageReport report() const;
    EvaluatorBackend& evaluator() { return evaluator_; }

  private:
    /// What the level of a shape follows.
    struct LodRequest {
        bool inView = false;
        std::optional<float> longestEdge;  ///< Pixels.
    };
    struct Picture {
        CameraView view;
        int width = 0, height = 0;
    };

    std::uint32_t firstLevel(const CageLevels& levels) const;
    std::uint32_t addShape(std::uint32_t cage);
    void setTangents(CageShape& shape) const;
    void look(const Picture& picture);
    void lookAtShown(const Sight& sight, const Shown& shown);
    std::uint32_t levelFor(std::uint32_t shape) const;
    bool isLodClamped(std::uint32_t shape) const;
    void evaluateStale();

    std::vector<CageLevels> levels_;
    std::vector<std::unique_ptr<CageShape>> shapes_;
    std::vector<LodRequest> requests_;  ///< One a shape.
    std::vector<Shown> shown_;
    std::vector<bool> hasNormalTexture_;  ///< One a material.
    SubdivisionSettings settings_;
    bool subdivided_;
    std::optional<Picture> picture_;  ///< For which `requests_` hold.
    std::vector<glm::vec3> worldPoints_;
    std::vector<std::uint32_t> relevelled_;
    DefaultDetail defaultDetail_;
    EvaluatorBackend evaluator_;
};

}  // namespace candela
