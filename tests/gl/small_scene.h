#pragma once

#include "support/frame_request.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <candela/renderer.h>

namespace candela::test {

/// Frames for tests of contexts and state: every kind of light, textured and plain surfaces, emission.
inline LitScene smallScene() {
    LitScene made = textured();
    place(made.scene, makeSphere(0.4f), Material{});
    made.lights.push_back(directionalLight({0, -1, -1}, {0.5f, 0.5f, 0.5f}));
    // The eye stands inside this one, so that volumes are drawn both ways.
    made.lights.push_back(pointLight(made.view.eye(), 2.8f, {1, 1, 1}));
    return made;
}

inline FrameRequest smallFrame(const LitScene& made, Technique technique, int width = 48, int height = 32) {
    return {width, height, made.view, BrdfModel::gltf, technique};
}

}  // namespace candela::test
