#include "support/occluder_scenes.h"

#include "support/procedural_scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace candela::test {

Material doubleSided(float grey) {
    Material material;
    material.baseColor = {grey, grey, grey, 1.0f};
    material.doubleSided = true;
    return material;
}

glm::mat4 rotated(const glm::vec3& position, float degrees, const glm::vec3& axis) {
    return glm::rotate(glm::translate(glm::mat4(1.0f), position), glm::radians(degrees), axis);
}

glm::mat4 flatAt(const glm::vec3& position) {
    return rotated(position, -90.0f, {1, 0, 0});
}

Scene floorAndWall(const Material& material) {
    Scene scene = sceneOf(makeQuad(5.0f), material, flatAt({5, 0, 0}));
    place(scene, makeQuad(5.0f), material, rotated({0, 5, 0}, 90.0f, {0, 1, 0}));
    return scene;
}

double freeBesideAWall(double d, double distance) {
    const double a = std::min(d / distance, 1.0);
    return 1.0 - (std::acos(a) - a * std::sqrt(1.0 - a * a)) / std::numbers::pi;
}

Scene closedRoom(const Material& material) {
    Scene scene;
    for (int i = 0; i < 4; ++i)
        place(scene, makeQuad(1.0f), material,
              glm::translate(rotated({}, 90.0f * static_cast<float>(i), {0, 1, 0}), {0, 0, 1}));
    for (const float side : {-1.0f, 1.0f}) place(scene, makeQuad(1.0f), material, flatAt({0, side, 0}));
    return scene;
}

Scene cardsOnAFloor(const Material& material) {
    Scene scene = sceneOf(makeQuad(6.0f), material, flatAt({0, 0, 0}));
    for (std::uint32_t i = 0; i < 30; ++i) {
        const glm::vec3 position(4.0f * hashed(1, i) - 2.0f, 0.8f * hashed(2, i), 4.0f * hashed(3, i) - 2.0f);
        place(scene, makeQuad(0.2f + 0.4f * hashed(4, i)), material,
              rotated(position, 360.0f * hashed(5, i), hashedDirection(6, i)));
    }
    return scene;
}

}  // namespace candela::test
