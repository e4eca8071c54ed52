// Meshes are checked on all cores: the error is that of a check in order.

#include "sample_scene.h"
#include "validate/broken_rule.h"

#include <candela/scene.h>
#include <candela/threads.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

namespace candela {
namespace {

const float nan_ = std::numeric_limits<float>::quiet_NaN();

/// Of several threads, also where the machine has one core.
class ManyValues : public testing::Test {
  protected:
    void SetUp() override { setThreadCount(4); }
    void TearDown() override { setThreadCount(0); }
};

TEST_F(ManyValues, TheFirstBrokenOneIsNamed) {
    constexpr std::size_t vertices = 100'000;
    Scene scene = sampleScene();
    Mesh large;
    large.positions.resize(vertices);
    large.normals.assign(vertices, {0, 0, 1});
    large.indices.assign(3 * vertices, 0);
    scene.meshes.insert(scene.meshes.end(), 200, scene.meshes[0]);
    scene.meshes.insert(scene.meshes.begin() + 100, large);
    EXPECT_NO_THROW(validate(scene));
    expectMessages(scene, {{"mesh 60 'wheel': position 2 is not a finite number",
                            [](Scene& s) {
                                for (const std::size_t mesh : {180, 130, 90, 61, 60})
                                    s.meshes[mesh].positions[2].x = nan_;
                                s.meshes[100].normals[0].x = nan_;
                            }},
                           {"mesh 100: normal 70000 does not have unit length",
                            [](Scene& s) {
                                s.meshes[100].normals[99'999].x = nan_;
                                s.meshes[100].normals[70'000] = {0, 0, 0};
                                s.meshes[101].positions[2].x = nan_;
                            }},
                           {"mesh 100: index 250001 names vertex 100000, but there are 100000", [](Scene& s) {
                                s.meshes[100].indices[299'999] = 4'000'000'000;
                                s.meshes[100].indices[250'001] = 100'000;
                            }}});
}

}  // namespace
}  // namespace candela
