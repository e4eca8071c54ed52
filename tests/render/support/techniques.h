#pragma once

#include <candela/renderer.h>

#include <array>

namespace candela::test {

/// Every lighting technique and every BRDF model; tests of lighting iterate over them.
inline constexpr std::array techniques{Technique::volumes, Technique::tiles, Technique::fullscreen};
inline constexpr std::array models{BrdfModel::course, BrdfModel::gltf};

}  // namespace candela::test
