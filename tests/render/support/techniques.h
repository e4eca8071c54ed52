#pragma once

#include <candela/renderer.h>

#include <array>

namespace candela::test {

/// Every lighting technique and every BRDF model; tests of lighting iterate over them.
inline constexpr std::array techniques{Technique::volumes, Technique::tiles, Technique::fullscreen};
inline constexpr std::array models{BrdfModel::course, BrdfModel::gltf};

/// A technique with what runs it.
struct Form {
    Technique technique;
    TileBackend backend;
    const char* name;
};

/// What traces rays on the CPU, what traces them in shaders, and all of these.
inline constexpr Form cpuTiles{Technique::tiles, TileBackend::cpu, "tiles on the CPU"};
inline constexpr std::array shaderForms{Form{Technique::fullscreen, TileBackend::automatic, "fullscreen"},
                                        Form{Technique::volumes, TileBackend::automatic, "volumes"},
                                        Form{Technique::tiles, TileBackend::compute, "tiles in compute"}};
inline constexpr std::array forms{cpuTiles, shaderForms[0], shaderForms[1], shaderForms[2]};

}  // namespace candela::test
