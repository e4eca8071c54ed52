#pragma once

#include <candela/brdf.h>
#include <candela/context.h>
#include <candela/gpu_scene.h>
#include <candela/scene.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace candela::test {

/// The further lobes of the pixels of a view, as its G-buffer holds them. Without specular antialiasing.
class LobePixels {
  public:
    LobePixels(const Context& context, GpuScene& scene, const CameraView& view, int width, int height);

    /// None where the material is all metallic and roughness. y counts from the top; `normal` is that of the
    /// pixel's AOV.
    std::optional<ExtendedLobes<double>> at(int x, int y, const glm::vec3& normal) const;

    int count() const;  ///< Pixels that have some.

  private:
    int width_, height_;
    std::vector<std::uint32_t> words_, diffuseTransmission_;
};

}  // namespace candela::test
