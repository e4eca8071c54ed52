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

/// The reference technique in the same harness.
TileForm fullscreenForm();

/// A picture to draw with any form.
struct FormPicture {
    const Scene& scene;
    std::span<const WorldLight> lights;
    CameraView view;
    int width = 96, height = 54;
    BrdfModel brdf = BrdfModel::course;
};

/// The radiance that a form makes: RGBA, rows from the bottom. Draws twice, so that the second frame finds
/// what the first has left.
std::vector<float> radianceOf(const Context& context, const TileForm& form, const FormPicture& picture);

}  // namespace candela::test
