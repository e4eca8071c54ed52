// Two settings beside each other, with a line between them that the pointer moves.

#include "comparison.h"
#include "own_display.h"
#include "view_session.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr int width = 320, height = 240;

/// The largest difference in the columns from `first` to before `end`, above the captions and below the top.
int difference(const PngPicture& a, const PngPicture& b, int first, int end) {
    int largest = 0;
    for (int y = 10; y < height - 100; ++y)
        for (int x = first; x < end; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const auto i = static_cast<std::size_t>(4 * (y * width + x) + channel);
                largest = std::max(largest, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
            }
    return largest;
}

class ComparisonSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        session = std::make_unique<ViewSession>(std::vector<std::string>{
            "square.gltf", "--size", smallSize, "--eye", "0,0,0.7", "--target", "0,0,0", "--samples", "3"});
        session->awaitScene();
        session->stepUntilIdle();
    }
    /// Draws all samples, without messages over them.
    void settle() {
        session->model().messages.clear();
        session->step();
        session->stepUntilIdle();
    }
    /// Expects picture `left` left of the line at a column, and `right` right of it.
    void expectSides(const PngPicture& left, const PngPicture& right, int column) const {
        constexpr int handle = 20;  // of the line, in pixels
        const PngPicture shown = session->shown();
        EXPECT_EQ(difference(shown, left, 0, column - handle), 0);
        EXPECT_EQ(difference(shown, right, column + handle, width), 0);
        EXPECT_GT(difference(shown, right, 0, column - handle), 0);
        EXPECT_GT(difference(shown, left, column + handle, width), 0);
    }
    Comparison& comparison() { return session->model().comparison; }
    SceneOptions& options() { return session->model().options; }

    std::unique_ptr<ViewSession> session;
};

TEST_F(ComparisonSession, EachSideShowsItsOwnSettingsWithAllSamples) {
    const PngPicture before = session->picture();
    session->sendFast("key --delay 0 c");
    ASSERT_TRUE(comparison().shown);
    options().environment.source = EnvironmentOption::Source::sky;
    options().brdf = candela::BrdfModel::gltf;
    options().display.exposure = -1.0;
    settle();
    const PngPicture after = session->picture();
    settle();
    expectSides(before, after, width / 2);
    const ComparedTexts texts = differences(leftOptions(session->model()), options());
    EXPECT_EQ(texts.left, (std::vector<std::string>{"reflection: course", "environment: of the scene",
                                                    "exposure: +0.00 stops"}));
    EXPECT_EQ(texts.right,
              (std::vector<std::string>{"reflection: gltf", "environment: sky", "exposure: -1.00 stops"}));

    session->sendFast("key --delay 0 shift+c");
    EXPECT_EQ(options().brdf, candela::BrdfModel::course);
    settle();
    expectSides(after, before, width / 2);
    session->document().undo(options());
    EXPECT_EQ(options().brdf, candela::BrdfModel::gltf) << "the swap is an edit";

    session->sendFast("key --delay 0 c");
    EXPECT_FALSE(comparison().shown);
    settle();
    EXPECT_EQ(difference(session->shown(), after, 0, width), 0);
}

TEST_F(ComparisonSession, EnvironmentsOfFilesAreReadOnce) {
    // Radiance pictures of 4 x 2 pixels with the same mantissas and exponent: 1 in a channel.
    const auto write = [&](const std::string& name, const std::string& pixel) {
        std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
        for (int i = 0; i < 8; ++i) text += pixel;
        folder.write(name, text);
    };
    write("red.hdr", std::string("\x80\0\0\x81", 4));
    write("blue.hdr", std::string("\0\0\x80\x81", 4));
    using enum EnvironmentOption::Source;
    options().environment = {.source = file, .file = "red.hdr"};
    options().sampling.count = 1;
    options().display.exposure = -4.0;  // so that the lamp leaves nothing white
    const PngPicture red = session->picture();
    session->sendFast("key --delay 0 c");
    options().environment.file = "blue.hdr";
    const PngPicture blue = session->picture();
    ASSERT_EQ(session->messages(Message::Kind::error), 0u) << session->model().messages.back().text;
    settle();
    expectSides(red, blue, width / 2);
    // Both sides are drawn anew, with either environment.
    const auto dim = [&] {
        candela::WorldLight lamp = session->document().lights()[0];
        lamp.intensity *= 0.5f;
        session->document().setLight(0, lamp);
        settle();
    };
    dim();
    for (const char* file : {"red.hdr", "blue.hdr"}) std::filesystem::remove(file);
    dim();
    const PngPicture right = session->picture();
    swapComparison(session->model());
    const PngPicture left = session->picture();
    swapComparison(session->model());
    session->step();
    EXPECT_EQ(session->messages(Message::Kind::error), 0u);
    settle();
    expectSides(left, right, width / 2);
}

TEST_F(ComparisonSession, ThePointerMovesTheLineAndNothingElse) {
    const PngPicture before = session->picture();
    session->sendFast("key --delay 0 c");
    options().display.exposure = 1.0;
    session->step();
    const PngPicture after = session->picture();
    const glm::dvec3 eye = options().eye->eye;
    session->drag(1, width / 2, 100, width / 4, 120);
    EXPECT_NEAR(comparison().line, 0.25f, 0.01f);
    EXPECT_EQ(options().eye->eye, eye) << "the camera stays";
    settle();
    expectSides(before, after, width / 4);
    session->click(width / 4, 100);
    EXPECT_FALSE(session->model().pickedNode) << "a press on the line picks nothing";
    // Beyond the edge it stays at the edge.
    session->drag(1, width / 4, 100, 2, 100);
    session->drag(1, static_cast<int>(comparison().line * width), 100, 0, 100);
    EXPECT_EQ(comparison().line, 0.0f);
    session->click(width / 2, 100);
    EXPECT_EQ(session->model().pickedNode, 0u);
}

TEST_F(ComparisonSession, ACameraThatMovesMovesBothSides) {
    session->sendFast("key --delay 0 c");
    options().shadows = candela::Shadows::off;
    options().display.exposure = 1.0;
    session->step();
    const glm::dvec3 eye = options().eye->eye;
    session->drag(1, 60, 100, 90, 110);
    ASSERT_NE(options().eye->eye, eye);
    session->stepUntilIdle();
    const PngPicture right = session->picture();
    swapComparison(session->model());
    session->step();
    const PngPicture left = session->picture();
    swapComparison(session->model());
    settle();
    expectSides(left, right, width / 2);
}

}  // namespace
