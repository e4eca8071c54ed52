// Which surfaces pixels show: the AOVs of ids and motion, and `Frame::pick`.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <map>

namespace candela::test {
namespace {

constexpr int width = 90, height = 60;

glm::mat4 at(const glm::vec3& position) {
    return glm::translate(glm::mat4(1.0f), position);
}

FrameSettings frameSettings() {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    return settings;
}

/// A mesh of two materials and no material at its third submesh, a node that has no mesh, and a plain quad.
Scene described() {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[1].baseColor = {0.5f, 0.2f, 0.1f, 1.0f};
    scene.materials[2].alphaMode = AlphaMode::blend;
    scene.materials[2].baseColor.a = 0.6f;
    Mesh mesh;
    for (int i = 0; i < 3; ++i) {
        const Mesh quad = makeQuad(0.4f);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3& p : quad.positions)
            mesh.positions.push_back(p + glm::vec3(float(i) - 1.0f, 0, 0));
        mesh.normals.insert(mesh.normals.end(), quad.normals.begin(), quad.normals.end());
        for (const std::uint32_t index : quad.indices) mesh.indices.push_back(first + index);
    }
    mesh.submeshes = {{0, 6, 1u}, {6, 6, 2u}, {12, 6, std::nullopt}};
    scene.meshes = {mesh, makeQuad(3.0f)};
    scene.meshes[1].submeshes = {{0, 6, 0u}};
    scene.nodes.resize(4);
    scene.nodes[1].mesh = 0;
    scene.nodes[3].mesh = 1;
    scene.nodes[3].transform = at({0, 0, -2});
    return scene;
}

CameraView view() {
    return lookAt({0, 0, 4}, {0, 0, 0}, 0.7f);
}

class IdsTest : public DrawingTest {
  protected:
    AovReader ids(const Frame& frame) {
        return {frame.aovs({"Z", "P", "node_id", "material_id", "instance_id"}), width};
    }
};

TEST_F(IdsTest, areThoseOfTheSceneAtEachPixel) {
    GpuScene scene = upload(described());
    const Frame frame = renderer().render(scene, view(), frameSettings());
    const AovReader reader = ids(frame);
    std::map<float, int> seen;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float z = reader.scalar("Z", x, y);
            float node = 0, material = 0, instance = 0;
            if (z > 5.0f) {
                node = 4, material = 1, instance = 2;
            } else if (z > 0.0f) {
                const float place = reader.vector("P", x, y).x;
                node = 2, instance = 1;
                material = place < -0.5f ? 2.0f : place < 0.5f ? 3.0f : 0.0f;
            }
            ASSERT_EQ(reader.scalar("node_id", x, y), node) << x << ", " << y;
            ASSERT_EQ(reader.scalar("material_id", x, y), material);
            ASSERT_EQ(reader.scalar("instance_id", x, y), instance);
            ++seen[10 * node + material];
        }
    }
    for (const float kind : {20.0f, 22.0f, 23.0f, 41.0f}) EXPECT_GT(seen[kind], 50) << kind;
}

TEST_F(IdsTest, cagesFollowTheMeshesInTheNumbersOfInstances) {
    Scene described;
    const std::uint32_t cage = placeCage(described, makeCubeCage(0.5f), Material{}, at({-1, 0, 0}));
    const std::uint32_t mesh = place(described, makeQuad(0.5f), Material{}, at({1, 0, 0}));
    GpuScene scene = upload(described);
    const Frame frame = renderer().render(scene, view(), frameSettings());
    const AovReader reader = ids(frame);
    int cages = 0, meshes = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float instance = reader.scalar("instance_id", x, y), node = reader.scalar("node_id", x, y);
            const float expected = instance == 2.0f   ? float(cage + 1)
                                   : instance == 1.0f ? float(mesh + 1)
                                                      : 0.0f;
            ASSERT_EQ(node, expected);
            cages += instance == 2.0f;
            meshes += instance == 1.0f;
        }
    }
    EXPECT_GT(cages, 50);
    EXPECT_GT(meshes, 50);
}

TEST_F(IdsTest, pickFindsTheSurfacesOfARectangleAndOfAPoint) {
    GpuScene scene = upload(described());
    const Frame frame = renderer().render(scene, view(), frameSettings());
    const AovReader reader = ids(frame);
    const PictureRectangle rectangle{11, 7, 60, 44};
    std::map<std::pair<float, float>, std::pair<std::uint64_t, float>> expected;
    for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y) {
        for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x) {
            if (reader.scalar("Z", x, y) == 0.0f) continue;
            auto& [pixels, z] =
                expected[{reader.scalar("node_id", x, y), reader.scalar("material_id", x, y)}];
            z = pixels == 0 ? reader.scalar("Z", x, y) : std::min(z, reader.scalar("Z", x, y));
            ++pixels;
        }
    }
    const std::vector<PickedSurface> picked = frame.pick(rectangle);
    ASSERT_EQ(picked.size(), expected.size());
    std::uint64_t most = picked[0].pixels;
    for (const PickedSurface& surface : picked) {
        const float material = surface.material ? float(*surface.material + 1) : 0.0f;
        const auto& [pixels, z] = expected.at({float(surface.node + 1), material});
        EXPECT_EQ(surface.pixels, pixels);
        EXPECT_EQ(surface.z, z);
        EXPECT_LE(surface.pixels, most);
        most = surface.pixels;
    }
    const auto one = frame.pick({width / 2, height / 2});
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].node, 1u);
    EXPECT_EQ(one[0].material, 2u) << "the middle one, which is transparent";
    for (const PictureRectangle& bad :
         {PictureRectangle{0, 0, 0, 1}, PictureRectangle{-1, 0, 2, 2}, PictureRectangle{0, 0, width + 1, 1},
          PictureRectangle{1, 1, width, 1}, PictureRectangle{0, height, 1, 1}})
        expectRefused([&] { frame.pick(bad); }, "is picked of a picture");
}

/// Where a world position is in the picture, pixels, y down, by the projection matrix in double precision.
glm::dvec2 pixelAt(const CameraView& seen, const glm::dvec3& position) {
    const glm::dmat4 clip = glm::dmat4(projection(seen, float(width) / height));
    const glm::dvec4 p = clip * glm::inverse(glm::dmat4(seen.worldFromCamera)) * glm::dvec4(position, 1.0);
    return {(0.5 + 0.5 * p.x / p.w) * width, (0.5 - 0.5 * p.y / p.w) * height};
}

TEST_F(IdsTest, motionIsTheWayOfEachSurfaceInThePicture) {
    for (const bool orthographic : {false, true}) {
        GpuScene scene = upload(described());
        CameraView before = lookAt({0.3f, -0.2f, 4.4f}, {0, 0.1f, 0}, 0.7f), now = view();
        now.shift = before.shift = {0.05f, -0.1f};
        if (orthographic) {
            now.orthographicHeight = before.orthographicHeight = 2.5f;
            now.farPlane = before.farPlane = 20.0f;
        }
        const glm::mat4 then = at({0.1f, 0.2f, -0.3f});
        const glm::mat4 here = glm::rotate(at({-0.1f, 0.05f, 0.1f}), 0.2f, glm::vec3(0, 0.6f, 0.8f));
        scene.setTransform(1, then);
        scene.keepPoses();
        scene.setTransform(1, here);
        FrameSettings settings = frameSettings();
        settings.previousView = before;
        const Frame frame = renderer().render(scene, now, settings);
        const std::vector<Aov> drawn = frame.aovs({"P", "node_id", "motion"});
        ASSERT_EQ(drawn[2].channels, (std::vector<std::string>{"motion.X", "motion.Y"}));
        int moved = 0;
        for (std::size_t i = 0; i < width * height; ++i) {
            const glm::dvec2 is(drawn[2].values[0][i], drawn[2].values[1][i]);
            if (drawn[1].values[0][i] == 0.0f) {
                ASSERT_EQ(is, glm::dvec2(0.0));
                continue;
            }
            const glm::dvec3 p(drawn[0].values[0][i], drawn[0].values[1][i], drawn[0].values[2][i]);
            glm::dmat4 way(1.0);
            if (drawn[1].values[0][i] == 2.0f) way = glm::dmat4(then) * glm::inverse(glm::dmat4(here));
            const glm::dvec2 expected =
                pixelAt(now, p) - pixelAt(before, glm::dvec3(way * glm::dvec4(p, 1.0)));
            // Matrices of single precision, times the pixels of the picture.
            ASSERT_LT(glm::length(is - expected), 1e-4) << i;
            moved += glm::length(expected) > 1.0;
        }
        EXPECT_GT(moved, 1000);
    }
}

TEST_F(IdsTest, motionIsExactlyNothingWhereNothingMoves) {
    GpuScene scene = upload(described());
    scene.keepPoses();
    const Frame frame = renderer().render(scene, view(), frameSettings());
    const std::vector<Aov> resting = frame.aovs({"motion"});
    for (const std::vector<float>& values : resting[0].values)
        for (const float value : values) ASSERT_EQ(value, 0.0f);
    scene.setTransform(1, at({0.5f, 0, 0}));
    const Frame moved = renderer().render(scene, view(), frameSettings());
    const auto drawn = moved.aovs({"node_id", "motion"});
    for (std::size_t i = 0; i < width * height; ++i) {
        const float node = drawn[0].values[0][i];
        if (node != 2.0f) {
            ASSERT_EQ(drawn[1].values[0][i], 0.0f);
        } else {
            // 0.5 m at 4 m from an eye that sees 2 tan(0.35) m a metre in 60 pixels.
            ASSERT_NEAR(drawn[1].values[0][i], 0.5f / 4.0f * 60.0f / (2.0f * std::tan(0.35f)), 1e-3f);
        }
    }
}

}  // namespace
}  // namespace candela::test
