#pragma once

#include "import/file_access.h"
#include "import/moved_vertices.h"
#include "scene/model/frame_callback.h"

#include <candela/plugin.h>
#include <candela/plugin_registry.h>
#include <candela/scene.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace candela {

/// The functions of a plugin that it has given `set_frame_callback`, and its own pointer, which is destroyed
/// with the object.
class OwnedFrameCallback {
  public:
    explicit OwnedFrameCallback(const candela_frame_callback& callback) : callback_(callback) {}
    OwnedFrameCallback(const OwnedFrameCallback&) = delete;
    OwnedFrameCallback& operator=(const OwnedFrameCallback&) = delete;
    ~OwnedFrameCallback();

    const candela_frame_callback& get() const { return callback_; }

  private:
    candela_frame_callback callback_;
};

/// What a plugin said of its frame callback, checked. Throws `Error` (badInput).
candela_frame_callback frameCallbackFrom(const candela_frame_callback* source);

/// The frame callback of a scene that a plugin has read.
class PluginFrameCallback final : public FrameCallback {
  public:
    /// Where the callback comes from, for errors and for as long as it lives.
    struct Source {
        PluginRegistry plugins;  ///< Keeps the library loaded.
        std::string plugin, uri;
        std::unique_ptr<FileAccess> files;  ///< Null for a procedural scene.
    };
    /// What it may change.
    struct Elements {
        std::vector<MovedMesh> meshes;  ///< In ascending order.
        std::vector<MovedCage> cages;   ///< Likewise.
        std::uint32_t firstNode = 0;    ///< The index that node 0 of the plugin has in the scene.
    };
    /// `scene` is complete. Of it nodes, materials, lights, cameras and names are copied.
    PluginFrameCallback(Source source, std::unique_ptr<OwnedFrameCallback> callback, Elements elements,
                        const Scene& scene);
    ~PluginFrameCallback() override;

    bool movesMesh(std::uint32_t mesh) const override;
    bool movesCage(std::uint32_t cage) const override;

  private:
    class Call;

    SceneUpdate evaluate(double seconds) const override;

    // The library is unloaded last.
    Source source_;
    Elements elements_;
    Scene scene_;  ///< Without vertices, pixels and animations.
    std::unique_ptr<OwnedFrameCallback> callback_;
};

}  // namespace candela
