#pragma once

#include <candela/material.h>

/// The lobes and media of a material besides metallic and roughness, folded away until they are wanted.
/// Returns whether the user changed any.
bool editLobes(candela::Material& material);
