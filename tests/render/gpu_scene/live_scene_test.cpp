// Elements that are added, removed and replaced while the scene is on the device: after any edits the picture
// is that of a GpuScene made from the edited scene, bit for bit.

#include "support/live_scene.h"
#include "support/drawing_test.h"

#include "gl/state_guard.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <candela/error.h>
#include <candela/shapes.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>

namespace candela::test {
namespace {

const CameraView camera = lookAt({2.5f, 3.0f, 6}, {0, 0, 0}, 0.8f);

class LiveSceneTest : public DrawingTest {
  protected:
    static std::string errorOf(const std::function<void()>& edit) {
        try {
            edit();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

const FrameRequest request{48, 36, camera};

struct Form {
    const char* name;
    Technique technique;
    Shadows shadows;
    TileBackend backend = TileBackend::automatic;
};

TEST_F(LiveSceneTest, AnyEditsLeaveThePictureOfASceneMadeAnew) {
    const Form forms[] = {{"tiles", Technique::tiles, Shadows::on},
                          {"volumes", Technique::volumes, Shadows::on},
                          {"fullscreen", Technique::fullscreen, Shadows::on},
                          {"without shadows", Technique::tiles, Shadows::off}};
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        LiveScene scene(context(), seed);
        for (int step = 0; step < 10; ++step) {
            for (int i = 0; i < 6; ++i) scene.edit();
            const Form& form = forms[(seed + step) % std::size(forms)];
            GpuScene anew = scene.anew();
            FrameRequest shown = request;
            shown.technique = form.technique;
            shown.shadows = form.shadows;
            const HdrImage live = drawn(scene.onDevice(), shown);
            ASSERT_EQ(live.rgba, drawn(anew, shown).rgba)
                << form.name << ", seed " << seed << ", step " << step;
            EXPECT_EQ(scene.onDevice().triangleCount(), anew.triangleCount());
            EXPECT_EQ(scene.onDevice().lightReport().lights, anew.lightReport().lights);
            EXPECT_EQ(scene.onDevice().lightReport().rangeIrradiance, anew.lightReport().rangeIrradiance);
        }
    }
}

Scene oneBox() {
    Scene scene;
    scene.meshes.push_back(boxMesh());
    scene.nodes.emplace_back().mesh = 0;
    scene.materials.emplace_back();
    scene.lights.emplace_back().position = {1, 2, 3};
    return scene;
}

TEST_F(LiveSceneTest, StaleHandlesSaySo) {
    GpuScene scene(context(), oneBox(), {.vertexDetail = VertexDetail::always});
    const NodeHandle node = scene.addNode({});
    const MeshHandle mesh = scene.addMesh(sphereMesh());
    const MaterialHandle material = scene.addMaterial({});
    const LightHandle light = scene.addLight({});
    Random random(1);
    const ImageHandle image = scene.addImage(randomImage(random));
    scene.removeNode(node);
    scene.removeMesh(mesh);
    scene.removeMaterial(material);
    scene.removeLight(light);
    scene.removeImage(image);
    const auto checkAll = [&] {
        EXPECT_EQ(errorOf([&] { scene.setTransform(node, glm::mat4(1.0f)); }),
                  "the handle of node 1 is stale: that node has been removed");
        EXPECT_EQ(errorOf([&] { scene.removeNode(node); }),
                  "the handle of node 1 is stale: that node has been removed");
        EXPECT_EQ(errorOf([&] { scene.replaceMesh(mesh, boxMesh()); }),
                  "the handle of mesh 1 is stale: that mesh has been removed");
        EXPECT_EQ(errorOf([&] { scene.setMaterial(material, {}); }),
                  "the handle of material 2 is stale: that material has been removed");
        EXPECT_EQ(errorOf([&] { scene.setLight(light, {}); }),
                  "the handle of light 1 is stale: that light has been removed");
        EXPECT_EQ(errorOf([&] { scene.removeImage(image); }),
                  "the handle of image 0 is stale: that image has been removed");
    };
    checkAll();
    EXPECT_EQ(scene.addNode({}).index, node.index);
    EXPECT_EQ(scene.addMesh(boxMesh()).index, mesh.index);
    EXPECT_EQ(scene.addMaterial({}).index, material.index);
    EXPECT_EQ(scene.addLight({}), LightHandle(light.index, light.generation + 1));
    scene.addImage(randomImage(random));
    checkAll();
    EXPECT_EQ(errorOf([&] { scene.setTransform(9, glm::mat4(1.0f)); }),
              "there is no node 9: the scene has 2 (counted from 0)");
}

TEST_F(LiveSceneTest, RefusedEditsChangeNothing) {
    GpuScene scene(context(), oneBox());
    const HdrImage before = drawn(scene, request);
    const auto refused = [&](const std::function<void()>& edit, const std::string& text) {
        const std::string error = errorOf(edit);
        EXPECT_NE(error.find(text), std::string::npos) << error;
        EXPECT_EQ(drawn(scene, request).rgba, before.rgba) << text;
    };
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), {0.5f, 0, 0});
    const GpuScene::NodeTransform transforms[] = {{0, moved}, {0, glm::mat4(NAN)}};
    refused([&] { scene.setTransforms(transforms); }, "node 0: its matrix must be finite numbers");
    const GpuScene::NodeVisibility visibilities[] = {{0, GpuScene::Visibility::hidden}, {5}};
    refused([&] { scene.setVisibilities(visibilities); }, "there is no node 5");
    Node node;
    node.mesh = 7;
    refused([&] { scene.addNode(node); }, "mesh 7");
    node = {};
    node.parent = 4;
    refused([&] { scene.addNode(node); }, "node 4");
    Mesh mesh = boxMesh();
    mesh.indices[0] = 99;
    refused([&] { scene.replaceMesh(0, mesh); }, "index 0 names vertex 99");
    mesh = boxMesh();
    mesh.submeshes[0].material = 3;
    refused([&] { scene.replaceMesh(0, mesh); }, "material 3");
    mesh.submeshes[0].material = std::nullopt;
    mesh.colors.resize(mesh.positions.size(), glm::vec4(1, 0, 0, 1));
    refused([&] { scene.addMesh(mesh); }, "GpuSceneOptions::vertexDetail");
    refused([&] { scene.removeMesh(0); }, "a node shows it");
    std::vector<glm::vec3> positions(24, glm::vec3(NAN));
    refused([&] { scene.setPositions(0, positions); }, "position 0 is not a finite number");
    positions.resize(3);
    refused([&] { scene.setPositions(0, positions); }, "has 3 positions for 24 vertices");
    refused(
        [&] {
            scene.setPositions(0, BufferRange{12345, 0}, {{0, 0, 0}, {1, 1, 1}});
        },
        "buffer 12345 is no buffer of the current context");
    Light light;
    light.intensity = -1.0f;
    refused([&] { scene.addLight(light); }, "light 1: its intensity");
    Material material;
    material.baseColorTexture = Texture{};
    refused([&] { scene.addMaterial(material); }, "image 0");
    Image image{"small", 2, 2, PixelFormat::rgba8, {}};
    refused([&] { scene.addImage(image); }, "image 0 'small'");
    refused([&] { scene.setLights(BufferRange{0, 0}, 1); }, "buffer 0 is no buffer");
    scene.setLights(std::vector<WorldLight>{});
    EXPECT_NE(errorOf([&] { scene.addLight({}); }).find("setLights has replaced"), std::string::npos);
}

TEST_F(LiveSceneTest, BulkEditsAreThoseOfSingleOnes) {
    Random random(5);
    Scene scene = oneBox();
    for (std::uint32_t i = 1; i < 20; ++i) scene.nodes.push_back(scene.nodes[0]);
    GpuScene bulk(context(), scene), single(context(), scene);
    std::vector<GpuScene::NodeTransform> transforms;
    std::vector<GpuScene::NodeVisibility> visibilities;
    for (std::uint32_t i = 0; i < 20; ++i) {
        transforms.push_back({i, randomPlace(random)});
        visibilities.push_back({i, i % 3 == 0 ? GpuScene::Visibility::hidden : GpuScene::Visibility::shown});
        single.setTransform(i, transforms.back().local);
        single.setVisibility(i, visibilities.back().visibility);
    }
    bulk.setTransforms(transforms);
    bulk.setVisibilities(visibilities);
    EXPECT_EQ(drawn(bulk, request).rgba, drawn(single, request).rgba);
}

/// A GL buffer of the bytes of `values`.
template <typename T>
GLuint bufferOf(const std::vector<T>& values) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferData(name, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                      GL_STATIC_DRAW);
    return name;
}

TEST_F(LiveSceneTest, TakesVerticesLightsAndPixelsOfBuffers) {
    Scene scene = oneBox();
    Random random(3);
    scene.images.push_back(randomImage(random));
    scene.materials[0].baseColorTexture = Texture{};
    scene.meshes[0] = sphereMesh(1.0f, 32, 16);
    scene.meshes[0].submeshes[0].material = 0;
    FrameRequest shadowed = request;
    shadowed.shadows = Shadows::on;
    GpuScene live(context(), scene);
    drawn(live, shadowed);

    Mesh& mesh = scene.meshes[0];
    std::vector<glm::vec3> surface{glm::vec3(7.0f)};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i].y *= 0.5f;
        surface.push_back(mesh.positions[i]);
        surface.push_back(mesh.normals[i]);
    }
    std::vector<WorldLight> lights(3);
    std::vector<LightRecord> records(1);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        WorldLight& light = lights[i];
        light.type = static_cast<LightType>(i);
        light.position = {float(i), 2, 2};
        // Without a range it would depend on the bounds, which are not those of the mesh.
        light.range = 9.0f;
        light.direction = glm::normalize(glm::vec3(-1, -1, -1));
        light.intensity = {1, 2, 3};
        light.radius = i == 0 ? 0.1f : 0.0f;
        light.castsShadow = i != 2;
        records.push_back({{light.position.x, 2, 2},
                           9,
                           {light.direction.x, light.direction.y, light.direction.z},
                           float(i),
                           {1, 2, 3},
                           light.castsShadow ? 1.0f : 0.0f,
                           light.innerConeAngle,
                           light.outerConeAngle,
                           light.radius,
                           0});
    }
    const ImageRegion region{1, 2, 3, 4};
    std::vector<std::byte> pixels(3 * 4 * 4, std::byte{200});
    for (std::uint32_t row = 0; row < 4; ++row)
        std::memset(scene.images[0].pixels.data() + ((2 + row) * scene.images[0].width + 1) * 4, 200, 12);
    const GLuint names[] = {bufferOf(surface), bufferOf(records), bufferOf(pixels)};
    live.setPositions(0, BufferRange{names[0], 12}, {{-1, -0.5f, -1}, {1, 0.5f, 1}});
    live.setLights(BufferRange{names[1], sizeof(LightRecord)}, 3);
    live.setPixels(0, region, BufferRange{names[2], 0});
    EXPECT_THROW(live.setPositions(0, BufferRange{names[0], 16}, {{-1, -1, -1}, {1, 1, 1}}), Error);
    EXPECT_THROW(live.setLights(BufferRange{names[1], 0}, 5), Error);
    EXPECT_THROW(live.setPixels(0, {0, 0, 4, 4}, BufferRange{names[2], 0}), Error);
    glDeleteBuffers(3, names);
    GpuScene anew(context(), scene);
    anew.setLights(lights);
    const HdrImage picture = drawn(live, shadowed);
    EXPECT_EQ(picture.rgba, drawn(anew, shadowed).rgba);
    EXPECT_GT(*std::ranges::max_element(picture.rgba), 0.1f);
}

TEST_F(LiveSceneTest, AnEditCostsWhatItChanges) {
    Scene scene = oneBox();
    for (std::uint32_t i = 1; i < 1000; ++i) scene.nodes.push_back(scene.nodes[0]);
    GpuScene live(context(), scene);
    const auto updated = [&] {
        const gl::StateGuard guard(*context().state().binding, "a test");
        live.state().update();
        return live.state().lastUpdate;
    };
    updated();
    std::vector<GpuScene::NodeTransform> transforms;
    for (std::uint32_t i = 0; i < 10; ++i) transforms.push_back({100 * i, glm::mat4(1.0f)});
    live.setTransforms(transforms);
    auto counts = updated();
    EXPECT_EQ(counts.nodes, 10u);
    EXPECT_EQ(counts.instances, 10u);
    EXPECT_EQ(counts.draws, 0u);
    Node node;
    node.mesh = 0;
    const NodeHandle added = live.addNode(node);
    counts = updated();
    EXPECT_EQ(counts.nodes, 1u);
    EXPECT_EQ(counts.instances, 1u);
    EXPECT_EQ(counts.draws, 1u);
    live.removeNode(added);
    live.addLight({});
    counts = updated();
    EXPECT_EQ(counts.nodes, 1u);
    EXPECT_EQ(counts.instances, 0u);
    EXPECT_EQ(counts.materials, 0u);
}

/// A sphere whose upper half follows joint 1 and the lower one joint 0, and which one target makes wider.
Mesh deformableSphere(float radius) {
    Mesh mesh = sphereMesh(radius, 16, 9);
    mesh.influenceCount = 1;
    MorphTarget wider;
    for (const glm::vec3& position : mesh.positions) {
        mesh.joints.push_back(position.y > 0.0f ? 1 : 0);
        mesh.jointWeights.push_back(1.0f);
        wider.offsets.emplace_back(0.4f * position.x, 0.0f, 0.0f);
    }
    mesh.morphTargets.push_back(wider);
    return mesh;
}

TEST_F(LiveSceneTest, DeformedNodesComeAndGo) {
    Random random(9);
    Scene scene;
    scene.nodes.resize(2);
    scene.skins.push_back({"skin", {0, 1}, {glm::mat4(1.0f), glm::mat4(1.0f)}});
    scene.meshes.push_back(deformableSphere(0.4f));
    Node node;
    node.mesh = 0;
    node.skin = 0;
    scene.nodes.push_back(node);
    for (int i = 0; i < 3; ++i) scene.lights.push_back(randomLight(random, std::nullopt));
    GpuScene live(context(), scene);
    FrameRequest shadowed = request;
    shadowed.shadows = Shadows::on;
    const auto expectSame = [&](const char* what) {
        GpuScene anew(context(), scene);
        const HdrImage picture = drawn(live, shadowed);
        EXPECT_EQ(picture.rgba, drawn(anew, shadowed).rgba) << what;
        EXPECT_EQ(live.deformationReport().meshes, anew.deformationReport().meshes) << what;
    };
    drawn(live, shadowed);
    // A second mesh, moved by the skin and by its target, and by the target alone.
    scene.meshes.push_back(deformableSphere(0.3f));
    EXPECT_EQ(live.addMesh(scene.meshes[1]).index, 1u);
    node.mesh = 1;
    node.morphWeights = {0.7f};
    scene.nodes.push_back(node);
    EXPECT_EQ(live.addNode(node).index, 3u);
    node.skin = std::nullopt;
    node.transform = glm::translate(glm::mat4(1.0f), {0, 1.2f, 0});
    scene.nodes.push_back(node);
    EXPECT_EQ(live.addNode(node).index, 4u);
    expectSame("added");
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), {0.3f, 0.5f, 0});
    scene.nodes[1].transform = moved;
    live.setTransform(1, moved);
    expectSame("a joint has moved");
    live.removeNode(2);
    scene.nodes[2] = {};
    expectSame("removed");
    node.morphWeights = {0.0f};
    node.mesh = 0;
    node.skin = 0;
    scene.nodes[2] = node;
    EXPECT_EQ(live.addNode(node), NodeHandle(2, 1));
    expectSame("added again");
    EXPECT_EQ(errorOf([&] { live.removeNode(1); }), "node 1: is a joint of skin 0 and can not be removed");
    EXPECT_EQ(errorOf([&] { live.replaceMesh(1, boxMesh()); }),
              "mesh 1 'box': a node shows it deformed: it can not be changed");
    node.morphWeights = {1.0f, 2.0f};
    EXPECT_NE(errorOf([&] { live.addNode(node); }).find("2 morph weights"), std::string::npos);
    expectSame("refused");
}

}  // namespace
}  // namespace candela::test
