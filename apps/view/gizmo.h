#pragma once

#include "view_model.h"

/// Draws the gizmo of what is picked over the picture, and lets the pointer drag it. Returns whether the left
/// button belongs to it. To be called in an ImGui frame, after the panels are drawn.
bool driveGizmo(ViewModel& model);

/// Draws what lies in the scene and is no part of its picture: lights as icons, the grid and the axes, as far
/// as they are asked for.
void drawGuides(const ViewModel& model);

/// The light whose icon is shown nearest to the pointer, near enough for a click.
std::optional<std::uint32_t> lightUnderPointer(const ViewModel& model);
