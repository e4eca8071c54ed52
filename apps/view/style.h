#pragma once

/// The sizes, colours and font of the panels, into the current ImGui context. `scale` is that of the desktop
/// times that of the user, 1 for a screen of about 96 pixels an inch; `pixelRatio` the pixels of the
/// framebuffer for a unit of ImGui. Letters are drawn for these pixels, none is stretched. Without a TrueType
/// font on the machine, the font of ImGui is used.
void chooseStyle(float scale, float pixelRatio);
