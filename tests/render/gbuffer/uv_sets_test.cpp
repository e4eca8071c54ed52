// Sets of texture coordinates from 2 on: pictures equal those of the same coordinates in set 0, bit for bit.

#include "scene/model/uv_sets.h"
#include "scene/model/material_textures.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <glm/gtc/matrix_transform.hpp>

#include <optional>
#include <vector>

namespace candela::test {
namespace {

constexpr int width = 64, height = 48;
constexpr std::uint32_t lastSet = maxUvSets - 1;

/// Which set the textures read.
struct Reads {
    std::uint32_t set = 0;
    std::optional<std::size_t> texture{};  ///< Only this one of `materialTextures`, the others 0; none: all.

    std::uint32_t of(std::size_t index) const { return !texture || *texture == index ? set : 0; }
};

/// Gives the mesh, whose coordinates are set 0, all sets: `set` has the same coordinates, others false ones.
void addSets(Mesh& mesh, std::uint32_t set, bool keepsFirst) {
    const std::vector<glm::vec2> real = mesh.uv0;
    const auto falseUvs = [&](float seed) {
        std::vector<glm::vec2> uvs;
        for (const glm::vec2& uv : real) uvs.emplace_back(0.7f * uv.y + seed, 1.3f * uv.x - 2.0f * seed);
        return uvs;
    };
    if (!keepsFirst) mesh.uv0 = falseUvs(0.11f);
    mesh.uv1 = falseUvs(0.37f);
    for (std::uint32_t i = basicUvSets; i < maxUvSets; ++i)
        mesh.furtherUvs.push_back(i == set ? real : falseUvs(0.05f * static_cast<float>(i)));
}

/// A square of 16 × 16 cells: enough triangles for the triangle filter.
Mesh gridOf(Topology topology) {
    constexpr std::uint32_t cells = 16;
    Mesh mesh;
    for (std::uint32_t y = 0; y <= cells; ++y) {
        for (std::uint32_t x = 0; x <= cells; ++x) {
            const glm::vec2 uv = glm::vec2(x, y) / static_cast<float>(cells);
            mesh.positions.emplace_back(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y, 0.0f);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f, 1.0f);
            mesh.uv0.push_back(uv);
        }
    }
    for (std::uint32_t y = 0; y < cells; ++y) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t a = y * (cells + 1) + x, b = a + cells + 1;
            if (topology == Topology::triangles)
                mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
            if (topology == Topology::lines) mesh.indices.insert(mesh.indices.end(), {a, b + 1});
            if (topology == Topology::points) mesh.indices.push_back(a);
        }
    }
    mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), {}, topology}};
    return mesh;
}

/// With every texture that a material may have.
Material everyTexture(const Reads& reads) {
    Material material;
    material.metallic = 0.6f;
    material.roughness = 0.7f;
    material.emission = glm::vec3(0.1f);
    material.alphaCutoff = 0.4f;
    material.doubleSided = true;
    material.specular.factor = 0.9f;
    material.clearcoat.factor = 0.8f;
    material.clearcoat.roughness = 0.5f;
    material.sheen = {glm::vec3(0.3f), 0.6f, {}, {}};
    material.anisotropy.strength = 0.8f;
    material.iridescence.factor = 0.7f;
    material.transmission.factor = 0.4f;
    material.volume.thickness = 0.2f;
    material.diffuseTransmission.factor = 0.3f;
    for (std::size_t i = 0; i < materialTextures().size(); ++i) {
        Texture texture;
        texture.uvSet = reads.of(i);
        texture.image = static_cast<std::uint32_t>(i % 2);
        texture.rotation = 0.3f;
        texture.scale = {1.5f, 0.8f};
        const_cast<std::optional<Texture>&>(materialTextures()[i].of(material)) = texture;
    }
    return material;
}

struct Look {
    Topology topology = Topology::triangles;
    AlphaMode alphaMode = AlphaMode::opaque;
    bool isMorphed = false;
};

/// The grid with the further sets, a floor behind it that it casts shadows on, and an environment.
Scene sceneOf(const Look& look, const Reads& reads) {
    Scene scene;
    for (std::uint32_t seed : {0u, 1u})
        scene.images.push_back(makeImage(16, 16, [&](std::uint32_t x, std::uint32_t y) {
            const auto code = [&](std::uint32_t channel) {
                return static_cast<std::uint8_t>(255.0f * hashed(seed + 2 * channel, 16 * y + x));
            };
            return glm::u8vec4(code(1), code(2), 128 + code(3) / 2, code(4));
        }));
    place(scene, makeQuad(3.0f), Material{}, glm::translate(glm::mat4(1.0f), {0, 0, -1}));
    Material material = everyTexture(reads);
    material.alphaMode = look.alphaMode;
    if (look.alphaMode != AlphaMode::opaque) material.transmission.factor = 0.0f;
    Mesh mesh = gridOf(look.topology);
    if (look.isMorphed)
        mesh.morphTargets.push_back(
            {std::vector<glm::vec3>(mesh.positions.size(), {0.1f, 0.2f, 0.1f}), {}, {}});
    if (reads.set != 0) addSets(mesh, reads.set, reads.texture.has_value());
    const std::uint32_t node = place(scene, mesh, material, glm::rotate(glm::mat4(1.0f), 0.4f, {1, 0, 0}));
    if (look.isMorphed) scene.nodes[node].morphWeights = {0.7f};
    scene.environment =
        Environment{makeSky(32, [](const glm::dvec3& d) { return glm::vec3(float(d.y) + 1.1f); })};
    return scene;
}

class UvSetsTest : public DrawingTest {
  protected:
    /// What is compared: the picture, and the values of the surfaces and instances.
    struct Result {
        HdrImage picture;
        std::vector<Aov> aovs;
        std::vector<std::optional<std::uint32_t>> nodes;  ///< At some of the pixels.
    };
    static Result resultOf(const Scene& scene, const Form& form = cpuTiles, Shadows shadows = Shadows::off) {
        const std::vector<WorldLight> lights{pointLight({0.5f, 1, 2}, 8, glm::vec3(6.0f)),
                                             pointLight({-1, -0.5f, 1}, 8, {2, 4, 3})};
        FrameRequest request{width, height, lookAt({0.3f, 0.2f, 3}, {0, 0, 0}, 0.8f), BrdfModel::course,
                             form.technique};
        request.tileBackend = form.backend;
        request.shadows = shadows;
        GpuScene uploaded = upload(scene, lights);
        Result result{drawn(uploaded, request), {}, {}};
        result.aovs = lastFrame().aovs({"base_color", "N", "roughness", "metallic"});
        for (int x = 2; x < width; x += 9) {
            for (int y = 1; y < height; y += 9) {
                const std::optional<PixelProbe> probe = lastFrame().probe(x, y);
                result.nodes.push_back(probe ? std::optional(probe->node) : std::nullopt);
            }
        }
        return result;
    }
    static void expectEqual(const Result& actual, const Result& expected) {
        EXPECT_TRUE(actual.picture.rgba == expected.picture.rgba);
        EXPECT_EQ(actual.nodes, expected.nodes);
        for (std::size_t i = 0; i < expected.aovs.size(); ++i)
            EXPECT_TRUE(actual.aovs[i].values == expected.aovs[i].values) << expected.aovs[i].name;
    }
};

TEST_F(UvSetsTest, EachTextureReadsItsOwn) {
    const Result expected = resultOf(sceneOf({}, {}));
    for (std::size_t i = 0; i < materialTextures().size(); ++i) {
        SCOPED_TRACE(materialTextures()[i].name);
        EXPECT_NE(resultOf(sceneOf({}, {1, i})).picture.rgba, expected.picture.rgba)
            << "set 1 is a false one";
        expectEqual(resultOf(sceneOf({}, {i % 2 == 0 ? 2u : lastSet, i})), expected);
        if (HasFailure()) return;
    }
}

TEST_F(UvSetsTest, AllTexturesReadOne) {
    const Result expected = resultOf(sceneOf({}, {}));
    EXPECT_NE(resultOf(sceneOf({}, {1})).picture.rgba, expected.picture.rgba) << "set 1 is a false one";
    for (const std::uint32_t set : {3u, 4u, 9u, 16u}) {
        SCOPED_TRACE(set);
        expectEqual(resultOf(sceneOf({}, {set})), expected);
    }
}

TEST_F(UvSetsTest, OfMasksLayersAndShadows) {
    const Shadows shadows = hasShadows() ? Shadows::on : Shadows::off;
    const auto expectSame = [&](AlphaMode mode, const Form& form) {
        SCOPED_TRACE(form.name);
        const Look look{.alphaMode = mode};
        expectEqual(resultOf(sceneOf(look, {5}), form, shadows), resultOf(sceneOf(look, {}), form, shadows));
    };
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend})
        expectSame(mode, cpuTiles);
    for (const Form& form : shaderForms) expectSame(AlphaMode::mask, form);
}

TEST_F(UvSetsTest, OfLinesPointsAndMovedVertices) {
    for (const Look& look : {Look{Topology::lines, AlphaMode::mask}, Look{Topology::points, AlphaMode::mask},
                             Look{Topology::lines, AlphaMode::opaque}, Look{.isMorphed = true},
                             Look{Topology::triangles, AlphaMode::mask, true}})
        expectEqual(resultOf(sceneOf(look, {lastSet})), resultOf(sceneOf(look, {})));
}

// A material may come to read them, and a mesh without them stands beside one that has them.
TEST_F(UvSetsTest, OfAMaterialThatChanges) {
    Scene scene = sceneOf({}, {3, std::size_t{0}});
    GpuScene changing = upload(scene);
    Material plain = scene.materials.back();
    const FrameRequest request{width, height, lookAt({0.3f, 0.2f, 3}, {0, 0, 0}, 0.8f)};
    const HdrImage before = drawn(changing, request);
    plain.baseColorTexture->uvSet = 1;
    changing.setMaterial(1, plain);
    EXPECT_NE(drawn(changing, request).rgba, before.rgba);
    changing.setMaterial(1, scene.materials.back());
    EXPECT_EQ(drawn(changing, request).rgba, before.rgba);
    plain.baseColorTexture->uvSet = 3;
    expectRefused([&] { changing.setMaterial(0, plain); },
                  "a texture reads texture coordinates 3, which a surface of this material does not have");
}

}  // namespace
}  // namespace candela::test
