#pragma once

#include "view_model.h"

#include <string>
#include <vector>

// The comparison of two settings by a line over the picture: `Comparison` in view_model.h.

/// Gives `to` the settings of `from` that a comparison is about: light, reflection, technique, samples, depth
/// of field, what is shown, and colour. Scene, camera, time, size and subdivision stay.
void takeComparedOptions(const SceneOptions& from, SceneOptions& to);

/// A line for each setting that differs, for both sides.
struct ComparedTexts {
    std::vector<std::string> left, right;
};
ComparedTexts differences(const SceneOptions& left, const SceneOptions& right);

/// The options of the picture left of the line.
SceneOptions leftOptions(const ViewModel& model);

/// Compares what is set from now on with what is set now, or ends that.
void toggleComparison(ViewModel& model);
/// Exchanges the settings of the two sides; those of the right side are the ones that panels show.
void swapComparison(ViewModel& model);

/// Draws the line with what differs beside it, and lets the pointer drag it. Returns whether the left button
/// belongs to it. To be called in an ImGui frame, after `driveGizmo`, which the pointer reaches first.
bool driveComparison(ViewModel& model);
