#include "scene/environment/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

constexpr int steps = 10000;

TEST(PortableMath, IsThatOfTheStandardLibrary) {
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double angle = std::numbers::pi * (2.0 * share - 1.0);
        EXPECT_NEAR(portableSin(angle), std::sin(angle), 1e-15);
        EXPECT_NEAR(portableCos(angle), std::cos(angle), 1e-15);
        const double cosine = 2.0 * share - 1.0;
        // Its derivative has no bound at the ends, where the last bit of the cosine is as much.
        EXPECT_NEAR(portableAcos(cosine), std::acos(cosine), 1e-15 * (1.0 + std::acos(cosine)));
        const double exponent = 700.0 * cosine;
        // A relative error of the exponent's own last bit.
        EXPECT_NEAR(portableExp(exponent) / std::exp(exponent), 1.0, 2e-13);
    }
}

}  // namespace
}  // namespace candela
