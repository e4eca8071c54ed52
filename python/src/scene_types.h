#pragma once

#include "scene_data.h"

#include <candela/camera.h>
#include <candela/environment.h>
#include <candela/light.h>
#include <candela/plugin_registry.h>

#include <optional>
#include <string>
#include <vector>

namespace candela::python {

template <>
struct Convert<Environment> : ConvertClass<Environment> {};
template <>
struct Convert<CameraView> : ConvertClass<CameraView> {};
template <>
struct Convert<ImportNote> : ConvertClass<ImportNote> {};

/// `Scene` in Python.
struct SceneHandle {
    ScenePtr data = std::make_shared<SceneData>();
};

/// Index of the material that an argument is: a Material, which is appended unless it is the scene's, or a
/// number; none for None.
std::optional<std::uint32_t> materialIndex(SceneHandle& scene, nb::handle material);

/// Binds the looks of a scene.
void bindVariants(nb::class_<SceneHandle>& cls);

/// Many lights from arrays: what belongs to all is a number, what belongs to each an array.
class LightArrays {
  public:
    /// `positions` (N, 3), or None where `options` has directions (N, 3) of directional lights.
    LightArrays(nb::handle positions, const nb::kwargs& options);

    std::size_t size() const { return size_; }
    Light light(std::size_t index) const;
    WorldLight worldLight(std::size_t index) const;

    /// The keywords for signatures in the stubs.
    static const char* keywords();

  private:
    void read(const std::string& name, nb::handle value);

    std::size_t size_ = 0;
    Light common_;
    std::vector<glm::vec3> positions_, directions_, colors_;
    std::vector<float> intensities_, ranges_, radii_;
};

/// The plugins that the process uses where none are given. Searched when they are needed first.
const PluginRegistry& defaultPlugins();

/// The camera that an argument names: an index or a name, or None for the first one; none where the scene has
/// no camera. Throws `Error` (badInput) that lists the cameras.
std::optional<std::uint32_t> cameraFrom(const Scene& scene, nb::handle camera);

/// The view of a camera of the scene; without one, of all of it. `framed` is asked for the box then.
CameraView viewOf(const Scene& scene, std::optional<std::uint32_t> camera, double time, float aspect,
                  const std::function<Bounds()>& framed);

/// The box that the automatic view frames.
Bounds framedBox(const Scene& scene);

}  // namespace candela::python
