#pragma once

#include "render/subdivision/level_of_detail.h"
#include "render/subdivision/limit_surface.h"

#include <candela/context.h>
#include <candela/gpu_scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// All cages of a scene: their stencil tables, their limit surfaces, and the levels of these. A surface that
/// is out of view keeps its level and its vertices until it comes into view.
class GpuCages {
  public:
    /// Creates the first table of each cage. Of `scene` cages, skins, nodes and animations are read; it and
    /// `options` have to outlive the object.
    GpuCages(const Context& context, const Scene& scene, const GpuSceneOptions& options);

    bool empty() const { return instances_.empty(); }

    /// The tables of a cage that is to be added or replaced. Throws what the subdivider does.
    std::unique_ptr<CageTables> makeTables(const Cage& cage) const;
    /// Sets the tables of cage `cage`, which may be the next one and which no node shows; null: it has been
    /// removed.
    void setTables(std::uint32_t cage, std::unique_ptr<CageTables> tables);
    /// Adds the cage of a node of the scene, which nothing deforms, and returns its instance.
    std::uint32_t addInstance(std::uint32_t node);
    void removeInstance(std::uint32_t instance);
    const CageTables& tables(std::uint32_t cage) const { return *tables_[cage]; }

    /// The cage of a node.
    struct Instance {
        std::uint32_t node = 0, cage = 0;
        std::uint32_t surface = 0;        ///< Index for `surface`.
        glm::mat4 worldFromPoints{1.0f};  ///< As of the last `pose`.
        bool isDeformed = false;          ///< By morph targets or a skin.
        bool hidden = false;
        bool isMarked = false;                   ///< To be posed.
        bool isRemoved = false;                  ///< The place is free.
        std::vector<glm::vec3> keptPoints = {};  ///< Empty: those of the cage at rest.
    };
    std::span<const Instance> instances() const { return instances_; }
    const LimitSurface& surface(std::uint32_t index) const { return *surfaces_[index]; }
    /// The instances that show a surface.
    std::span<const std::uint32_t> instancesOf(std::uint32_t surface) const { return users_[surface]; }

    /// Marks the instances that a node moves: its own, and those for whose skin it is a joint.
    void markNode(std::uint32_t node);
    /// Marks the instances whose morph weights are animated.
    void markAnimated();
    /// Poses the marked instances and returns them. `world` are the matrices of the nodes at `time`.
    std::span<const std::uint32_t> pose(const std::vector<glm::mat4>& world, double time);

    /// Replaces the points of an instance, which gets a surface of its own: morph targets and skin do not
    /// move it any more.
    void setPoints(std::uint32_t instance, std::span<const glm::vec3> points);
    void setVisibility(std::uint32_t instance, GpuScene::Visibility visibility);
    void setSettings(const SubdivisionSettings& settings);
    /// Surfaces have tangents where any material of the cage has a normal texture.
    void setMaterial(std::uint32_t index, const Material& material);

    /// Chooses the levels for a view and evaluates the surfaces of the scope that are not up to date. Returns
    /// the surfaces whose levels have changed. `drawRecords` are those of the draw list.
    struct View {
        CameraView camera;
        int width = 0, height = 0;  ///< Pixels.
    };
    std::span<const std::uint32_t> update(const View& view, VertexScope scope, const gl::Buffer& drawRecords);

    /// Remembers the points of all instances.
    void keep();
    /// The positions of an instance's refined cage, at its present level, for the points of the last `keep`;
    /// empty where the points are the same.
    std::vector<glm::vec3> keptPositions(std::uint32_t instance);

    /// Lines of the cage `instances()[cageInstance]`, for the instance `instance` of the scene.
    CageLines lines(CageLineKind kind, std::uint32_t cageInstance, std::uint32_t instance);
    CageReport report() const;

  private:
    /// What the level of a surface follows.
    struct LodRequest {
        bool inView = false;
        std::optional<float> longestEdge;  ///< Pixels.
    };
    void addInstances();
    void listJoints();
    void listAnimated();
    void mark(std::uint32_t instance);
    std::uint32_t firstLevel(const CageTables& tables) const;
    std::uint32_t addSurface(std::uint32_t cage);
    void leaveSurface(std::uint32_t instance);
    bool isNeeded(std::uint32_t surface, VertexScope scope) const;
    void setTangents(LimitSurface& surface) const;
    void requestLevels(const View& view);
    void requestLevel(const LodView& view, const Instance& instance);
    std::uint32_t levelFor(std::uint32_t surface) const;
    bool isLodClamped(std::uint32_t surface) const;
    void evaluateStale(VertexScope scope);

    const Scene& scene_;
    const std::optional<Subdivider>& subdivider_;
    std::uint32_t noMaterial_;
    SubdivisionSettings settings_;
    bool subdivided_;
    std::vector<std::unique_ptr<CageTables>> tables_;  ///< One a cage; null where it has been removed.
    /// The surface of each cage that instances in its own shape share.
    std::vector<std::optional<std::uint32_t>> sharedSurfaces_;
    std::vector<std::unique_ptr<LimitSurface>> surfaces_;  ///< Null where no instance is left.
    std::vector<std::vector<std::uint32_t>> users_;        ///< Instances, one list a surface.
    std::vector<LodRequest> requests_;                     ///< One a surface.
    std::vector<Instance> instances_;
    std::vector<std::vector<std::uint32_t>> instancesOfNode_;  ///< That a node moves; empty without cages.
    std::vector<std::uint32_t> animated_;  ///< Instances whose morph weights are animated.
    std::vector<std::uint32_t> marked_, posed_, freeInstances_;
    std::vector<bool> hasNormalTexture_;  ///< One a material.
    std::optional<View> view_;            ///< For which `requests_` hold.
    std::vector<glm::vec3> worldPoints_;
    std::vector<std::uint32_t> releveled_;
    DefaultDetail defaultDetail_;
    EvaluatorBackend evaluator_;
};

}  // namespace candela
