#include "render/host/pending_pictures.h"

#include "render/display/display_target.h"
#include "render/host/pixel_transfer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

PendingPicture showLater(const std::shared_ptr<gl::ContextBinding>& binding, const MemoryPicture& picture,
                         const DisplayTransform& transform) {
    std::vector<float> radiance(picture.radiance.begin(), picture.radiance.end());
    return computeLater<std::vector<std::uint8_t>>(
        binding, [radiance = std::move(radiance), picture, transform] {
            return MemoryDisplay().codes({radiance, picture.width, picture.height, picture.place}, transform);
        });
}

PendingPicture transferPicture(const std::shared_ptr<gl::ContextBinding>& binding,
                               const DisplayTarget& shown) {
    const auto transfer = std::make_shared<PixelTransfer>();
    const int width = shown.width, height = shown.height;
    transfer->start(
        std::array{PixelTransfer::Source{shown.texture, GL_RGBA, GL_UNSIGNED_BYTE, width, height, 4}});
    return makePending<std::vector<std::uint8_t>>(
        binding, [transfer] { return transfer->isReady(); },
        [transfer, width, height] {
            auto pixels = elementsOf<std::uint8_t>(transfer->read(0));
            flipRows(pixels, width, height);
            return pixels;
        });
}

}  // namespace candela
