#include "environment/picture_samples.h"
#include "validate/broken_rule.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

Scene sample() {
    Scene scene;
    scene.environment = pictureOf(4, 2, [](const glm::dvec3&) { return glm::vec3(1.0f); });
    return scene;
}

TEST(ValidateEnvironment, AcceptsWhatItsTypeSays) {
    Scene scene = sample();
    EXPECT_NO_THROW(validate(scene));
    scene.environment->intensity = 0.0f;
    scene.environment->occlusionDistance = 1.0f;
    setTexel(scene.environment->picture, 0, glm::vec4(1e20f, 0.0f, 0.0f, NAN));  // Alpha is not read.
    EXPECT_NO_THROW(validate(scene));
}

TEST(ValidateEnvironment, RefusesTheRest) {
    const char* radiance = "environment 'drawn': its radiance must be finite numbers, 0 or more";
    const char* size = "environment 'drawn': its picture's width and height must lie between 1 and 32768";
    expectMessages(sample(),
                   {
                       {"environment 'drawn': its picture's pixels must be 32-bit floats",
                        [](Scene& s) { s.environment->picture.format = PixelFormat::rgba8; }},
                       {size, [](Scene& s) { s.environment->picture.width = 0; }},
                       {size, [](Scene& s) { s.environment->picture.height = 32769; }},
                       {"environment 'drawn': holds 128 bytes of pixels, but its size requires 192",
                        [](Scene& s) { s.environment->picture.height = 3; }},
                       {radiance,
                        [](Scene& s) {
                            setTexel(s.environment->picture, 7, {0, 0, -1e-9f, 1});
                        }},
                       {radiance,
                        [](Scene& s) {
                            setTexel(s.environment->picture, 7, {NAN, 0, 0, 1});
                        }},
                       {radiance,
                        [](Scene& s) {
                            setTexel(s.environment->picture, 7, {0, INFINITY, 0, 1});
                        }},
                       {"environment 'drawn': its intensity times its radiance must be at most 1e20",
                        [](Scene& s) {
                            setTexel(s.environment->picture, 7, {0, 1e19f, 0, 1});
                            s.environment->intensity = 11.0f;
                        }},
                       {"environment 'drawn': its intensity is -1, but 0 or more was expected",
                        [](Scene& s) { s.environment->intensity = -1.0f; }},
                       {"environment 'drawn': its rotation must be a quaternion of unit length",
                        [](Scene& s) { s.environment->rotation = glm::quat(0.5f, 0.0f, 0.0f, 0.0f); }},
                       {"environment 'drawn': its occlusion distance is 0, but a number over 0 was expected",
                        [](Scene& s) { s.environment->occlusionDistance = 0.0f; }},
                   });
}

}  // namespace
}  // namespace candela
