// Cages that are added, removed and replaced while the scene is on the device.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/random_elements.h"

#include <candela/error.h>

#include <algorithm>
#include <map>
#include <string>

namespace candela::test {
namespace {

const CameraView camera = lookAt({2.5f, 3.0f, 6}, {0, 0, 0}, 0.8f);

FrameRequest shown(Technique technique) {
    FrameRequest request{48, 36, camera};
    request.technique = technique;
    request.shadows = Shadows::on;
    return request;
}

Cage randomCage(Random& random) {
    const float size = 0.2f + 0.4f * random.unit();
    Cage cage = random() % 3 == 0   ? makeSharpCubeCage(size)
                : random() % 2 == 0 ? makeSheetCage(size, 3)
                                    : makeCubeCage(size);
    const std::uint32_t material = random() % 3;
    cage.faceMaterials.assign(cage.faceSizes.size(), material < 2 ? std::optional(material) : std::nullopt);
    return cage;
}

/// A scene of cages as values and on the device, which get the same edits.
class LiveCages {
  public:
    LiveCages(const Context& context, std::uint32_t seed) : context_(context), random_(seed) {
        for (int i = 0; i < 2; ++i) scene_.materials.push_back(randomMaterial(random_, std::nullopt));
        for (std::uint32_t i = 0; i < 2; ++i) {
            scene_.cages.push_back(randomCage(random_));
            cages_.emplace_back(i);
            Node& node = scene_.nodes.emplace_back();
            node.cage = i;
            node.transform = randomPlace(random_);
            nodes_.emplace_back(i);
        }
        for (int i = 0; i < 3; ++i) scene_.lights.push_back(randomLight(random_, std::nullopt));
        gpuScene_.emplace(context, scene_, subdividing(2));
    }

    GpuScene& onDevice() { return *gpuScene_; }
    GpuScene anew() const {
        GpuScene scene(context_, scene_, subdividing(2));
        for (const auto& [node, points] : points_) scene.setCagePoints(node, points);
        return scene;
    }

    void edit() {
        switch (random_() % 7) {
            case 0:
                return addNode();
            case 1:
                return removeNode();
            case 2:
                return addCage();
            case 3:
                return replaceCage();
            case 4:
                return removeCage();
            case 5:
                return setPoints();
            default:
                return moveNode();
        }
    }

  private:
    template <typename Handles>
    auto anyOf(const Handles& handles) {
        return handles[random_() % handles.size()];
    }
    void addNode() {
        Node node;
        node.cage = anyOf(cages_).index;
        node.transform = randomPlace(random_);
        node.visible = random_() % 5 != 0;
        const NodeHandle handle = gpuScene_->addNode(node);
        if (handle.index >= scene_.nodes.size()) scene_.nodes.resize(handle.index + 1);
        scene_.nodes[handle.index] = node;
        nodes_.push_back(handle);
    }
    void removeNode() {
        if (nodes_.size() < 2) return;
        const NodeHandle handle = anyOf(nodes_);
        gpuScene_->removeNode(handle);
        scene_.nodes[handle.index] = {};
        points_.erase(handle.index);
        std::erase(nodes_, handle);
    }
    void addCage() {
        const Cage cage = randomCage(random_);
        const CageHandle handle = gpuScene_->addCage(cage);
        if (handle.index >= scene_.cages.size()) scene_.cages.resize(handle.index + 1);
        scene_.cages[handle.index] = cage;
        cages_.push_back(handle);
    }
    void replaceCage() {
        const CageHandle handle = anyOf(cages_);
        const Cage cage = randomCage(random_);
        gpuScene_->replaceCage(handle, cage);
        scene_.cages[handle.index] = cage;
        std::erase_if(points_,
                      [&](const auto& entry) { return scene_.nodes[entry.first].cage == handle.index; });
    }
    void removeCage() {
        const CageHandle handle = anyOf(cages_);
        const bool isShown =
            std::ranges::any_of(scene_.nodes, [&](const Node& node) { return node.cage == handle.index; });
        if (isShown || cages_.size() < 2) {
            if (isShown) {
                EXPECT_THROW(gpuScene_->removeCage(handle), Error);
            }
            return;
        }
        gpuScene_->removeCage(handle);
        EXPECT_THROW(gpuScene_->replaceCage(handle, randomCage(random_)), Error) << "stale";
        // The values keep the cage, which no node shows.
        std::erase(cages_, handle);
    }
    void setPoints() {
        const NodeHandle handle = anyOf(nodes_);
        const std::uint32_t cage = *scene_.nodes[handle.index].cage;
        points_[handle.index] = jittered(scene_.cages[cage].positions, 0.1f, random_() % 100);
        gpuScene_->setCagePoints(handle, points_[handle.index]);
    }
    void moveNode() {
        const NodeHandle handle = anyOf(nodes_);
        const glm::mat4 place = randomPlace(random_);
        gpuScene_->setTransform(handle, place);
        scene_.nodes[handle.index].transform = place;
    }

    const Context& context_;
    Random random_;
    Scene scene_;
    std::map<std::uint32_t, std::vector<glm::vec3>> points_;  ///< Set by `setCagePoints`, by node.
    std::optional<GpuScene> gpuScene_;
    std::vector<NodeHandle> nodes_;
    std::vector<CageHandle> cages_;
};

class LiveCageTest : public DrawingTest {};

TEST_F(LiveCageTest, AnyEditsLeaveThePictureOfASceneMadeAnew) {
    const Technique techniques[] = {Technique::tiles, Technique::volumes, Technique::fullscreen};
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        LiveCages scene(context(), seed);
        for (std::uint32_t step = 0; step < 6; ++step) {
            for (int i = 0; i < 5; ++i) scene.edit();
            GpuScene anew = scene.anew();
            const FrameRequest request = shown(techniques[(seed + step) % std::size(techniques)]);
            ASSERT_EQ(drawn(scene.onDevice(), request).rgba, drawn(anew, request).rgba)
                << "seed " << seed << ", step " << step;
            EXPECT_EQ(scene.onDevice().cageReport().cages, anew.cageReport().cages);
            EXPECT_EQ(scene.onDevice().cageReport().triangles, anew.cageReport().triangles);
        }
    }
}

TEST_F(LiveCageTest, ARejectedCageChangesNothing) {
    Scene scene;
    placeCage(scene, makeCubeCage(0.8f), Material{});
    scene.lights.emplace_back().position = {2, 3, 4};
    GpuScene live(context(), scene, subdividing(2));
    const HdrImage before = drawn(live, shown(Technique::tiles));
    Cage broken = makeCubeCage(0.5f);
    broken.faceVertices[0] = 99;
    EXPECT_THROW(live.addCage(broken), Error);
    EXPECT_THROW(live.replaceCage(0, broken), Error);
    Node node;
    node.cage = 1;
    EXPECT_THROW(live.addNode(node), Error);
    EXPECT_EQ(drawn(live, shown(Technique::tiles)).rgba, before.rgba);
}

}  // namespace
}  // namespace candela::test
