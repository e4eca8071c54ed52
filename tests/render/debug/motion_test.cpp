// The AOV motion of surfaces whose vertices move within their nodes: the vertices of both times in double
// precision, through both views.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "scene/model/frame_callback.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace candela::test {
namespace {

constexpr int width = 64, height = 48;
constexpr double then = 0.25, now = 1.5;

glm::mat4 at(float x, float y = 0.0f, float z = 0.0f) {
    return glm::translate(glm::mat4(1.0f), {x, y, z});
}

CameraView view() {
    return lookAt({0, 0.2f, 5}, {0, 0, 0}, 0.8f);
}
CameraView viewBefore() {
    return lookAt({0.3f, 0, 5.2f}, {0, 0.1f, 0}, 0.8f);
}

/// Where a world position is in the picture, pixels, y down, by the projection matrix in double precision.
glm::dvec2 pixelAt(const CameraView& seen, const glm::dvec3& position) {
    const glm::dmat4 clip = glm::dmat4(projection(seen, float(width) / height));
    const glm::dvec4 p = clip * glm::inverse(glm::dmat4(seen.worldFromCamera)) * glm::dvec4(position, 1.0);
    return {(0.5 + 0.5 * p.x / p.w) * width, (0.5 - 0.5 * p.y / p.w) * height};
}

/// The point of a triangle that is nearest to the plane foot of `p`, as shares of the corners, and how far
/// `p` is from it.
struct Foot {
    glm::dvec3 shares{0.0};
    double distance = std::numeric_limits<double>::infinity();
};
Foot footOn(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& p) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = glm::dot(normal, normal);
    if (area == 0.0) return {};
    glm::dvec3 shares;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &a = corners[std::size_t(i + 1) % 3], &b = corners[std::size_t(i + 2) % 3];
        shares[i] = std::max(glm::dot(normal, glm::cross(b - a, p - a)) / area, 0.0);
    }
    shares /= shares.x + shares.y + shares.z;
    const glm::dvec3 foot = shares.x * corners[0] + shares.y * corners[1] + shares.z * corners[2];
    return {shares, glm::distance(foot, p)};
}

/// The surface that a node shows, in the world at one time.
std::vector<glm::dvec3> worldVertices(const Scene& scene, std::uint32_t node, double time) {
    const PosedPoints posed = poseMesh(scene, node, worldTransforms(scene, time), time);
    std::vector<glm::dvec3> vertices;
    for (const glm::vec3& point : posed.points)
        vertices.emplace_back(glm::dmat4(posed.worldFromPoints) * glm::dvec4(point, 1.0));
    return vertices;
}

class MotionTest : public DrawingTest {
  protected:
    struct Aovs {
        std::vector<Aov> values;
        float node(std::size_t i) const { return values[1].values[0][i]; }
        glm::dvec3 position(std::size_t i) const {
            return {values[0].values[0][i], values[0].values[1][i], values[0].values[2][i]};
        }
        glm::dvec2 motion(std::size_t i) const { return {values[2].values[0][i], values[2].values[1][i]}; }
    };
    static Aovs drawn(GpuScene& scene) {
        FrameSettings settings;
        settings.width = width;
        settings.height = height;
        settings.previousView = viewBefore();
        return {renderer().render(scene, view(), settings).aovs({"P", "node_id", "motion"})};
    }
    static GpuScene moved(const Scene& scene) {
        GpuScene uploaded(context(), scene, subdividing(2));
        uploaded.setTime(then);
        uploaded.keepPoses();
        uploaded.setTime(now);
        return uploaded;
    }
    /// `positionThen(node, p)`: where what is at `p` now was.
    template <typename PositionThen>
    static void expectMotion(const Aovs& aovs, const PositionThen& positionThen) {
        int moving = 0;
        for (std::size_t i = 0; i < width * height; ++i) {
            if (aovs.node(i) == 0.0f) {
                ASSERT_EQ(aovs.motion(i), glm::dvec2(0.0));
                continue;
            }
            const glm::dvec3 p = aovs.position(i);
            const glm::dvec3 before = positionThen(static_cast<std::uint32_t>(aovs.node(i)) - 1, p);
            const glm::dvec2 expected = pixelAt(view(), p) - pixelAt(viewBefore(), before);
            // Rasterisers move vertices to the nearest 1/256 of a pixel, and the ways of neighbouring pixels
            // differ by less than half a pixel.
            ASSERT_LT(glm::length(aovs.motion(i) - expected), 2e-3) << i;
            moving += glm::distance(p, before) > 0.05 ? 1 : 0;
        }
        EXPECT_GT(moving, 200) << "surfaces move";
    }
    /// Of the nodes' meshes, by the vertices of both times.
    static void expectMotionOfMeshes(const Scene& scene) {
        GpuScene uploaded = moved(scene);
        std::vector<std::vector<glm::dvec3>> verticesNow, verticesThen;
        for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
            const bool shows = scene.nodes[i].mesh.has_value();
            verticesNow.push_back(shows ? worldVertices(scene, i, now) : std::vector<glm::dvec3>());
            verticesThen.push_back(shows ? worldVertices(scene, i, then) : std::vector<glm::dvec3>());
        }
        expectMotion(drawn(uploaded), [&](std::uint32_t node, const glm::dvec3& p) {
            const std::vector<std::uint32_t>& indices = scene.meshes[*scene.nodes[node].mesh].indices;
            Foot nearest;
            glm::dvec3 before(0.0);
            for (std::size_t corner = 0; corner < indices.size(); corner += 3) {
                const auto corners = [&](const std::vector<glm::dvec3>& vertices) {
                    return std::array{vertices[indices[corner]], vertices[indices[corner + 1]],
                                      vertices[indices[corner + 2]]};
                };
                const Foot foot = footOn(corners(verticesNow[node]), p);
                if (foot.distance >= nearest.distance) continue;
                nearest = foot;
                const auto [a, b, c] = corners(verticesThen[node]);
                before = foot.shares.x * a + foot.shares.y * b + foot.shares.z * c;
            }
            return before;
        });
    }
};

/// Two spheres of morph targets that animations move, the second with a node that moves too, and a still
/// quad.
Scene morphedScene() {
    Scene scene;
    Mesh sphere = makeSphere(0.8f);
    MorphTarget stretch, shear;
    for (const glm::vec3& p : sphere.positions) {
        stretch.offsets.emplace_back(0.6f * p.x, -0.2f * p.y, 0.0f);
        shear.offsets.emplace_back(0.3f * p.y * p.y, 0.0f, 0.2f * p.x);
    }
    sphere.morphTargets = {stretch, shear};
    place(scene, sphere, Material{}, at(-1.1f));
    Node second = scene.nodes[0];
    second.transform = Transform{};
    scene.nodes.push_back(second);
    place(scene, makeQuad(4.0f), Material{}, at(0, 0, -1.5f));
    Animation& animation = scene.animations.emplace_back();
    for (const std::uint32_t node : {0u, 1u}) {
        animation.channels.push_back(
            {node, AnimationPath::morphWeights, Interpolation::linear, {0, 2}, {0, 1, 1, -0.5f}});
    }
    animation.channels.push_back(
        {1, AnimationPath::translation, Interpolation::linear, {0, 2}, {0.6f, 0, 0, 1.4f, 0.3f, 0.2f}});
    return scene;
}

TEST_F(MotionTest, OfMorphTargets) {
    expectMotionOfMeshes(morphedScene());
}

TEST_F(MotionTest, OfSkins) {
    Scene scene;
    Mesh sphere = makeSphere(1.2f);
    sphere.influenceCount = 2;
    for (const glm::vec3& p : sphere.positions) {
        const float upper = std::clamp(0.5f + p.y / 2.4f, 0.0f, 1.0f);
        sphere.joints.insert(sphere.joints.end(), {0, 1});
        sphere.jointWeights.insert(sphere.jointWeights.end(), {1.0f - upper, upper});
    }
    place(scene, sphere, Material{}, at(9));  // What a skin moves is not placed by its node.
    place(scene, makeQuad(4.0f), Material{}, at(0, 0, -1.5f));
    scene.nodes.resize(4);
    scene.nodes[3].parent = 2;
    scene.skins = {{"arm", {2, 3}, {glm::mat4(1.0f), glm::mat4(1.0f)}}};
    scene.nodes[0].skin = 0;
    const glm::quat turned = glm::angleAxis(1.2f, glm::normalize(glm::vec3(0.3f, 0.2f, 1)));
    scene.animations.emplace_back().channels = {
        {2, AnimationPath::translation, Interpolation::linear, {0, 2}, {-0.3f, 0, 0, 0.4f, 0.2f, 0.1f}},
        {3,
         AnimationPath::rotation,
         Interpolation::linear,
         {0, 2},
         {0, 0, 0, 1, turned.x, turned.y, turned.z, turned.w}}};
    expectMotionOfMeshes(scene);
}

/// Waves the last mesh and scales the first cage.
class Waves : public FrameCallback {
  public:
    explicit Waves(const Scene& scene) : FrameCallback({0.0, 2.0}), scene_(scene) {}
    bool movesMesh(std::uint32_t mesh) const override { return mesh + 1 == scene_.meshes.size(); }
    bool movesCage(std::uint32_t cage) const override { return cage == 0 && !scene_.cages.empty(); }

    static glm::vec3 scale(double seconds) {
        const auto t = static_cast<float>(seconds);
        return {1.0f + 0.3f * t, 1.0f - 0.2f * t, 1.0f};
    }

  private:
    SceneUpdate evaluate(double seconds) const override {
        SceneUpdate update;
        if (!scene_.meshes.empty()) {
            const Mesh& mesh = scene_.meshes.back();
            const auto index = static_cast<std::uint32_t>(scene_.meshes.size() - 1);
            update.meshes.push_back({index, mesh.positions, mesh.normals});
            for (glm::vec3& p : update.meshes[0].positions)
                p.z += 0.3f * std::sin(2.0f * p.x + 3.0f * static_cast<float>(seconds));
        }
        if (!scene_.cages.empty()) {
            update.cages.push_back({0, scene_.cages[0].positions});
            for (glm::vec3& p : update.cages[0].positions) p *= scale(seconds);
        }
        return update;
    }

    Scene scene_;
};

TEST_F(MotionTest, OfTheMeshesOfAFrameCallback) {
    Scene scene;
    place(scene, makeSphere(0.8f), Material{}, at(-1.1f));
    scene.nodes.push_back(scene.nodes[0]);  // Two nodes show it; others come before it in the buffers.
    scene.nodes[1].transform = at(1.1f, 0.3f);
    place(scene, makeQuad(4.0f), Material{}, at(0, 0, -1.5f));
    std::swap(scene.meshes[0], scene.meshes[1]);
    scene.nodes[0].mesh = scene.nodes[1].mesh = 1;
    scene.nodes[2].mesh = 0;
    scene.frameCallback = std::make_shared<Waves>(scene);
    expectMotionOfMeshes(scene);
}

TEST_F(MotionTest, OfCages) {
    // A limit surface is an affine image of itself where the points of its cage are.
    const auto back = [](const glm::dvec3& center, const glm::dvec3& p) {
        const glm::dvec3 scale = glm::dvec3(Waves::scale(then)) / glm::dvec3(Waves::scale(now));
        return center + scale * (p - center);
    };
    Scene scene;
    placeCage(scene, makeCubeCage(0.8f), Material{}, at(-1.1f));
    placeCage(scene, makeCubeCage(0.8f), Material{}, at(1.1f));
    scene.frameCallback = std::make_shared<Waves>(scene);
    GpuScene uploaded(context(), scene, subdividing(2));
    const auto scaled = [&](double time) {
        std::vector<glm::vec3> points = scene.cages[1].positions;
        for (glm::vec3& point : points) point *= Waves::scale(time);
        return points;
    };
    // The first cage by the callback, the second by the host.
    uploaded.setTime(then);
    uploaded.setCagePoints(1, scaled(then));
    uploaded.keepPoses();
    uploaded.setTime(now);
    uploaded.setCagePoints(1, scaled(now));
    expectMotion(drawn(uploaded), [&](std::uint32_t node, const glm::dvec3& p) {
        return back({node == 0 ? double{-1.1f} : double{1.1f}, 0, 0}, p);
    });
    // At another level.
    uploaded.setSubdivision({.level = 3});
    expectMotion(drawn(uploaded), [&](std::uint32_t node, const glm::dvec3& p) {
        return back({node == 0 ? double{-1.1f} : double{1.1f}, 0, 0}, p);
    });
}

TEST_F(MotionTest, IsExactlyNothingWhereVerticesRest) {
    GpuScene scene(context(), morphedScene());
    scene.setTime(now);
    scene.keepPoses();
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    const std::vector<Aov> aovs = renderer().render(scene, view(), settings).aovs({"motion"});
    for (const std::vector<float>& values : aovs[0].values)
        EXPECT_TRUE(std::ranges::all_of(values, [](float value) { return value == 0.0f; }));
}

}  // namespace
}  // namespace candela::test
