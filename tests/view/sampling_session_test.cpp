// A picture at rest is refined sample by sample.

#include "view_session.h"

namespace {

class SamplingSession : public ViewTest {};

TEST_F(SamplingSession, PicturesAtRestAreRefinedUntilTheyHaveTheirSamples) {
    ViewSession session({"square.gltf", "--size", smallSize, "--samples", "6"});
    session.awaitScene();
    ASSERT_TRUE(session.stepUntil([&] { return session.model().samples == 6; }));
    session.step(3);
    EXPECT_EQ(session.model().samples, 6u) << "and no more";
    EXPECT_EQ(
        maxDifference(session.picture(), rendered({"square.gltf", "--size", smallSize, "--samples", "6"})),
        0);
    session.model().options.sampling.count = 9;
    ASSERT_TRUE(session.stepUntil([&] { return session.model().samples == 9; }));
}

TEST_F(SamplingSession, WhatChangesBeginsAgainWithOneSample) {
    ViewSession session({"square.gltf", "--size", smallSize, "--samples", "5"});
    session.awaitScene();
    ASSERT_TRUE(session.stepUntil([&] { return session.model().samples == 5; }));
    session.model().options.time = 0.5;
    session.step();
    EXPECT_EQ(session.model().samples, 1u);
    ASSERT_TRUE(session.stepUntil([&] { return session.model().samples == 5; }));
    session.model().playing = true;
    session.step(2);
    EXPECT_EQ(session.model().samples, 1u) << "while it moves";
    session.model().playing = false;
    session.model().options.debug.view = candela::DebugView::normals;
    session.step(4);
    EXPECT_EQ(session.model().samples, 1u) << "debug views have one";
}

TEST_F(SamplingSession, LensAndShutterAreThoseOfCandelaRender) {
    const std::vector<std::string> arguments{"square.gltf", "--size",    smallSize, "--samples", "4",
                                             "--aperture",  "0.05",      "--focus", "1.5",       "--blades",
                                             "5",           "--shutter", "1",       "--time",    "0.5"};
    ViewSession session(arguments);
    session.awaitScene();
    ASSERT_TRUE(session.stepUntil([&] { return session.model().samples == 4; }));
    EXPECT_EQ(maxDifference(session.picture(), rendered(arguments)), 0);
    EXPECT_EQ(maxDifference(session.picture(), renderedBy(session.copiedCommand())), 0);
}

}  // namespace
