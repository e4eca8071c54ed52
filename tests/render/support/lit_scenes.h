#pragma once

#include <candela/camera.h>
#include <candela/light.h>
#include <candela/scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace candela::test {

/// A scene with its lights and a view, for comparing techniques with each other and with the evaluator.
struct LitScene {
    std::string name;
    Scene scene;
    std::vector<WorldLight> lights;
    CameraView view;
};

/// Spheres of all roughnesses, half of them metal, over a floor, under 48 point lights of 3 m range.
LitScene spheresOnAFloor();
/// All textures that a surface can have, vertex colours, emission, spots and a point without range.
LitScene textured();
/// Two directional lights and spots, one of them with the narrowest cone.
LitScene sunAndSpots();
/// Spheres with every further lobe and random stacks of them, and sheets lit from behind, over a plain floor.
LitScene manyLobes();
/// Lights 2 mm to 10 km from the surface.
LitScene nearAndFar();
/// Spheres of roughness 0 and a little more under lights of 1e6 cd.
LitScene smoothAndBright();
/// A floor viewed and lit at grazing angles.
LitScene grazing();

/// `spheresOnAFloor` in an orthographic view from the side.
LitScene orthographic();
/// `spheresOnAFloor` behind a far plane that cuts the floor and the reach of lights.
LitScene withFarPlane();

std::vector<LitScene> litScenes();

/// Point lights and spots in a box of 10 × 8 × 12 m around the origin.
std::vector<WorldLight> mixedLocalLights(std::uint32_t count, float range);

}  // namespace candela::test
