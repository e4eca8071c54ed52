#pragma once

#include <string>

/// A self-contained glTF file: a square of 2 m × 2 m in the plane z = 0 that faces +Z, linear base colour
/// (0.5, 0.25, 0.125), metallic 0, roughness 0.5; cameras "front" at (0, 0, 3) and "far" at (0, 0, 6), both
/// 90 degrees; a white point light of 10 cd and 20 m range that moves from (0, 0, 1) at 0 s to (0, 0, 9) at
/// 1 s; and an unknown optional extension.
std::string sampleScene();

/// The same without cameras.
std::string sampleSceneWithoutCameras();
