#include "support/random_elements.h"

#include <candela/shapes.h>

#include <glm/gtc/matrix_transform.hpp>

namespace candela::test {

Mesh randomMesh(Random& random) {
    const float size = 0.2f + 0.001f * float(random() % 300);
    switch (random() % 4) {
        case 0:
            return sphereMesh(size, 8 + random() % 24, 5 + random() % 12);
        case 1:
            return boxMesh({size, 1.3f * size, 0.7f * size});
        case 2:
            return torusMesh(size, 0.3f * size, 12, 6);
        default:
            return coneMesh(size, 1.5f * size, 5 + random() % 8);
    }
}

glm::mat4 randomPlace(Random& random) {
    const glm::vec3 axis = glm::normalize(glm::vec3(random.unit() + 0.1f, random.unit(), random.unit()));
    const glm::vec3 place(3 * random.unit() - 1.5f, 2 * random.unit() - 0.5f, 3 * random.unit() - 1.5f);
    const glm::vec3 scale(random() % 5 == 0 ? -1.0f : 0.6f + 0.5f * random.unit());
    return glm::scale(glm::rotate(glm::translate(glm::mat4(1.0f), place), 6 * random.unit(), axis), scale);
}

Image randomImage(Random& random) {
    Image image{"noise", 8 + random() % 9, 8, PixelFormat::rgba8, {}};
    image.pixels.resize(image.width * image.height * 4u);
    for (std::byte& byte : image.pixels) byte = static_cast<std::byte>(random() % 256);
    return image;
}

Material randomMaterial(Random& random, std::optional<std::uint32_t> image) {
    Material material;
    material.baseColor = {random.unit(), random.unit(), random.unit(), 1.0f};
    material.roughness = 0.3f + 0.7f * random.unit();
    material.doubleSided = random() % 4 == 0;
    if (random() % 8 == 0) material.clearcoat.factor = 0.7f;
    if (random() % 8 == 0) material.emission = {0.2f, 0.1f, 0.0f};
    if (!image || random() % 2 == 0) return material;
    material.baseColorTexture = Texture{.image = *image};
    if (random() % 3 == 0) {
        material.alphaMode = AlphaMode::mask;
        material.alphaCutoff = 0.5f;
    }
    return material;
}

Light randomLight(Random& random, std::optional<std::uint32_t> node) {
    Light light;
    light.type = random() % 3 == 0 ? LightType::spot : LightType::point;
    light.intensity = 1.0f + 3.0f * random.unit();
    light.color = {random.unit(), 1.0f, random.unit()};
    light.position = {3 * random.unit() - 1.5f, 2.0f, 3 * random.unit() - 1.5f};
    light.direction = {0, -1, 0};
    if (random() % 2 == 0) light.range = 4.0f;
    light.castsShadow = random() % 4 != 0;
    light.node = node;
    return light;
}

}  // namespace candela::test
