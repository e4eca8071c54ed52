#pragma once

#include "view_model.h"

/// What the hand does to the picture.
enum class Motion { rests, moves };

/// Reads the pointer and the keys of this ImGui frame, where no panel takes them, and moves the camera.
/// `pixelRatio` is the framebuffer's pixels for a unit of ImGui. To be called after the panels are drawn.
Motion interact(ViewModel& model, float pixelRatio);
