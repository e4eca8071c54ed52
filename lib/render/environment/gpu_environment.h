#pragma once

#include "gl/texture.h"
#include "render/environment/environment_map.h"
#include "render/environment/environment_view.h"
#include "render/layout.h"

#include <candela/environment.h>

#include <optional>

namespace candela {

/// The environment of a `GpuScene`. Rotation and intensity apply when it is read: changing them costs
/// nothing.
class GpuEnvironment {
  public:
    /// Filters the picture and uploads it. `environment` has passed `validate`. Throws `Error` (limit) when
    /// the device can not hold it.
    GpuEnvironment(const Environment& environment, const glm::dmat3& workingFromRec709);

    const EnvironmentSettings& settings() const { return settings_; }
    void set(const EnvironmentSettings& settings);

    /// The largest colour channel of the picture.
    float largestRadiance() const { return largestRadiance_; }

    /// Whether it lights surfaces, and whether it is seen behind them.
    bool lights() const { return settings_.intensity > 0.0f; }
    bool isBackground() const { return settings_.isBackground; }

    const EnvironmentMap& map() const { return map_; }
    const EnvironmentView& view() const { return view_; }
    /// The picture as it is given: RGBA32F, linear Rec.709.
    const gl::Texture& picture() const { return picture_; }
    /// Writes what shaders read of it into the uniform block.
    void describe(layout::FrameUniforms& uniforms) const;
    /// Binds the maps for shaders, which the first call uploads.
    void bindMaps() const;

  private:
    EnvironmentSettings settings_;
    float largestRadiance_;
    EnvironmentMap map_;
    EnvironmentView view_{};
    gl::Texture picture_;
    mutable std::optional<gl::BufferTexture> texels_;
};

}  // namespace candela
