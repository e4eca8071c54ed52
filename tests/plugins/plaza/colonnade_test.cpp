// The scene of columns: it is the same on every machine.
#include "procedural_scene.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Colonnade, IsTheSameOnEveryMachine) {
    const Scene scene = importProcedural("colonnade:1000").scene;
    EXPECT_EQ(scene.lights.size(), 1000u);
    EXPECT_EQ(geometryHash(scene), 0x7B8C38DBA442686Du) << std::hex << geometryHash(scene);
    EXPECT_EQ(lightHash(scene.lights), 0x8E12E668B6A429A1u) << std::hex << lightHash(scene.lights);
}

TEST(Colonnade, ColumnsAreInstancesOfOneMesh) {
    const Scene scene = importProcedural("colonnade:0").scene;
    std::size_t columns = 0;
    for (const Node& node : scene.nodes) columns += node.name.starts_with("column") ? 1 : 0;
    EXPECT_EQ(columns, 64u);
    EXPECT_EQ(scene.meshes.size(), 3u);
}

}  // namespace
}  // namespace candela
