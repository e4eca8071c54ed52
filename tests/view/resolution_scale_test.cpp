#include "viewport.h"

#include <gtest/gtest.h>

namespace {

using std::chrono::milliseconds;

class ResolutionScaleTest : public testing::Test {
  protected:
    int at(int time, Motion motion) { return scale.divisor(motion, start + milliseconds(time)); }

    const ResolutionScale::Clock::time_point start = ResolutionScale::Clock::now();
    ResolutionScale scale;
};

TEST_F(ResolutionScaleTest, AFastDeviceKeepsFullResolution) {
    EXPECT_EQ(at(0, Motion::rests), 1);
    scale.tookMilliseconds(15.0);
    EXPECT_EQ(at(20, Motion::moves), 1);
    EXPECT_FALSE(scale.isReduced());
}

TEST_F(ResolutionScaleTest, ASlowDeviceLowersTheResolutionWhileTheCameraMoves) {
    at(0, Motion::rests);
    scale.tookMilliseconds(150.0);
    EXPECT_EQ(at(20, Motion::moves), 2);
    at(30, Motion::rests);
    scale.tookMilliseconds(1000.0);
    EXPECT_EQ(at(40, Motion::moves), 4);
    EXPECT_TRUE(scale.isReduced());
}

TEST_F(ResolutionScaleTest, RestoresFullResolutionAfterAShortDelay) {
    at(0, Motion::rests);
    scale.tookMilliseconds(400.0);
    EXPECT_EQ(at(20, Motion::moves), 4);
    scale.tookMilliseconds(25.0);
    EXPECT_EQ(at(40, Motion::rests), 4) << "the camera has only just stopped";
    EXPECT_EQ(at(60, Motion::moves), 4);
    EXPECT_EQ(at(500, Motion::rests), 1);
    EXPECT_FALSE(scale.isReduced());
}

TEST_F(ResolutionScaleTest, ScalesTheTimeOfALowResolutionFrameToFullResolution) {
    at(0, Motion::rests);
    scale.tookMilliseconds(400.0);
    EXPECT_EQ(at(20, Motion::moves), 4);
    scale.tookMilliseconds(25.0);  // 16 times that at full size
    EXPECT_EQ(at(40, Motion::moves), 4);
    scale.tookMilliseconds(2.0);  // the scene has become cheap
    EXPECT_EQ(at(60, Motion::moves), 1);
}

}  // namespace
