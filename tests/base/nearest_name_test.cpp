#include <candela/nearest_name.h>

#include <gtest/gtest.h>

#include <vector>

namespace candela {
namespace {

const std::vector<std::string> names{"volumes", "tiles", "fullscreen", "base_color", "Z"};

TEST(NearestName, IsOneWithFewOtherLetters) {
    EXPECT_EQ(nearestName("volume", names), "volumes") << "left out";
    EXPECT_EQ(nearestName("tilles", names), "tiles") << "added";
    EXPECT_EQ(nearestName("tales", names), "tiles") << "replaced";
    EXPECT_EQ(nearestName("tielscreen", names), "fullscreen") << "three of ten";
    EXPECT_EQ(nearestName("itles", names), "tiles") << "swapped, which counts as one";
    EXPECT_EQ(nearestName("BASE_COLOUR", names), "base_color") << "case, and one letter";
}

TEST(NearestName, IsNoneOfOthers) {
    EXPECT_EQ(nearestName("magic", names), std::nullopt);
    EXPECT_EQ(nearestName("tails", names), std::nullopt) << "two of five";
    EXPECT_EQ(nearestName("", names), std::nullopt);
    EXPECT_EQ(nearestName("depth", names), std::nullopt);
    EXPECT_EQ(nearestName(std::string(1'000'000, 'z'), names), std::nullopt);
    EXPECT_EQ(nearestName("tiles", {}), std::nullopt);
}

TEST(NearestName, MayBeBegunOnly) {
    EXPECT_EQ(nearestName("full", names), "fullscreen");
    EXPECT_EQ(nearestName("base", names), "base_color");
    EXPECT_EQ(nearestName("fu", names), std::nullopt) << "too short";
}

TEST(NearestName, EndsAnError) {
    EXPECT_EQ(didYouMean("tilse", names), " (did you mean tiles?)");
    EXPECT_EQ(didYouMean("magic", names), "");
}

}  // namespace
}  // namespace candela
