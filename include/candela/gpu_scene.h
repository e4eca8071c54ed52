#pragma once

#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/scene.h>
#include <candela/subdivider.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace candela {

/// How far cages are refined.
struct SubdivisionSettings {
    /// All cages to this level, 1 to `maxSubdivisionLevel`. None: a cage that states a level has that
    /// one, every other follows its size on the screen.
    std::optional<std::uint32_t> level;
    float edgePixels = 8.0f;     ///< By size: the length that edges on the screen should have, over 0.
    std::uint32_t maxLevel = 5;  ///< By size: the greatest level, 1 to `maxSubdivisionLevel`.
    /// By size: the most vertices that a cage may be refined to; its level stays as low as that needs, but is
    /// at least 1.
    std::uint64_t maxVertices = 2'000'000;
};

struct GpuSceneOptions {
    /// From linear Rec.709, in which scenes give colours, to the working space
    /// (`ColorConfig::workingFromRec709`).
    glm::dmat3 workingFromRec709{1.0};
    /// A light without a range gets the distance at which its irradiance falls to this, in lux. Over 0.
    float irradianceThreshold = 0.005f;
    /// Refines the cages (`PluginRegistry::subdivider`); none: their polygons are drawn.
    std::optional<Subdivider> subdivider;
    SubdivisionSettings subdivision;
};

/// What the scene's lights amount to after upload.
struct LightReport {
    std::uint64_t lights = 0;
    std::uint64_t rangesAssigned = 0;  ///< Lights without a range of their own.
    /// The most irradiance, in lux, that assigned ranges can take from any one point: each such light loses
    /// at most its threshold.
    double irradianceCut = 0.0;
};

/// What the scene's cages amount to as of the last frame (or the upload).
struct CageReport {
    std::uint64_t cages = 0;       ///< Nodes that show a cage.
    bool subdivided = false;       ///< False where no subdivider is at hand: polygons are drawn.
    std::uint64_t triangles = 0;   ///< Drawn for cages, those of a cage times the nodes that show it.
    std::uint64_t tableBytes = 0;  ///< Memory of all stencil tables made so far.
    std::uint32_t minLevel = 0, maxLevel = 0;  ///< 0 without a subdivider or a frame.
    std::uint64_t lodClamped = 0;  ///< Cages whose level `maxLevel` or `maxVertices` keeps below what
                                   ///< `edgePixels` asks for.
    std::string evaluator;         ///< What moves the points: "compute" or "threads"; empty before a frame.
};

/// A `Scene` on the device. The scene given to the constructor is not kept; what `setTime` and
/// `setTransform` need of it is copied.
class CANDELA_API GpuScene {
  public:
    /// Uploads. Throws `Error`: limit that names what does not fit the device, badInput when the subdivider
    /// rejects a cage.
    GpuScene(const Context& context, const Scene& scene, const GpuSceneOptions& options = {});
    GpuScene(GpuScene&&) noexcept;
    GpuScene& operator=(GpuScene&&) noexcept;
    ~GpuScene();

    /// Replaces all lights, those of the scene included: one upload. Nodes and animations move lights no
    /// longer. Throws `Error`: badInput naming a light whose numbers break what `WorldLight` states, limit
    /// when the device can not hold as many.
    void setLights(std::span<const WorldLight> lights);
    /// Sets a node's local matrix, and moves what hangs on it.
    void setTransform(std::uint32_t node, const glm::mat4& local);
    /// Poses all animated nodes as at `seconds`, and moves what hangs on them.
    void setTime(double seconds);
    /// Moves the points of the cage that `node` shows to `points` (one a vertex of the cage, in the node's
    /// frame); morph targets and skin move it no longer. Throws `Error` (badInput) when the node shows no
    /// cage, the number of points differs or one of them is not finite.
    void setCagePoints(std::uint32_t node, std::span<const glm::vec3> points);
    /// Takes effect with the next frame. Throws `Error` (badInput) when a setting is out of its range.
    void setSubdivision(const SubdivisionSettings& settings);
    /// Replaces the numbers of a material; its textures and what decides the way it is drawn (textures, alpha
    /// mode, sides, unlit) are replaced too. Throws `Error` (badInput) when it breaks what `Material` states.
    void setMaterial(std::uint32_t index, const Material& material);
    enum class Visibility { shown, hidden };
    /// Shows or hides what the node itself shows; its children are not touched.
    void setVisibility(std::uint32_t node, Visibility visibility);

    const LightReport& lightReport() const;
    CageReport cageReport() const;
    std::uint64_t triangleCount() const;
    std::uint32_t materialCount() const;

    struct State;  ///< Private to the library.
    State& state() { return *state_; }
    const State& state() const { return *state_; }

  private:
    friend class Renderer;
    std::shared_ptr<State> state_;
};

}  // namespace candela
