// Scenes of many nodes of which some move, come and go: the tree over the instances is adapted or built anew,
// and the picture is that of a GpuScene made from the edited scene, bit for bit.

#include "support/drawing_test.h"
#include "support/random_elements.h"

#include "render/gpu_scene/gpu_scene_state.h"
#include "render/occlusion/occlusion_scene.h"

#include <candela/shapes.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace candela::test {
namespace {

const CameraView camera = lookAt({0.0f, 7.0f, 14.0f}, {0, 0, 0}, 0.9f);

class LiveInstancesTest : public DrawingTest {};

/// A floor, and small meshes over it as values and on the device.
class Swarm {
  public:
    Swarm(const Context& context, std::uint32_t seed, std::uint32_t count)
        : context_(context), random_(seed) {
        scene_.materials.resize(3);
        scene_.materials[1].baseColor.a = 0.5f;
        scene_.materials[1].alphaMode = AlphaMode::blend;
        scene_.meshes = {planeMesh(16, 16, 3), boxMesh(), sphereMesh(0.6f, 8, 5),
                         boxMesh({1.0f, 0.2f, 0.6f})};
        for (std::uint32_t i = 0; i < scene_.meshes.size(); ++i)
            scene_.meshes[i].submeshes[0].material = i == 3 ? 1 : 0;
        for (glm::vec3& position : scene_.meshes[0].positions) position.y -= 1.5f;
        scene_.nodes.emplace_back().mesh = 0;
        for (std::uint32_t i = 1; i < count; ++i) {
            scene_.nodes.push_back(node());
            places_.push_back(std::get<glm::mat4>(scene_.nodes.back().transform));
        }
        for (int i = 0; i < 5; ++i) {
            Light& light = scene_.lights.emplace_back();
            light.position = {6.0f * number(), 4.0f + number(), 6.0f * number()};
            light.intensity = 60.0f;
            light.range = 20.0f;
        }
        gpuScene_.emplace(context, scene_);
        for (std::uint32_t i = 1; i < count; ++i) nodes_.push_back(NodeHandle(i));
    }

    GpuScene& onDevice() { return *gpuScene_; }
    GpuScene anew() const { return GpuScene(context_, scene_); }
    const InstanceTree& tree() { return gpuScene_->state().occlusion->instanceTree(); }

    void moveALittle(std::uint32_t count) {
        std::vector<GpuScene::NodeTransform> transforms;
        for (const std::size_t i : some(count)) {
            places_[i][3] += glm::vec4(0.05f * number(), 0.05f * number(), 0.05f * number(), 0.0f);
            transforms.push_back(set(i));
        }
        gpuScene_->setTransforms(transforms);
    }
    void moveAnywhere(std::uint32_t count) {
        std::vector<GpuScene::NodeTransform> transforms;
        for (const std::size_t i : some(count)) {
            places_[i] = place();
            transforms.push_back(set(i));
        }
        gpuScene_->setTransforms(transforms);
    }
    void replace(std::uint32_t count) {
        for (const std::size_t i : some(count)) {
            gpuScene_->removeNode(nodes_[i]);
            const Node added = node();
            const NodeHandle handle = gpuScene_->addNode(added);
            ASSERT_EQ(handle.index, nodes_[i].index);
            nodes_[i] = handle;
            places_[i] = std::get<glm::mat4>(added.transform);
            scene_.nodes[handle.index] = added;
        }
    }
    void hideOrShow(std::uint32_t count) {
        for (const std::size_t i : some(count)) {
            Node& changed = scene_.nodes[nodes_[i].index];
            changed.visible = !changed.visible;
            gpuScene_->setVisibility(
                nodes_[i], changed.visible ? GpuScene::Visibility::shown : GpuScene::Visibility::hidden);
        }
    }
    void bendAMesh() {
        const std::uint32_t mesh = 1 + random_() % 3;
        for (glm::vec3& position : scene_.meshes[mesh].positions) position *= 0.9f + 0.2f * random_.unit();
        gpuScene_->setPositions(mesh, scene_.meshes[mesh].positions);
    }

  private:
    float number() { return 2.0f * random_.unit() - 1.0f; }
    glm::mat4 place() {
        const glm::mat4 moved =
            glm::translate(glm::mat4(1.0f), {7.0f * number(), 1.2f + number(), 7.0f * number()});
        return glm::scale(glm::rotate(moved, 3.0f * number(), {0.6f, 0.0f, 0.8f}),
                          glm::vec3(0.2f + 0.15f * number()));
    }
    Node node() {
        Node made;
        made.mesh = 1 + random_() % 3;
        made.transform = place();
        made.castsShadow = random_() % 8 != 0;
        return made;
    }
    /// Different ones.
    std::vector<std::size_t> some(std::uint32_t count) {
        std::vector<std::size_t> chosen;
        const std::size_t first = random_() % nodes_.size();
        // 37 has no factor in common with the numbers of nodes.
        for (std::size_t i = 0; i < count; ++i) chosen.push_back((first + 37 * i) % nodes_.size());
        return chosen;
    }
    GpuScene::NodeTransform set(std::size_t i) {
        scene_.nodes[nodes_[i].index].transform = places_[i];
        return {nodes_[i], places_[i]};
    }

    const Context& context_;
    Random random_;
    Scene scene_;
    std::optional<GpuScene> gpuScene_;
    std::vector<NodeHandle> nodes_;
    std::vector<glm::mat4> places_;
};

struct Form {
    const char* name;
    Technique technique;
    TileBackend backend;
};

constexpr Form forms[] = {{"tiles", Technique::tiles, TileBackend::automatic},
                          {"fullscreen", Technique::fullscreen, TileBackend::automatic},
                          {"compute", Technique::tiles, TileBackend::compute}};

FrameRequest requestOf(const Form& form) {
    FrameRequest request{56, 42, camera};
    request.technique = form.technique;
    request.tileBackend = form.backend;
    request.shadows = Shadows::on;
    return request;
}

TEST_F(LiveInstancesTest, SmallMovesAndJumpsLeaveThePictureOfASceneMadeAnew) {
    constexpr std::uint32_t count = 305;
    for (const Form& form : forms) {
        SCOPED_TRACE(form.name);
        Swarm swarm(context(), 3, count);
        const FrameRequest request = requestOf(form);
        const auto expectSame = [&](const char* what) {
            const HdrImage live = drawn(swarm.onDevice(), request);
            GpuScene anew = swarm.anew();
            ASSERT_EQ(live.rgba, drawn(anew, request).rgba) << what;
        };
        expectSame("as uploaded");
        ASSERT_EQ(swarm.tree().builds(), 1u);
        for (int step = 0; step < 6; ++step) {
            swarm.moveALittle(10);
            expectSame("few have moved a little");
            swarm.moveAnywhere(5);
            expectSame("few have moved anywhere");
            swarm.replace(3);
            expectSame("few are others");
            swarm.hideOrShow(4);
            expectSame("few are hidden or shown");
        }
        EXPECT_EQ(swarm.tree().builds(), 1u) << "adapted, not built anew";
        swarm.bendAMesh();
        expectSame("a mesh has other positions");
        swarm.moveALittle(count - 1);
        expectSame("all have moved a little");
        const std::uint64_t builds = swarm.tree().builds();
        swarm.moveAnywhere(count - 1);
        expectSame("all have moved anywhere");
        EXPECT_EQ(swarm.tree().builds(), builds + 1);
    }
}

TEST_F(LiveInstancesTest, RandomEditsLeaveThePictureOfASceneMadeAnew) {
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        Swarm swarm(context(), 10 + seed, 50 * seed + 3);
        Random random(seed);
        const Form& form = forms[seed % std::size(forms)];
        const FrameRequest request = requestOf(form);
        for (int step = 0; step < 8; ++step) {
            // Pictures in between, so that the tree is adapted to each edit by itself at times.
            for (int i = 0; i < 4; ++i) {
                const std::uint32_t share = 1 + random() % (12 * seed);
                switch (random() % 6) {
                    case 0:
                        swarm.moveAnywhere(share);
                        break;
                    case 1:
                        swarm.replace(share);
                        break;
                    case 2:
                        swarm.hideOrShow(share);
                        break;
                    case 3:
                        swarm.bendAMesh();
                        break;
                    default:
                        swarm.moveALittle(share);
                }
                if (random() % 2 == 0) drawn(swarm.onDevice(), request);
            }
            const HdrImage live = drawn(swarm.onDevice(), request);
            GpuScene anew = swarm.anew();
            ASSERT_EQ(live.rgba, drawn(anew, request).rgba)
                << form.name << ", seed " << seed << ", step " << step;
        }
    }
}

}  // namespace
}  // namespace candela::test
