#include <candela/color.h>

#include "base/primaries.h"
#include "temporary_config.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela {
namespace {

using test::configText;
using test::messageOf;
using test::TemporaryConfig;

ColorConfig loaded(const std::string& text) {
    return ColorConfig::load(TemporaryConfig(text).path());
}

void expectMatrix(const glm::dmat3& actual, const glm::dmat3& expected, double tolerance) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            EXPECT_NEAR(actual[column][row], expected[column][row], tolerance)
                << "row " << row << " column " << column;
}

void expectSame(const Chromaticities& actual, const Chromaticities& expected, double tolerance) {
    const auto expectNear = [&](const glm::dvec2& a, const glm::dvec2& b, const char* what) {
        EXPECT_NEAR(a.x, b.x, tolerance) << what;
        EXPECT_NEAR(a.y, b.y, tolerance) << what;
    };
    expectNear(actual.red, expected.red, "red");
    expectNear(actual.green, expected.green, "green");
    expectNear(actual.blue, expected.blue, "blue");
    expectNear(actual.white, expected.white, "white");
}

Chromaticities known(const std::string& name) {
    for (const KnownPrimaries& space : knownPrimaries())
        if (space.name == name) return space.chromaticities;
    ADD_FAILURE() << name;
    return {};
}

// The matrices as published (rows), Bradford-adapted: AP1 and AP0 from linear Rec.709 as in ACES's own
// transforms.
const glm::dmat3 ap1FromRec709 = glm::transpose(glm::dmat3{
    {0.6130973, 0.3395229, 0.0473793}, {0.0701942, 0.9163556, 0.0134526}, {0.0206156, 0.1095698, 0.8698151}});

constexpr const char* acesSpaces = R"(  - !<ColorSpace> {name: ACES2065-1, isdata: false}
  - !<ColorSpace>
    name: ACEScg
    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
)";

// Six digits of the published matrices, and the probe's single precision.
constexpr double sixDigits = 3e-6;

TEST(WorkingSpace, primariesMatchClosedForms) {
    expectMatrix(rgbFromRgb(known("AP1"), known("Rec.709")), ap1FromRec709, sixDigits);
    const glm::dmat3 xyzFromRec709 = glm::transpose(glm::dmat3{{0.4123908, 0.3575843, 0.1804808},
                                                               {0.2126390, 0.7151687, 0.0721923},
                                                               {0.0193308, 0.1191948, 0.9505322}});
    expectMatrix(xyzFromRgb(known("Rec.709")), xyzFromRec709, 1e-6);
}

TEST(WorkingSpace, acesConfigShadesInAp1) {
    const ColorConfig config =
        loaded(configText("  aces_interchange: ACES2065-1\n  scene_linear: ACEScg\n", acesSpaces));
    EXPECT_EQ(config.workingSpace(), "ACEScg");
    expectMatrix(config.workingFromRec709(), ap1FromRec709, sixDigits);
    expectSame(config.chromaticities(), known("AP1"), 0.0);
    EXPECT_TRUE(config.notes().empty());
    const glm::dvec3 white = config.workingFromRec709() * glm::dvec3(1.0);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1.0, 1e-6) << "white stays white";
}

TEST(WorkingSpace, aces2065IsSupported) {
    const ColorConfig config =
        loaded(configText("  aces_interchange: ACES2065-1\n  scene_linear: ACES2065-1\n", acesSpaces));
    expectMatrix(config.workingFromRec709(), rgbFromRgb(known("AP0"), known("Rec.709")), 1e-6);
    expectSame(config.chromaticities(), known("AP0"), 0.0);
}

TEST(WorkingSpace, displayInterchangeRoleIsUsedToo) {
    const std::string spaces = R"(  - !<ColorSpace>
    name: linear wide
    to_scene_reference: !<MatrixTransform>
      matrix: [0.6369580, 0.1446169, 0.1688810, 0,
               0.2627002, 0.6779981, 0.0593017, 0,
               0, 0.0280727, 1.0609851, 0,
               0, 0, 0, 1]
)";
    const std::string views =
        "view_transforms:\n"
        "  - !<ViewTransform> {name: plain, from_scene_reference: !<MatrixTransform> {}}\n"
        "display_colorspaces:\n  - !<ColorSpace> {name: XYZ}\n";
    const ColorConfig config =
        loaded(configText("  cie_xyz_d65_interchange: XYZ\n  scene_linear: linear wide\n", spaces, views));
    expectSame(config.chromaticities(), known("Rec.2020"), 0.0);
    expectMatrix(config.workingFromRec709(), rgbFromRgb(known("Rec.2020"), known("Rec.709")), sixDigits);
}

TEST(WorkingSpace, toneCurveOfTheDefaultViewIsIgnored) {
    const std::string views =
        "view_transforms:\n  - !<ViewTransform>\n    name: curve\n"
        "    from_scene_reference: !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}\n"
        "display_colorspaces:\n  - !<ColorSpace> {name: XYZ}\n";
    const ColorConfig config = loaded(configText("  cie_xyz_d65_interchange: XYZ\n  scene_linear: lin\n",
                                                 "  - !<ColorSpace> {name: lin}\n", views));
    EXPECT_EQ(config.workingFromRec709(), glm::dmat3(1.0));
    EXPECT_EQ(config.notes().size(), 1u);
}

TEST(WorkingSpace, wellKnownNameOrAliasOfRec709) {
    const std::string spaces = R"(  - !<ColorSpace> {name: reference}
  - !<ColorSpace>
    name: flat
    aliases: [lin_rec709_srgb]
    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
)";
    const ColorConfig config = loaded(configText("  scene_linear: reference\n", spaces));
    expectMatrix(config.workingFromRec709(), glm::dmat3(2.0), 1e-6);
    EXPECT_TRUE(config.notes().empty());
    // Scale does not change the primaries.
    expectSame(config.chromaticities(), known("Rec.709"), 1e-6);
}

TEST(WorkingSpace, unknownPrimariesAreComputed) {
    // Rec.709's primaries, each mixed with a tenth of the others: no known space has these.
    const std::string spaces = R"(  - !<ColorSpace> {name: Linear Rec.709}
  - !<ColorSpace>
    name: mixed
    to_scene_reference: !<MatrixTransform>
      matrix: [0.8, 0.1, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.1, 0.1, 0.8, 0, 0, 0, 0, 1]
)";
    const Chromaticities found = loaded(configText("  scene_linear: mixed\n", spaces)).chromaticities();
    const glm::dmat3 toXyz = xyzFromRgb(known("Rec.709"));
    const glm::dvec2 red = chromaticity(toXyz * glm::dvec3(0.8, 0.1, 0.1));
    EXPECT_NEAR(found.red.x, red.x, 1e-6);
    EXPECT_NEAR(found.red.y, red.y, 1e-6);
    EXPECT_NEAR(found.white.x, 0.3127, 1e-6);
    EXPECT_NEAR(found.white.y, 0.3290, 1e-6);
}

TEST(WorkingSpace, assumesRec709WithANoteWhenNothingIsKnown) {
    const ColorConfig config = loaded(configText("  scene_linear: lin\n", "  - !<ColorSpace> {name: lin}\n"));
    EXPECT_EQ(config.workingFromRec709(), glm::dmat3(1.0));
    expectSame(config.chromaticities(), known("Rec.709"), 0.0);
    ASSERT_EQ(config.notes().size(), 1u);
    EXPECT_NE(config.notes()[0].find("'lin'"), std::string::npos) << config.notes()[0];
    EXPECT_NE(config.notes()[0].find("Rec.709"), std::string::npos) << config.notes()[0];
}

TEST(WorkingSpace, missingRoleIsNamedWithTheExistingOnes) {
    const std::string message =
        messageOf([] { loaded(configText("  rendering: lin\n", "  - !<ColorSpace> {name: lin}\n")); });
    EXPECT_NE(message.find("scene_linear"), std::string::npos) << message;
    EXPECT_NE(message.find("rendering"), std::string::npos) << "lists the existing roles: " << message;
}

TEST(WorkingSpace, aNonlinearSpaceIsRefused) {
    const std::string spaces = R"(  - !<ColorSpace> {name: ACES2065-1}
  - !<ColorSpace>
    name: video
    from_scene_reference: !<ExponentTransform> {value: [0.45, 0.45, 0.45, 1]}
)";
    const std::string message = messageOf(
        [&] { loaded(configText("  aces_interchange: ACES2065-1\n  scene_linear: video\n", spaces)); });
    EXPECT_NE(message.find("'video', which is not linear"), std::string::npos) << message;
}

TEST(WorkingSpace, aSpaceWithAnOffsetIsRefused) {
    const std::string spaces = R"(  - !<ColorSpace> {name: ACES2065-1}
  - !<ColorSpace>
    name: lifted
    from_scene_reference: !<MatrixTransform> {offset: [0.1, 0.1, 0.1, 0]}
)";
    EXPECT_NE(messageOf([&] {
                  loaded(configText("  aces_interchange: ACES2065-1\n  scene_linear: lifted\n", spaces));
              }).find("not linear"),
              std::string::npos);
}

}  // namespace
}  // namespace candela
