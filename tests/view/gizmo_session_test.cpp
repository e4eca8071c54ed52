// What is picked is moved by its gizmo, and shown by its outline.

#include "gizmo_math.h"
#include "interaction.h"
#include "outline.h"
#include "own_display.h"
#include "view_session.h"

#include <epoxy/gl.h>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {

constexpr int leftButton = 1;

/// The sample scene in a window without panels: a square in the middle, a light before it.
class GizmoSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        session = std::make_unique<ViewSession>(
            std::vector<std::string>{"square.gltf", "--size", smallSize, "--shadows", "off"});
        session->awaitScene();
        session->stepUntilIdle();
    }

    /// The place of a point in the window.
    glm::ivec2 placeOf(const glm::vec3& point) {
        const ScreenView screen(selectedView(session->model()), {0.0f, 0.0f}, {320.0f, 240.0f});
        return glm::ivec2(glm::round(*screen.at(point)));
    }
    /// Drags the handle of the X axis by so many pixels along the axis, which is to the right.
    void dragX(const glm::vec3& origin, int pixels) {
        // In the middle of the axis, of 5.5 letters.
        const glm::ivec2 handle = placeOf(origin) + glm::ivec2(35, 0);
        session->drag(leftButton, handle.x, handle.y, handle.x + pixels, handle.y);
    }
    Document& document() { return session->document(); }

    std::unique_ptr<ViewSession> session;
};

TEST_F(GizmoSession, ALightIsMovedAlongAnAxisAndBack) {
    const glm::vec3 before = document().lights()[0].position;
    const PngPicture picture = session->picture();
    session->model().pickedLight = 0;
    session->step(2);
    dragX(before, 20);
    const glm::vec3 after = document().lights()[0].position;
    EXPECT_GT(after.x, before.x + 0.01f);
    // Only along X: the other axes are added to 0 and multiplied by 1.
    EXPECT_EQ(after.y, before.y);
    EXPECT_EQ(after.z, before.z);
    EXPECT_FALSE(session->model().options.eye) << "the camera stays";
    EXPECT_GT(maxDifference(session->picture(), picture), 0);
    session->sendFast("key --delay 0 ctrl+z");
    EXPECT_EQ(document().lights()[0].position, before);
    EXPECT_EQ(maxDifference(session->picture(), picture), 0);
}

TEST_F(GizmoSession, ANodeIsMovedTurnedAndScaled) {
    const PngPicture picture = session->picture();
    session->click(160, 120);
    ASSERT_EQ(session->model().pickedNode, 0u);
    const candela::Bounds before = document().bounds(0);
    for (const char* key : {"w", "e", "r"}) {
        session->sendFast("key --delay 0 " + std::string(key));
        session->model().messages.clear();  // of the pictures written, which lie over the picture
        session->step(2);
        const glm::vec3 middle = 0.5f * (before.min + before.max);
        if (*key == 'e') {
            // On the circle about Z, which faces the camera: its radius is 5.5 letters.
            const glm::ivec2 handle = placeOf(middle) + glm::ivec2(54, -54);
            session->drag(leftButton, handle.x, handle.y, handle.x - 20, handle.y - 15);
        } else {
            dragX(middle, 20);
        }
        EXPECT_FALSE(session->model().options.eye) << key;
        EXPECT_FALSE(document().changes().empty()) << key;
        const candela::Bounds after = document().bounds(0);
        EXPECT_GT(glm::distance(after.max, before.max), 0.01f) << key;
        EXPECT_GT(maxDifference(session->picture(), picture), 0) << key;
        session->sendFast("key --delay 0 ctrl+z");
        EXPECT_TRUE(document().changes().empty()) << key;
        EXPECT_EQ(maxDifference(session->picture(), picture), 0) << key;
    }
}

TEST_F(GizmoSession, ALightIsPickedByItsIcon) {
    const glm::ivec2 place = placeOf(document().lights()[0].position);
    session->click(place.x, place.y);
    EXPECT_FALSE(session->model().pickedLight) << "icons are not shown";
    session->sendFast("key --delay 0 l");
    session->click(place.x, place.y);
    EXPECT_EQ(session->model().pickedLight, 0u);
    EXPECT_FALSE(session->model().pickedNode);
}

TEST_F(GizmoSession, AnOutlineIsAroundWhatIsPicked) {
    constexpr std::array<float, 4> black{};
    glClearNamedFramebufferfv(0, GL_COLOR, 0, black.data());
    {
        Outline outline;
        outline.draw({document().scene(), 0, 0.0, 1}, selectedView(session->model()),
                     {.corner = {0, 0}, .size = {320, 240}}, 2.0f);
    }
    std::vector<std::uint8_t> pixels(4u * 320u * 240u);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, 320, 240, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    const auto red = [&](int x, int y) {
        return int{pixels[static_cast<std::size_t>(4 * ((239 - y) * 320 + x))]};
    };
    // The upper left corner of the square. Left of it there is the line, and farther away and inside none.
    const candela::Bounds box = document().bounds(0);
    const glm::ivec2 corner = placeOf({box.min.x, box.max.y, 0.5f * (box.min.z + box.max.z)});
    EXPECT_GT(red(corner.x - 1, corner.y + 6), 150);
    EXPECT_EQ(red(corner.x - 6, corner.y + 6), 0);
    EXPECT_EQ(red(corner.x + 4, corner.y + 6), 0);
}

TEST_F(GizmoSession, AnOrthographicViewHasThemToo) {
    session->model().camera.setOrthographicHeight(3.0f);
    storeCamera(session->model());
    session->click(160, 120);
    ASSERT_EQ(session->model().pickedNode, 0u);
    const candela::Bounds before = document().bounds(0);
    dragX(0.5f * (before.min + before.max), 20);
    EXPECT_GT(document().bounds(0).max.x, before.max.x + 0.01f);
    EXPECT_EQ(session->messages(Message::Kind::error), 0u);
}

TEST_F(GizmoSession, GridAndIconsAreNoPartOfThePicture) {
    const PngPicture picture = session->picture();
    session->sendFast("key --delay 0 g key --delay 0 l");
    EXPECT_TRUE(session->model().guides.grid);
    EXPECT_TRUE(session->model().guides.lights);
    EXPECT_EQ(maxDifference(session->picture(), picture), 0);
}

}  // namespace
