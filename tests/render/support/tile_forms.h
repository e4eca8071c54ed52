#pragma once

#include "render/lighting/lighting_technique.h"

#include <candela/camera.h>
#include <candela/context.h>
#include <candela/scene.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace candela::test {

/// A form of the technique `tiles`: a kernel of one instruction set, or compute.
struct TileForm {
    std::string name;
    std::unique_ptr<LightingTechnique> technique;
};

/// Every form that this machine runs.
std::vector<TileForm> tileForms();

/// Forms whose lists may take 64 KiB: they shade the lights in several parts.
std::vector<TileForm> limitedTileForms();

/// The reference technique in the same harness.
TileForm fullscreenForm();

/// A picture to draw with any form.
struct FormPicture {
    const Scene& scene;
    std::span<const WorldLight> lights;
    CameraView view;
    int width = 96, height = 54;
    BrdfModel brdf = BrdfModel::course;
    int frames = 2;
};

/// The radiance that a form makes in the last of several frames: RGBA, rows from the bottom.
std::vector<float> radianceOf(const Context& context, const TileForm& form, const FormPicture& picture);

}  // namespace candela::test
