// Sets of texture coordinates from 2 on.
#include "sample_scene.h"
#include "validate/broken_rule.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace candela {
namespace {

/// The sample scene, whose texture reads set 3 of a mesh without set 2.
Scene sceneWithSets() {
    Scene scene = sampleScene();
    scene.meshes[0].furtherUvs = {{}, scene.meshes[0].uv0};
    scene.materials[0].baseColorTexture->uvSet = 3;
    return scene;
}

TEST(FurtherUvs, Rules) {
    EXPECT_NO_THROW(validate(sceneWithSets()));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    expectMessages(
        sceneWithSets(),
        {
            {"mesh 0 'wheel': has 1 texture coordinates 3 for 4 vertices",
             [](Scene& s) { s.meshes[0].furtherUvs[1].resize(1); }},
            {"mesh 0 'wheel': texture coordinate 2 of vertex 0 is not a finite number",
             [](Scene& s) { s.meshes[0].furtherUvs[0].assign(4, glm::vec2(nan)); }},
            {"mesh 0 'wheel': may have 18 sets of texture coordinates at most",
             [](Scene& s) { s.meshes[0].furtherUvs.resize(17); }},
            {"mesh 0 'wheel': has no texture coordinates 2, which a texture of material 0 'wall' reads",
             [](Scene& s) { s.materials[0].baseColorTexture->uvSet = 2; }},
        });
}

}  // namespace
}  // namespace candela
