#pragma once

#include <candela/light.h>

#include <glm/vec3.hpp>

/// How the picked light is edited.
struct LightEditing {
    enum class ColorBy { rgb, temperature } colorBy = ColorBy::rgb;
    enum class Unit { candela, lumen } unit = Unit::candela;
    glm::vec3 hue{1.0f};         ///< That the light had while it was not black.
    glm::vec3 target{0.0f};      ///< Where the camera looks.
    float metresAPixel = 0.01f;  ///< Speed of dragging.
};

/// Draws the values of a light. Returns whether the user changed one.
bool editLight(candela::WorldLight& light, LightEditing& editing);

/// The short name of its kind: "point", "spot", "directional".
const char* nameOf(candela::LightType type);
