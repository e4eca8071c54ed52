#pragma once

#include "common/scene_options.h"

#include <string>

/// The candela-render command that draws the picture of `options`, quoted for a shell. Numbers are written so
/// that they are read back to the last bit.
std::string renderCommandLine(const SceneOptions& options);
