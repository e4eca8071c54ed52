#pragma once

#include <candela/camera.h>
#include <candela/frame_settings.h>

#include <string>

namespace candela {

// What a host hands to `Renderer::render`. All throw `Error` (badInput).

[[noreturn]] void refuse(const std::string& text);

/// Throws unless each setting is in the range that `FrameSettings` states.
void checkSettings(const FrameSettings& settings);

/// Throws unless each member of the view is in the range that `CameraView` states.
void checkView(const CameraView& view);

}  // namespace candela
