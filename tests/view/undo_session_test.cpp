// Every edit is undone and done again, with the image that it had.

#include "interaction.h"
#include "view_session.h"

#include <functional>

namespace {

using Visibility = candela::GpuScene::Visibility;

class UndoSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        session = std::make_unique<ViewSession>(std::vector<std::string>{
            "square.gltf", "--size", smallSize, "--shadows", "off", "--scatter-lights", "5"});
        session->awaitScene();
        session->stepUntilIdle();
    }

    /// An edit, as a user does it: the frame after it ends the step.
    void edit(const std::function<void()>& change) {
        change();
        session->step();
    }
    void undo() { document().undo(session->model().options); }
    void redo() { document().redo(session->model().options); }
    Document& document() { return session->document(); }

    /// Undone, the edit leaves the image and the changes from before it, and done again those after it.
    void expectUndone(const std::function<void()>& change) {
        const PngPicture before = session->picture();
        const std::vector<std::string> changes = document().changes();
        edit(change);
        const PngPicture after = session->picture();
        const std::vector<std::string> changed = document().changes();
        EXPECT_GT(maxDifference(before, after), 0);
        for (int i = 0; i < 2; ++i) {
            undo();
            EXPECT_EQ(maxDifference(session->picture(), before), 0);
            EXPECT_EQ(document().changes(), changes);
            redo();
            EXPECT_EQ(maxDifference(session->picture(), after), 0);
            EXPECT_EQ(document().changes(), changed);
        }
    }

    std::unique_ptr<ViewSession> session;
};

TEST_F(UndoSession, AMaterial) {
    candela::Material material = document().scene().materials[0];
    material.baseColor = {1.0f, 0.0f, 0.0f, 1.0f};
    expectUndone([&] { document().setMaterial(0, material); });
}

TEST_F(UndoSession, TheVisibilityOfANode) {
    expectUndone([&] { document().setVisibility(0, Visibility::hidden); });
}

TEST_F(UndoSession, LightsThatAreMovedAddedRemovedAndScattered) {
    candela::WorldLight light = document().lights()[0];
    light.intensity *= 3.0f;
    expectUndone([&] { document().setLight(0, light); });
    light.position.x += 0.5f;
    expectUndone([&] { document().addLight(light); });
    ASSERT_EQ(document().lights().size(), 7u);
    expectUndone([&] { document().removeLight(0); });
    expectUndone([&] { document().removeLight(3); });
    expectUndone([&] { document().scatterLights({.count = 9, .range = 1.0f, .candela = 0.5f, .seed = 2}); });
    // Everything from the start.
    while (document().history().canUndo()) undo();
    EXPECT_EQ(document().lights().size(), 6u);
    EXPECT_TRUE(document().changes().empty());
    while (document().history().canRedo()) redo();
    EXPECT_EQ(document().lights().size(), 10u);
}

TEST_F(UndoSession, OptionsButNotTheCamera) {
    SceneOptions& options = session->model().options;
    expectUndone([&] { options.brdf = candela::BrdfModel::gltf; });
    expectUndone([&] { options.display.exposure = 1.5; });
    expectUndone([&] { options.environment.source = EnvironmentOption::Source::studio; });
    storeCamera(session->model());
    options.eye->eye.x += 0.5;
    options.time = 0.25;
    session->step();
    const glm::dvec3 eye = options.eye->eye;
    undo();
    ASSERT_TRUE(options.eye);
    EXPECT_EQ(options.eye->eye, eye);
    EXPECT_EQ(options.time, 0.25);
    EXPECT_EQ(options.environment.source, EnvironmentOption::Source::own);
}

TEST_F(UndoSession, NothingIsThereToUndoAtFirst) {
    EXPECT_FALSE(document().history().canUndo());
    undo();
    redo();
    EXPECT_TRUE(document().changes().empty());
}

TEST_F(UndoSession, AnEditAfterUndoneOnesTakesTheirPlace) {
    edit([&] { document().setVisibility(0, Visibility::hidden); });
    undo();
    edit([&] { session->model().options.display.exposure = 1.0; });
    EXPECT_FALSE(document().history().canRedo());
    undo();
    EXPECT_FALSE(document().history().canUndo());
    EXPECT_EQ(document().visibility(0), Visibility::shown);
}

}  // namespace
