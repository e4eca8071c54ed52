#pragma once

#include <candela/renderer.h>

#include <array>

namespace candela::test {

/// Every technique that brings lights to pixels, and every model: tests of lighting loop over them.
inline constexpr std::array techniques{Technique::volumes, Technique::tiles, Technique::fullscreen};
inline constexpr std::array models{BrdfModel::course, BrdfModel::gltf};

}  // namespace candela::test
