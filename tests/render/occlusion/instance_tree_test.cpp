#include "render/occlusion/instance_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace candela {
namespace {

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float number() { return uniform_(engine_); }
    glm::vec3 vector() { return {number(), number(), number()}; }
    std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(engine_() % count); }

  private:
    std::mt19937 engine_;
    std::uniform_real_distribution<float> uniform_{-1.0f, 1.0f};
};

constexpr float extent = 100.0f;

Bounds boxAround(const glm::vec3& center, float half) {
    return {center - half, center + half};
}

/// Boxes, the tree over them, and what a copy of its nodes that follows `takeChanges` holds.
class Boxes {
  public:
    Boxes(std::size_t count, unsigned seed) : random(seed) {
        for (std::size_t i = 0; i < count; ++i) set(static_cast<std::uint32_t>(i), anywhere());
        update();
    }

    Bounds anywhere() { return boxAround(extent * random.vector(), 0.5f + 0.4f * random.number()); }
    void set(std::uint32_t instance, const Bounds& box) {
        if (instance < boxes.size())
            std::erase_if(changes_, [&](const auto& change) { return change.instance == instance; });
        else
            boxes.resize(instance + 1);
        boxes[instance] = box;
        changes_.push_back({instance, box});
    }
    void move(std::uint32_t instance, const glm::vec3& way) {
        set(instance, {boxes[instance].min + way, boxes[instance].max + way});
    }
    void update() {
        tree.update(changes_);
        changes_.clear();
    }
    /// Writes what has changed into the copy. Returns how many nodes those are.
    std::size_t follow() {
        const InstanceTree::Changes changes = tree.takeChanges();
        const std::span<const WideNode> nodes = tree.nodes();
        if (changes.all) copy.assign(nodes.begin(), nodes.end());
        copy.resize(nodes.size());
        for (const std::uint32_t node : changes.nodes) copy[node] = nodes[node];
        return changes.all ? nodes.size() : changes.nodes.size();
    }

    Random random;
    std::vector<Bounds> boxes;
    InstanceTree tree;
    std::vector<WideNode> copy;

  private:
    std::vector<InstanceTree::Change> changes_;
};

/// What is below a node.
struct Walk {
    explicit Walk(const Boxes& scene) : boxes(scene.boxes), nodes(scene.copy), seen(boxes.size()) {}

    Bounds node(std::uint32_t index, unsigned depth) {
        deepest = std::max(deepest, depth);
        Bounds all;
        bool ended = false;
        for (unsigned lane = 0; lane < WideNode::width; ++lane) {
            const WideNode& node = nodes[index];
            const std::uint32_t child = node.child[lane];
            if (child == WideNode::noChild) {
                ended = true;
                EXPECT_GT(node.minX[lane], node.maxX[lane]);
                continue;
            }
            EXPECT_FALSE(ended) << "a child after a missing one";
            const Bounds own = childBounds(node, lane);
            Bounds below;
            if (isLeaf(child)) {
                ++seen[child & ~WideNode::leafFlag];
                below = boxes[child & ~WideNode::leafFlag];
            } else {
                EXPECT_GT(child, index) << "a child before its parent";
                const glm::dvec3 size = glm::dvec3(own.max) - glm::dvec3(own.min);
                cost += size.x * size.y + size.y * size.z + size.z * size.x;
                below = this->node(child, depth + 1);
            }
            EXPECT_TRUE(own.min == below.min && own.max == below.max) << "node " << index << " lane " << lane;
            all.add(own);
        }
        return all;
    }

    const std::vector<Bounds>& boxes;
    const std::vector<WideNode>& nodes;
    std::vector<int> seen;
    unsigned deepest = 0;
    double cost = 0.0;
};

/// Each box that rays may meet in exactly one leaf, and each child's box exactly what is below it.
void expectWhole(Boxes& scene) {
    scene.follow();
    std::vector<int> expected;
    for (const Bounds& box : scene.boxes) expected.push_back(isTraceable(box) ? 1 : 0);
    const auto count = static_cast<std::size_t>(std::ranges::count(expected, 1));
    ASSERT_EQ(scene.tree.size(), count);
    ASSERT_EQ(scene.tree.empty(), count == 0);
    if (count == 0) return;
    Walk walk(scene);
    walk.node(0, 1);
    EXPECT_EQ(walk.seen, expected);
    EXPECT_LE(walk.deepest, scene.tree.depth());
    EXPECT_LE(scene.tree.depth(), WideTree::maxDepth);
    // The sum is kept by differences, which round.
    EXPECT_NEAR(walk.cost, scene.tree.cost(), 1.0e-6 * walk.cost + 1.0e-6);
}

TEST(InstanceTree, AnyEditsLeaveEachBoxInOneLeafAndBoxesExact) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        Boxes scene(seed * seed * 5, seed);
        expectWhole(scene);
        for (int step = 0; step < 150; ++step) {
            SCOPED_TRACE(step);
            const std::uint32_t edits = 1 + scene.random.below(12);
            for (std::uint32_t i = 0; i < edits; ++i) {
                const std::uint32_t instance = scene.random.below(scene.boxes.size());
                switch (scene.random.below(8)) {
                    case 0:
                        scene.set(instance, scene.anywhere());
                        break;
                    case 1:
                        scene.set(instance, Bounds{});
                        break;
                    case 2:
                        scene.set(static_cast<std::uint32_t>(scene.boxes.size()), scene.anywhere());
                        break;
                    case 3:
                        scene.set(instance, boxAround(extent * scene.random.vector(),
                                                      std::exp(5.0f * scene.random.number())));
                        break;
                    default:
                        if (isTraceable(scene.boxes[instance]))
                            scene.move(instance, 0.3f * scene.random.vector());
                }
            }
            scene.update();
            expectWhole(scene);
        }
    }
}

TEST(InstanceTree, NothingIsLeftOfATreeWithoutBoxes) {
    Boxes scene(50, 3);
    for (std::uint32_t i = 0; i < 50; ++i) {
        scene.set(i, i % 2 == 0 ? Bounds{} : boxAround({std::numeric_limits<float>::quiet_NaN(), 0, 0}, 1));
        if (i % 3 == 0) scene.update();
    }
    scene.update();
    expectWhole(scene);
    scene.set(7, scene.anywhere());
    scene.update();
    expectWhole(scene);
}

TEST(InstanceTree, FewThatMoveChangeFewNodes) {
    constexpr std::size_t count = 20000;
    Boxes scene(count, 4);
    scene.follow();
    for (int step = 0; step < 20; ++step) {
        for (std::uint32_t i = 0; i < 10; ++i) scene.move(1000 * i, 0.1f * scene.random.vector());
        scene.update();
        // No more than a way to the root for each, twice where one is taken out and inserted anew.
        EXPECT_LE(scene.follow(), 2 * 10 * std::size_t{scene.tree.depth()});
    }
    expectWhole(scene);
    EXPECT_EQ(scene.tree.builds(), 1u);
}

TEST(InstanceTree, FewThatJumpAreInsertedAnew) {
    Boxes scene(20000, 5);
    for (int step = 0; step < 100; ++step) {
        for (std::uint32_t i = 0; i < 10; ++i)
            scene.set(scene.random.below(scene.boxes.size()), scene.anywhere());
        scene.update();
    }
    expectWhole(scene);
    EXPECT_EQ(scene.tree.builds(), 1u);
}

TEST(InstanceTree, OneThatMovesOnDoesNotTakeItsNodeAlong) {
    Boxes scene(20000, 6);
    const double before = scene.tree.cost();
    for (int step = 0; step < 400; ++step) {
        scene.move(77, {0.4f, 0.1f, 0.2f});
        scene.update();
    }
    expectWhole(scene);
    // One box of 20,000 adds at most a node at each level, of the size of the scene.
    EXPECT_LE(scene.tree.cost(), 1.05 * before);
}

/// A tree is never worse than the bound says against one that is built anew of the same boxes.
TEST(InstanceTree, ATreeThatHasGrownTooLargeIsBuiltAnew) {
    Boxes scene(5000, 7);
    for (int step = 0; step < 200; ++step) {
        // A swarm: each of a fifth of the boxes moves on its own way through the scene.
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const float angle = 0.01f * static_cast<float>(i);
            scene.move(5 * i, {std::cos(angle), 0.3f * std::sin(3.0f * angle), std::sin(angle)});
        }
        scene.update();
        if (step % 20 != 19) continue;
        expectWhole(scene);
        Boxes fresh(0, 1);
        for (std::uint32_t i = 0; i < scene.boxes.size(); ++i) fresh.set(i, scene.boxes[i]);
        fresh.update();
        // The boxes spread, so that a tree built anew is larger than that of the last build, never smaller.
        EXPECT_LE(scene.tree.cost(), InstanceTree::maxGrowth * fresh.tree.cost());
    }
    EXPECT_GT(scene.tree.builds(), 1u);
    EXPECT_LT(scene.tree.builds(), 100u);
}

TEST(InstanceTree, AllThatJumpBuildTheTreeAnew) {
    Boxes scene(3000, 8);
    for (std::uint32_t i = 0; i < 3000; ++i) scene.set(i, scene.anywhere());
    scene.update();
    expectWhole(scene);
    EXPECT_EQ(scene.tree.builds(), 2u);
}

TEST(InstanceTree, GrowsOneByOne) {
    Boxes scene(0, 9);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        scene.set(i, scene.anywhere());
        scene.update();
    }
    expectWhole(scene);
    // Each build doubles about what is in the tree, or what its nodes cover.
    EXPECT_LT(scene.tree.builds(), 60u);
    for (std::uint32_t i = 0; i < 2990; ++i) {
        scene.set(i, Bounds{});
        scene.update();
    }
    expectWhole(scene);
    EXPECT_LE(scene.tree.nodes().size(), 40u);
}

}  // namespace
}  // namespace candela
