#pragma once

#include "gl/texture.h"
#include "render/display/memory_display.h"
#include "render/host/pending.h"

#include <candela/color.h>

#include <chrono>
#include <future>
#include <memory>
#include <utility>

namespace candela {

/// A picture that another thread computes without OpenGL.
template <typename Picture, typename Compute>
Pending<Picture> computeLater(const std::shared_ptr<gl::ContextBinding>& binding, Compute compute) {
    // A function has to be copyable, which the future of a result that is moved is not.
    const auto computed =
        std::make_shared<std::future<Picture>>(std::async(std::launch::async, std::move(compute)));
    return makePending<Picture>(
        binding,
        [computed] { return computed->wait_for(std::chrono::seconds(0)) == std::future_status::ready; },
        [computed] { return computed->get(); });
}

/// A copy of radiance in memory, shown through a display transform by another thread.
PendingPicture showLater(const std::shared_ptr<gl::ContextBinding>& binding, const MemoryPicture& picture,
                         const DisplayTransform& transform);

/// What a display target shows, on its way from the device.
PendingPicture transferPicture(const std::shared_ptr<gl::ContextBinding>& binding,
                               const DisplayTarget& shown);

}  // namespace candela
