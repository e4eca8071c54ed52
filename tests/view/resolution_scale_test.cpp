#include "resolution_scale.h"

#include <gtest/gtest.h>

namespace {

using std::chrono::milliseconds;

class CoarsenessTest : public testing::Test {
  protected:
    int at(int time, Motion motion) { return coarseness.divisor(motion, start + milliseconds(time)); }

    const ResolutionScale::Clock::time_point start = ResolutionScale::Clock::now();
    ResolutionScale coarseness;
};

TEST_F(CoarsenessTest, AFastDeviceStaysSharp) {
    EXPECT_EQ(at(0, Motion::rests), 1);
    coarseness.tookMilliseconds(15.0);
    EXPECT_EQ(at(20, Motion::moves), 1);
    EXPECT_FALSE(coarseness.isReduced());
}

TEST_F(CoarsenessTest, ASlowDeviceIsCoarserWhileItMoves) {
    at(0, Motion::rests);
    coarseness.tookMilliseconds(150.0);
    EXPECT_EQ(at(20, Motion::moves), 2);
    at(30, Motion::rests);
    coarseness.tookMilliseconds(1000.0);
    EXPECT_EQ(at(40, Motion::moves), 4);
    EXPECT_TRUE(coarseness.isReduced());
}

TEST_F(CoarsenessTest, SharpensAfterAShortRestOnly) {
    at(0, Motion::rests);
    coarseness.tookMilliseconds(400.0);
    EXPECT_EQ(at(20, Motion::moves), 4);
    coarseness.tookMilliseconds(25.0);
    EXPECT_EQ(at(40, Motion::rests), 4) << "the hand has only paused";
    EXPECT_EQ(at(60, Motion::moves), 4);
    EXPECT_EQ(at(500, Motion::rests), 1);
    EXPECT_FALSE(coarseness.isReduced());
}

TEST_F(CoarsenessTest, TakesTheTimeOfACoarsePictureForAPartOfAFullOne) {
    at(0, Motion::rests);
    coarseness.tookMilliseconds(400.0);
    EXPECT_EQ(at(20, Motion::moves), 4);
    coarseness.tookMilliseconds(25.0);  // 16 times that at full size
    EXPECT_EQ(at(40, Motion::moves), 4);
    coarseness.tookMilliseconds(2.0);  // the scene has become light
    EXPECT_EQ(at(60, Motion::moves), 1);
}

}  // namespace
