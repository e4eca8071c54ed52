#pragma once

#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/scene.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace candela {

struct GpuSceneOptions {
    /// From linear Rec.709, in which scenes give colours, to the working space
    /// (`ColorConfig::workingFromRec709`).
    glm::dmat3 workingFromRec709{1.0};
    /// A light without a range gets the distance at which its irradiance falls to this, in lux. Over 0.
    float irradianceThreshold = 0.005f;
};

/// What the scene's lights amount to after upload.
struct LightReport {
    std::uint64_t lights = 0;
    std::uint64_t rangesAssigned = 0;  ///< Lights without a range of their own.
    /// The most irradiance, in lux, that assigned ranges can take from any one point: each such light loses
    /// at most its threshold.
    double irradianceCut = 0.0;
};

/// The uploaded twin of a `Scene`. The scene given to the constructor is not kept; what `setTime` and
/// `setTransform` need of it is copied.
class CANDELA_API GpuScene {
  public:
    /// Uploads. Throws `Error` (limit) that names what does not fit the device.
    GpuScene(const Context& context, const Scene& scene, const GpuSceneOptions& options = {});
    GpuScene(GpuScene&&) noexcept;
    GpuScene& operator=(GpuScene&&) noexcept;
    ~GpuScene();

    /// Replaces all lights, those of the scene included: one upload. Nodes and animations move lights no
    /// longer. Throws `Error`: badInput naming a light whose numbers break what `PlacedLight` states, limit
    /// when the device can not hold as many.
    void setLights(std::span<const PlacedLight> lights);
    /// Sets a node's local matrix, and moves what hangs on it.
    void setTransform(std::uint32_t node, const glm::mat4& local);
    /// Poses all animated nodes as at `seconds`, and moves what hangs on them.
    void setTime(double seconds);

    const LightReport& lightReport() const;
    std::uint64_t triangleCount() const;
    std::uint32_t materialCount() const;

    struct State;  ///< Private to the library.
    State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

}  // namespace candela
