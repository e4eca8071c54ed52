// Scenes that a frame callback moves: a picture at a time is, bit for bit, that of a scene that has what the
// callback sets at that time and no callback, whatever was drawn before.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "scene/model/frame_callback.h"

#include <candela/error.h>
#include <candela/geometry.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>

namespace candela::test {
namespace {

const FrameRequest inputs{64, 48, lookAt({0.5f, 1.0f, 5}, {0, 0, 0}, 0.8f), BrdfModel::gltf,
                          Technique::tiles};

glm::mat4 movedTo(float x, float y = 0.0f, float z = 0.0f) {
    return glm::translate(glm::mat4(1.0f), {x, y, z});
}

/// Node 0: a sphere that swells. 1: a cage that does. 2: a floor. 3: the lamps. 4: a second sphere, the same
/// mesh.
Scene restingScene() {
    Scene scene;
    place(scene, makeSphere(0.8f), Material{}, movedTo(-1.1f));
    placeCage(scene, makeCubeCage(0.8f), Material{}, movedTo(1.1f));
    place(scene, makeQuad(4.0f), Material{}, movedTo(0, 0, -1.5f));
    scene.nodes.emplace_back().transform = movedTo(0, 2, 3);
    Node second = scene.nodes[0];
    second.transform = movedTo(0, -1, 0.5f);
    scene.nodes.push_back(second);
    scene.lights.resize(2);
    for (Light& light : scene.lights) {
        light.intensity = 20.0f;
        light.node = 3;
    }
    scene.lights[0].range = 9.0f;
    scene.lights[0].position = {-2, 0, 0};
    scene.lights[1].position = {2, 0, 0};
    return scene;
}

PropertyChannel value(AnimatedProperty property, std::uint32_t element, std::vector<float> numbers) {
    return {property, element, TextureSlot::baseColor, Interpolation::step, {0.0f}, std::move(numbers)};
}

class Swelling : public FrameCallback {
  public:
    explicit Swelling(const Scene& scene)
        : FrameCallback({0.0, 2.0}), mesh_(scene.meshes.at(0)), cage_(scene.cages.at(0)) {}
    bool movesMesh(std::uint32_t mesh) const override { return mesh == 0; }
    bool movesCage(std::uint32_t cage) const override { return cage == 0; }

    std::size_t missing = 0;  ///< Vertices that it leaves out.
    double failsFrom = std::numeric_limits<double>::infinity();

  private:
    SceneUpdate evaluate(double seconds) const override {
        if (seconds >= failsFrom) throw Error(ErrorKind::badInput, "wave:1", "it fails");
        const auto t = static_cast<float>(seconds);
        SceneUpdate update;
        update.meshes.push_back({0, {}, {}});
        // An ellipsoid, whose normals are those of its equation.
        const glm::vec3 size(1.0f + 0.3f * t, 1.0f, 1.0f - 0.2f * t);
        for (const glm::vec3& position : mesh_.positions) {
            update.meshes[0].positions.push_back(size * position);
            update.meshes[0].normals.push_back(glm::normalize(position / size));
        }
        update.meshes[0].positions.resize(mesh_.positions.size() - missing);
        update.cages.push_back({0, {}});
        for (const glm::vec3& position : cage_.positions)
            update.cages[0].positions.push_back((1.0f + 0.2f * t) * position);
        // Only at some times: at others it is at rest.
        if (seconds < 1.5) update.nodes.push_back({1, glm::dmat4(movedTo(1.1f, 0.5f * t))});
        if (seconds > 0.7) update.nodes.push_back({3, glm::dmat4(movedTo(-t, 2, 3))});
        update.properties.push_back(value(AnimatedProperty::lightPosition, 0, {-2, t, 0}));
        if (seconds < 1.0)
            update.properties.push_back(value(AnimatedProperty::lightIntensity, 1, {20.0f + 10.0f * t}));
        update.properties.push_back(value(AnimatedProperty::baseColor, 0, {1, 1.0f - 0.5f * t, 0.5f, 1}));
        update.properties.push_back(value(AnimatedProperty::visibility, 4, {seconds < 1.2 ? 1.0f : 0.0f}));
        return update;
    }

    Mesh mesh_;
    Cage cage_;
};

/// What the callback sets at a time, in the scene itself.
Scene baked(const Scene& moving, double time) {
    Scene scene = moving;
    poseProperties(scene, time);
    const std::shared_ptr<const SceneUpdate> update = updateAt(scene, time);
    for (const SceneUpdate::MeshVertices& mesh : update->meshes) {
        scene.meshes[mesh.mesh].positions = mesh.positions;
        scene.meshes[mesh.mesh].normals = mesh.normals;
    }
    for (const SceneUpdate::CageVertices& cage : update->cages)
        scene.cages[cage.cage].positions = cage.positions;
    for (const SceneUpdate::NodeMatrix& node : update->nodes)
        scene.nodes[node.node].transform = glm::mat4(node.local);
    scene.frameCallback.reset();
    scene.animations.clear();
    return scene;
}

class FrameCallbackTest : public DrawingTest {
  protected:
    static GpuScene uploaded(const Scene& scene) { return {context(), scene, subdividing(2)}; }
    static Scene movingScene() {
        Scene scene = restingScene();
        scene.frameCallback = std::make_shared<Swelling>(scene);
        return scene;
    }
    static void expectPicturesOfBakedScenes(const Scene& moving, const FrameRequest& request) {
        GpuScene playing = uploaded(moving);
        EXPECT_EQ(drawn(playing, request).rgba, drawn(uploaded(baked(moving, 0.0)), request).rgba);
        HdrImage last;
        for (const double time : {0.5, 2.0, 1.3, 0.5, 0.0, 1.75}) {
            playing.setTime(time);
            const HdrImage picture = drawn(playing, request);
            EXPECT_EQ(picture.rgba, drawn(uploaded(baked(moving, time)), request).rgba) << time;
            EXPECT_NE(picture.rgba, last.rgba) << "the motion shows";
            last = picture;
        }
    }
};

TEST_F(FrameCallbackTest, APictureIsThatOfItsTimeInEveryTechniqueWithShadows) {
    for (const Form& form : forms) {
        SCOPED_TRACE(form.name);
        FrameRequest request = inputs;
        request.technique = form.technique;
        request.tileBackend = form.backend;
        request.shadows = Shadows::on;
        expectPicturesOfBakedScenes(movingScene(), request);
    }
}

TEST_F(FrameCallbackTest, AppliesOnTopOfAnimations) {
    Scene moving = movingScene();
    moving.nodes[2].transform = Transform{.translation = {0, 0, -1.5f}};
    moving.nodes[3].transform = Transform{.translation = {0, 2, 3}};
    AnimationChannel lift{.node = 3, .times = {0, 2}, .values = {0, 2, 3, 1, 3, 3}};
    AnimationChannel sink{.node = 2, .times = {0, 2}, .values = {0, 0, -1.5f, 0, 0, -3}};
    moving.animations.emplace_back().channels = {lift, sink};
    moving.animations[0].properties = {value(AnimatedProperty::lightIntensity, 1, {5}),
                                       value(AnimatedProperty::roughness, 0, {0.3f})};
    GpuScene playing = uploaded(moving);
    for (const double time : {0.5, 1.75, 0.8}) {
        playing.setTime(time);
        Scene expected = baked(moving, time);
        const std::vector<glm::mat4> world = worldTransforms(moving, time);
        for (const std::uint32_t node : {2u, 3u}) expected.nodes[node].transform = world[node];
        EXPECT_EQ(drawn(playing, inputs).rgba, drawn(uploaded(expected), inputs).rgba) << time;
    }
}

TEST_F(FrameCallbackTest, EditsOfTheHostStay) {
    const Scene moving = movingScene();
    GpuScene playing = uploaded(moving);
    playing.setTime(0.5);
    playing.setTransform(1, movedTo(1.1f, -0.5f));
    Material blue;
    blue.baseColor = {0, 0, 1, 1};
    playing.setMaterial(0, blue);
    playing.removeNode(NodeHandle(4));
    const WorldLight light = pointLight({0, 3, 5}, 30.0f, glm::vec3(20.0f));
    playing.setLights({&light, 1});
    playing.setTime(0.9);
    Scene expected = baked(moving, 0.9);
    expected.nodes[1].transform = movedTo(1.1f, -0.5f);
    expected.materials[0] = blue;
    expected.nodes.pop_back();
    GpuScene resting = uploaded(expected);
    resting.setLights({&light, 1});
    EXPECT_EQ(drawn(playing, inputs).rgba, drawn(resting, inputs).rgba);
}

TEST_F(FrameCallbackTest, WhatItMovesCanNotBeReplaced) {
    const Scene moving = movingScene();
    GpuScene playing = uploaded(moving);
    const Mesh& mesh = moving.meshes[0];
    EXPECT_THROW(playing.setPositions(MeshHandle(0), mesh.positions), Error);
    EXPECT_THROW(playing.replaceMesh(MeshHandle(0), mesh), Error);
    EXPECT_THROW(playing.replaceCage(CageHandle(0), moving.cages[0]), Error);
    EXPECT_NO_THROW(playing.replaceMesh(MeshHandle(1), moving.meshes[1]));
}

TEST_F(FrameCallbackTest, NodesThatAreAddedShowTheMovedMeshAndCage) {
    const Scene moving = movingScene();
    GpuScene playing = uploaded(moving);
    Node mesh, cage;
    mesh.mesh = 0;
    mesh.transform = movedTo(0, 1);
    cage.cage = 0;
    cage.transform = movedTo(0, 0, 1);
    playing.addNode(mesh);
    playing.addNode(cage);
    for (const double time : {1.0, 0.25}) {
        playing.setTime(time);
        Scene expected = baked(moving, time);
        expected.nodes.push_back(mesh);
        expected.nodes.push_back(cage);
        EXPECT_EQ(drawn(playing, inputs).rgba, drawn(uploaded(expected), inputs).rgba) << time;
    }
}

TEST_F(FrameCallbackTest, AFailureLeavesTheTimeBefore) {
    Scene moving = restingScene();
    const auto callback = std::make_shared<Swelling>(moving);
    callback->failsFrom = 1.0;
    moving.frameCallback = callback;
    GpuScene playing = uploaded(moving);
    playing.setTime(0.5);
    const HdrImage before = drawn(playing, inputs);
    for (int i = 0; i < 2; ++i) {
        try {
            playing.setTime(1.0);
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "wave:1: it fails");
        }
        EXPECT_EQ(drawn(playing, inputs).rgba, before.rgba);
    }
    callback->failsFrom = std::numeric_limits<double>::infinity();
    callback->missing = 1;
    EXPECT_THROW(playing.setTime(1.25), Error) << "a vertex is missing";
    EXPECT_EQ(drawn(playing, inputs).rgba, before.rgba);
}

}  // namespace
}  // namespace candela::test
