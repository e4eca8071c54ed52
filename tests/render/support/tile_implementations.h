#pragma once

#include "render/lighting/lighting_technique.h"

#include <candela/camera.h>
#include <candela/context.h>
#include <candela/scene.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace candela::test {

/// An implementation of the technique `tiles`: a kernel of one instruction set, or compute.
struct TileImplementation {
    std::string name;
    std::unique_ptr<LightingTechnique> technique;
};

/// Every implementation that this machine supports.
std::vector<TileImplementation> tileImplementations();

/// Implementations whose lists may take 64 KiB: they shade the lights in several parts.
std::vector<TileImplementation> limitedTileImplementations();

/// The reference technique in the same harness.
TileImplementation fullscreenImplementation();

/// Scene, lights, view and size of a frame to draw with any implementation.
struct TileTestFrame {
    const Scene& scene;
    std::span<const WorldLight> lights;
    CameraView view;
    int width = 96, height = 54;
    BrdfModel brdf = BrdfModel::course;
    int frames = 2;
    const std::uint8_t* environmentVisibility = nullptr;  ///< As in `LightingInputs`.
};

/// The radiance of the last of several frames: RGBA, rows from the bottom.
std::vector<float> radianceOf(const Context& context, const TileImplementation& implementation,
                              const TileTestFrame& picture);

}  // namespace candela::test
