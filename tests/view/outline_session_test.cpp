// The line around what is picked.

#include "command.h"
#include "view_session.h"

#include <algorithm>

namespace {

class OutlineSession : public ViewTest {};

constexpr const char* cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

/// Whether a pixel that the node covers is so near.
bool isNear(const ExrPicture& nodes, int x, int y, int reach) {
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const int atX = std::clamp(x + dx, 0, nodes.width - 1),
                      atY = std::clamp(y + dy, 0, nodes.height - 1);
            if (nodes.at("A", atX, atY) > 0.0f) return true;
        }
    return false;
}

TEST_F(OutlineSession, FollowsTheLimitSurfaceOfACage) {
    folder.write("cube.obj", cube);
    const std::vector<std::string> arguments{"cube.obj?subdivide", "--size", smallSize};
    ViewSession session(arguments);
    session.awaitScene();
    session.model().messages.clear();
    session.step(2);
    session.stepUntilIdle();
    session.model().pickedNode = 0;
    session.step(2);
    const PngPicture outlined = session.shown();
    expectSuccess(runCommand(
        {"cube.obj?subdivide", "--size", smallSize, "--samples", "1", "-o", "nodes.exr", "--quiet"},
        {.folder = folder.path()}));
    const ExrPicture nodes = readExr(folder / "nodes.exr");
    int count = 0, near = 0;
    for (int y = 0; y < outlined.height; ++y)
        for (int x = 0; x < outlined.width; ++x) {
            const auto i = static_cast<std::size_t>(4 * (y * outlined.width + x));
            // Its colour alone: the gizmo has others.
            if (outlined.rgba[i] != 242 || outlined.rgba[i + 1] != 168) continue;
            ++count;
            // The line is two pixels wide, and the surface drawn finer than it is outlined.
            near += isNear(nodes, x, y, 4);
        }
    EXPECT_GT(count, 100);
    EXPECT_EQ(near, count);
}

}  // namespace
