#pragma once

#include "support/frame_request.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <candela/renderer.h>

namespace candela::test {

/// Frames for tests of contexts and state: every kind of light, textured and plain surfaces, emission.
inline LitScene smallScene() {
    LitScene lit = textured();
    place(lit.scene, makeSphere(0.4f), Material{});
    lit.lights.push_back(directionalLight({0, -1, -1}, {0.5f, 0.5f, 0.5f}));
    // The eye is inside this one's volume, which is then drawn by its back faces.
    lit.lights.push_back(pointLight(lit.view.eye(), 2.8f, {1, 1, 1}));
    return lit;
}

inline FrameRequest smallFrame(const LitScene& lit, Technique technique, int width = 48, int height = 32) {
    return {width, height, lit.view, BrdfModel::gltf, technique};
}

}  // namespace candela::test
