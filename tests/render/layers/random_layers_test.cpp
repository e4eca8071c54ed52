// Random scenes of surfaces that blend, mask and are opaque: pixels against the stack of surfaces that each
// of them shows alone, for pictures of many sizes, both projections and surfaces that cross the near plane.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace candela::test {
namespace {

struct Size {
    int width, height;
};
constexpr std::array sizes{Size{1, 1},   Size{2, 3},   Size{7, 5},   Size{63, 65},
                           Size{129, 3}, Size{64, 64}, Size{31, 97}, Size{130, 70}};

/// A number between `low` and `high`.
float between(std::uint32_t seed, std::uint32_t& index, float low, float high) {
    return low + (high - low) * hashed(seed, index++);
}

/// A point or a line, some pixels wide.
Mesh makeElement(Topology topology) {
    Mesh mesh;
    mesh.positions = {{-0.8f, 0, 0}, {0.8f, 0.3f, 0}};
    mesh.normals.assign(2, {0, 0, 1});
    mesh.uv0.assign(2, {0.05f, 0.05f});
    mesh.indices = {0, 1};
    if (topology == Topology::points) mesh.indices.pop_back();
    mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), 0, topology}};
    return mesh;
}

/// An unlit scene, whose surfaces have one colour each.
Scene randomScene(std::uint32_t seed) {
    Scene scene;
    std::uint32_t i = 0;
    const auto number = [&](float low, float high) { return between(seed, i, low, high); };
    const auto texture = makeImage(8, 8, [&](std::uint32_t x, std::uint32_t y) {
        return glm::u8vec4(255, 255, 255, (x + y) % 2 == 0 ? 255 : 40);
    });
    scene.images.push_back(texture);
    const int count = 3 + int(number(0.0f, 11.0f));
    for (int k = 0; k < count; ++k) {
        Material material;
        material.unlit = true;
        material.baseColor = {number(0, 1), number(0, 1), number(0, 1), number(0, 1)};
        const float kind = number(0, 1);
        if (kind < 0.7f) {
            material.alphaMode = AlphaMode::blend;
        } else {
            material.baseColor.a = 1.0f;
        }
        if (kind >= 0.8f) {
            material.alphaMode = AlphaMode::mask;
            material.baseColorTexture = Texture{};
            material.baseColorTexture->magFilter = Filter::nearest;
            material.baseColorTexture->minFilter = Filter::nearest;
        }
        const bool isSphere = number(0, 1) < 0.3f;
        // Spheres are closed: their backs would be layers of their own.
        material.doubleSided = !isSphere;
        glm::mat4 transform = glm::translate(
            glm::mat4(1.0f), glm::vec3(number(-1.5f, 1.5f), number(-1.0f, 1.0f), number(-5.0f, -0.3f)));
        transform = glm::rotate(transform, number(0.0f, 6.3f),
                                glm::normalize(glm::vec3(number(-1, 1), number(-1, 1), 1.1f)));
        Mesh mesh = isSphere ? makeSphere(number(0.2f, 1.0f)) : makeQuad(number(0.3f, 2.5f));
        const float element = number(0, 1);
        if (element < 0.15f) mesh = makeElement(element < 0.07f ? Topology::points : Topology::lines);
        place(scene, std::move(mesh), material, transform);
    }
    return scene;
}

/// The same surfaces, lit, of which some transmit, with and without volumes, roughness and masks.
Scene randomLitScene(std::uint32_t seed) {
    Scene scene = randomScene(seed);
    std::uint32_t i = 500;
    const auto number = [&](float low, float high) { return between(seed, i, low, high); };
    for (Material& material : scene.materials) {
        material.unlit = number(0, 1) < 0.1f;
        material.roughness = number(0, 1) < 0.5f ? 0.0f : number(0.05f, 0.9f);
        material.metallic = number(0, 1) < 0.8f ? 0.0f : 0.5f;
        if (number(0, 1) < 0.2f) material.emission = {0.1f, 0.3f, 0.2f};
        if (number(0, 1) < 0.5f) continue;
        material.transmission.factor = number(0.2f, 1.0f);
        if (number(0, 1) < 0.5f) continue;
        material.volume.thickness = number(0.0f, 2.0f);
        material.volume.dispersion = number(0, 1) < 0.3f ? 3.0f : 0.0f;
        material.volume.attenuationDistance = number(0.2f, 3.0f);
        material.volume.attenuationColor = {0.6f, 0.8f, 0.9f};
    }
    scene.environment = Environment{
        .picture = makeSky(32, [](const glm::dvec3& d) { return glm::vec3(0.3, 0.4, 0.5 + 0.3 * d.y); }),
        .isBackground = seed % 2 == 0};
    return scene;
}

std::vector<WorldLight> someLights() {
    return {pointLight({1, 2, 0}, 12.0f, glm::vec3(9, 8, 7)),
            directionalLight(glm::normalize(glm::vec3(0.2f, -0.3f, -1)), glm::vec3(1.5f))};
}

CameraView viewOf(std::uint32_t seed) {
    CameraView view = lookAt({0, 0, 0}, {0.1f, -0.05f, -1}, 0.9f);
    view.nearPlane = 0.7f;
    if (seed % 3 == 0) view.orthographicHeight = 3.0f;
    return view;
}

/// What the surface of a node alone shows: its depth along the view axis, infinite where it has no fragment.
struct Alone {
    std::vector<float> z;
    glm::vec4 color;
    bool blends = false;
};

class RandomLayersTest : public DrawingTest {
  protected:
    static FrameSettings settings(std::uint32_t seed, const Form& form) {
        const Size size = sizes[seed % sizes.size()];
        FrameRequest request{size.width, size.height, viewOf(seed)};
        request.technique = form.technique;
        request.tileBackend = form.backend;
        request.layers = 16;
        FrameSettings settings = request.settings();
        settings.pointSize = 9.0f;
        settings.lineWidth = 4.0f;
        return settings;
    }

    static std::vector<Alone> surfacesAlone(const Scene& scene, std::uint32_t seed) {
        Scene solid = scene;
        for (Material& material : solid.materials) {
            if (material.alphaMode != AlphaMode::blend) continue;
            material.baseColor.a = 1.0f;
        }
        GpuScene uploaded = upload(solid);
        std::vector<Alone> result;
        for (std::uint32_t shown = 0; shown < scene.nodes.size(); ++shown) {
            for (std::uint32_t node = 0; node < scene.nodes.size(); ++node)
                uploaded.setVisibility(
                    node, node == shown ? GpuScene::Visibility::shown : GpuScene::Visibility::hidden);
            const Frame frame = renderer().render(uploaded, viewOf(seed), settings(seed, cpuTiles));
            Alone alone{frame.aovs({"Z"})[0].values[0], scene.materials[shown].baseColor,
                        scene.materials[shown].alphaMode == AlphaMode::blend};
            if (!alone.blends) alone.color.a = 1.0f;
            const HdrImage picture = frame.radiance();
            for (std::size_t i = 0; i < alone.z.size(); ++i)
                if (picture.rgba[4 * i + 3] == 0.0f) alone.z[i] = std::numeric_limits<float>::infinity();
            result.push_back(std::move(alone));
        }
        return result;
    }
};

TEST_F(RandomLayersTest, picturesAreTheStacksOfTheirSurfaces) {
    for (std::uint32_t seed = 1; seed <= 48; ++seed) {
        const Scene scene = randomScene(seed);
        const std::vector<Alone> surfaces = surfacesAlone(scene, seed);
        GpuScene uploaded = upload(scene);
        for (const Form& form : forms) {
            const HdrImage picture =
                renderer().render(uploaded, viewOf(seed), settings(seed, form)).radiance();
            for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i) {
                std::vector<const Alone*> stack;
                for (const Alone& surface : surfaces)
                    if (std::isfinite(surface.z[i])) stack.push_back(&surface);
                std::ranges::sort(stack, std::ranges::greater{},
                                  [&](const Alone* surface) { return surface->z[i]; });
                // Where two are as near as depth rounds, either may be in front.
                const auto isNear = [&](const Alone* a, const Alone* b) {
                    return std::abs(a->z[i] - b->z[i]) < 1.0e-5f * b->z[i];
                };
                if (std::ranges::adjacent_find(stack, isNear) != stack.end()) continue;
                glm::dvec4 expected(0.0);
                for (const Alone* surface : stack) {
                    const double a = double(surface->color.a);
                    expected = glm::dvec4(a * glm::dvec3(surface->color), a) + (1.0 - a) * expected;
                }
                // Half a code of the coverage for each of up to 14 layers.
                for (std::size_t c = 0; c < 4; ++c)
                    ASSERT_NEAR(picture.rgba[4 * i + c], expected[glm::length_t(c)], 8.0 / 65535.0)
                        << "seed " << seed << ", " << form.name << ", pixel " << i << ", channel " << c;
            }
        }
    }
}

TEST_F(RandomLayersTest, picturesDoNotDependOnTheOrderOfNodes) {
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        Scene scene = randomScene(seed);
        GpuScene first = upload(scene);
        const std::vector<float> expected =
            renderer().render(first, viewOf(seed), settings(seed, cpuTiles)).radiance().rgba;
        std::ranges::reverse(scene.nodes);
        std::ranges::rotate(scene.nodes, scene.nodes.begin() + 1);
        GpuScene second = upload(scene);
        EXPECT_EQ(renderer().render(second, viewOf(seed), settings(seed, cpuTiles)).radiance().rgba, expected)
            << "seed " << seed;
    }
}

TEST_F(RandomLayersTest, litPicturesDoNotDependOnTheOrderOfNodesOrTheTechnique) {
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        Scene scene = randomLitScene(seed);
        FrameSettings lit = settings(seed, cpuTiles);
        // Shaders that trace rays are slow on software devices.
        if (lit.width * lit.height < 100) lit.shadows = Shadows::automatic;
        GpuScene first = upload(scene, someLights());
        const Frame frame = renderer().render(first, viewOf(seed), lit);
        const HdrImage expected = frame.radiance();
        ASSERT_TRUE(allFinite(expected)) << "seed " << seed;
        for (const Form& form : shaderForms) {
            lit.technique = form.technique;
            lit.tileBackend = form.backend;
            const HdrImage picture = renderer().render(first, viewOf(seed), lit).radiance();
            for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
                // What techniques round differently, which bright highlights of smooth surfaces magnify.
                ASSERT_NEAR(picture.rgba[i], expected.rgba[i], 2.0e-3f * (1.0f + expected.rgba[i]))
                    << "seed " << seed << ", " << form.name << ", pixel " << i / 4;
            }
        }
        lit.technique = Technique::tiles;
        lit.tileBackend = TileBackend::cpu;
        std::ranges::reverse(scene.nodes);
        std::ranges::rotate(scene.nodes, scene.nodes.begin() + 1);
        GpuScene second = upload(scene, someLights());
        EXPECT_EQ(renderer().render(second, viewOf(seed), lit).radiance().rgba, expected.rgba)
            << "seed " << seed;
    }
}

}  // namespace
}  // namespace candela::test
