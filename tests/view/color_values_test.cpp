#include "panels/color_values.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace {

/// CIE XYZ from linear Rec.709 (IEC 61966-2-1), one column a channel.
constexpr glm::dmat3 xyzFromRec709{0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722, 0.9505};

glm::dvec2 chromaticityOf(const glm::vec3& color) {
    const glm::dvec3 xyz = xyzFromRec709 * glm::dvec3(color);
    return glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z);
}

TEST(ColorTemperature, LiesOnThePlanckianLocus) {
    // x and y of black bodies: Planck's law for the CIE 1931 observer.
    struct Body {
        float kelvin;
        double x, y;
    };
    constexpr std::array bodies{Body{2000.0f, 0.5267, 0.4133},  Body{3000.0f, 0.4369, 0.4041},
                                Body{4000.0f, 0.3805, 0.3768},  Body{6500.0f, 0.3135, 0.3237},
                                Body{10000.0f, 0.2807, 0.2884}, Body{20000.0f, 0.2565, 0.2577}};
    for (const Body& body : bodies) {
        const glm::dvec2 xy = chromaticityOf(colorOfTemperature(body.kelvin));
        // The spline is within 0.001 of the locus, and the two matrices of four digits within 0.001 of being
        // inverse to each other.
        EXPECT_NEAR(xy.x, body.x, 0.002) << body.kelvin;
        EXPECT_NEAR(xy.y, body.y, 0.002) << body.kelvin;
    }
}

TEST(ColorTemperature, IsNormalisedAndNotNegative) {
    for (float kelvin = minTemperature; kelvin <= maxTemperature; kelvin += 53.0f) {
        const glm::vec3 color = colorOfTemperature(kelvin);
        EXPECT_EQ(std::max({color.r, color.g, color.b}), 1.0f) << kelvin;
        EXPECT_GE(std::min({color.r, color.g, color.b}), 0.0f) << kelvin;
    }
}

TEST(ColorTemperature, GoesFromRedToBlue) {
    EXPECT_EQ(colorOfTemperature(2000.0f).r, 1.0f);
    EXPECT_EQ(colorOfTemperature(15000.0f).b, 1.0f);
    EXPECT_LT(colorOfTemperature(2000.0f).b, 0.1f);
    EXPECT_LT(colorOfTemperature(15000.0f).r, 0.8f);
}

TEST(ColorTemperature, IsContinuousAtTheKnotsOfTheSpline) {
    for (const float knot : {2222.0f, 4000.0f}) {
        const glm::vec3 before = colorOfTemperature(knot - 0.5f), after = colorOfTemperature(knot + 0.5f);
        // A kelvin changes a channel by less than 0.0005 here; the spline's coefficients have as many digits.
        for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(before[channel], after[channel], 0.002f);
    }
}

TEST(ColorTemperature, ClampsTemperaturesToItsRange) {
    EXPECT_EQ(colorOfTemperature(1.0f), colorOfTemperature(minTemperature));
    EXPECT_EQ(colorOfTemperature(1.0e9f), colorOfTemperature(maxTemperature));
}

TEST(NearestTemperature, FindsTheTemperatureOfAColour) {
    for (const float kelvin : {1700.0f, 2222.0f, 2700.0f, 4000.0f, 5600.0f, 6500.0f, 9300.0f, 24000.0f}) {
        // At 24000 K single precision tells temperatures apart by about 3 K: 1e-7 over the slope of 3e-8 a
        // kelvin. Half a percent is not visible.
        EXPECT_NEAR(nearestTemperature(colorOfTemperature(kelvin)), kelvin, 0.005f * kelvin);
        EXPECT_NEAR(nearestTemperature(30.0f * colorOfTemperature(kelvin)), kelvin, 0.005f * kelvin);
    }
}

TEST(NearestTemperature, AcceptsColoursThatNoBlackBodyHas) {
    EXPECT_NEAR(nearestTemperature({1.0f, 0.0f, 0.0f}), minTemperature, 1.0f);
    EXPECT_NEAR(nearestTemperature({0.0f, 0.0f, 1.0f}), maxTemperature, 1.0f);
}

}  // namespace
