#pragma once

#include "view_model.h"
#include "viewport.h"

#include <candela/gpu_scene.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Draws `ViewModel::thumbnails`, one after another.
class ThumbnailPictures {
  public:
    ThumbnailPictures() = default;
    ThumbnailPictures(const ThumbnailPictures&) = delete;
    ThumbnailPictures& operator=(const ThumbnailPictures&) = delete;
    /// The context has to be current.
    ~ThumbnailPictures();

    /// Whether a list shows one that is not drawn, or not as the scene is lit and posed now.
    bool isDue(const ViewModel& model) const { return model.document && next(model).has_value(); }

    struct Inputs {
        Viewport& viewport;  ///< Its picture is replaced.
        const candela::DisplayTransform& display;
        const candela::GpuSceneOptions& upload;
    };
    /// Draws the next one that is due. Throws `candela::Error`; it then stays without a picture.
    void drawNext(ViewModel& model, const Inputs& inputs);
    /// Of another scene from now on.
    void forget(ViewModel& model);

  private:
    struct Due {
        bool isVariant = false;
        std::uint32_t index = 0;
    };
    std::optional<Due> next(const ViewModel& model) const;
    std::vector<std::uint8_t> drawCamera(ViewModel& model, std::uint32_t camera, const Inputs& inputs) const;
    std::vector<std::uint8_t> drawVariant(ViewModel& model, std::uint32_t row, const Inputs& inputs) const;

    std::vector<unsigned> textures_;
    std::vector<std::string> cameraKeys_, variantKeys_;  ///< What each was drawn of.
};
