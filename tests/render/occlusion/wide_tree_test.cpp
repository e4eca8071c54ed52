#include "render/occlusion/wide_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace candela {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.push_back({first, first + 1, first + 2});
    }
    TriangleSpan span() const { return {positions, triangles}; }
};

class Random {
  public:
    float number() { return uniform_(engine_); }
    glm::vec3 vector() { return {number(), number(), number()}; }

  private:
    std::mt19937 engine_{11};
    std::uniform_real_distribution<float> uniform_{-1.0f, 1.0f};
};

Triangles randomTriangles(std::size_t count, float extent, float size) {
    Random random;
    Triangles mesh;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 center = random.vector() * extent;
        mesh.add(center + random.vector() * size, center + random.vector() * size,
                 center + random.vector() * size);
    }
    return mesh;
}

std::vector<Bounds> boxesOf(const Triangles& mesh) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) boxes.push_back(mesh.span().bounds(i));
    return boxes;
}

bool equal(const Bounds& a, const Bounds& b) {
    return a.min == b.min && a.max == b.max;
}

/// The union of what is below a child; counts nodes, leaves and primitives on the way.
class Walk {
  public:
    Walk(const WideTree& tree, std::span<const Bounds> boxes)
        : seen(boxes.size()),
          nodeSeen(tree.nodes.size()),
          leafSeen(tree.leaves.size()),
          tree_(tree),
          boxes_(boxes) {}

    Bounds node(std::uint32_t index, unsigned depth) {
        deepest = std::max(deepest, depth);
        ++nodeSeen[index];
        Bounds all;
        bool ended = false;
        for (unsigned lane = 0; lane < WideNode::width; ++lane) {
            const WideNode& node = tree_.nodes[index];
            const std::uint32_t child = node.child[lane];
            if (child == WideNode::noChild) {
                ended = true;
                EXPECT_GT(node.minX[lane], node.maxX[lane]);
                EXPECT_GT(node.minY[lane], node.maxY[lane]);
                EXPECT_GT(node.minZ[lane], node.maxZ[lane]);
                continue;
            }
            EXPECT_FALSE(ended) << "a child after a missing one";
            EXPECT_GT(child, index) << "a child before its parent";
            const Bounds own =
                isLeaf(child) ? leaf(child & ~WideNode::leafFlag) : this->node(child, depth + 1);
            EXPECT_TRUE(equal(own, childBounds(node, lane))) << "node " << index << " lane " << lane;
            all.add(own);
        }
        return all;
    }

    std::vector<int> seen, nodeSeen, leafSeen;
    unsigned deepest = 0;

  private:
    Bounds leaf(std::uint32_t index) {
        ++leafSeen[index];
        const WideTree::Leaf& leaf = tree_.leaves[index];
        EXPECT_GE(leaf.count, 1u);
        EXPECT_LE(leaf.count, WideNode::width);
        Bounds all;
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            ++seen[tree_.primitives[i]];
            all.add(boxes_[tree_.primitives[i]]);
        }
        return all;
    }

    const WideTree& tree_;
    std::span<const Bounds> boxes_;
};

/// Each box in exactly one leaf, and each child's box exactly what is below it. `leftOut` boxes are in none.
void expectWhole(const WideTree& tree, std::span<const Bounds> boxes,
                 std::span<const std::size_t> leftOut = {}) {
    ASSERT_FALSE(tree.empty());
    Walk walk(tree, boxes);
    const Bounds all = walk.node(0, 1);
    EXPECT_TRUE(equal(all, tree.bounds));
    EXPECT_EQ(walk.deepest, tree.depth);
    std::vector<int> expected(boxes.size(), 1);
    for (const std::size_t index : leftOut) expected[index] = 0;
    EXPECT_EQ(walk.seen, expected);
    EXPECT_EQ(walk.nodeSeen, std::vector<int>(tree.nodes.size(), 1));
    EXPECT_EQ(walk.leafSeen, std::vector<int>(tree.leaves.size(), 1));
}

TEST(WideTree, EveryTriangleIsInOneLeafAndBoxesAreExact) {
    for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 64u, 65u, 1000u, 20000u}) {
        SCOPED_TRACE(count);
        const Triangles mesh = randomTriangles(count, 100.0f, 1.0f);
        expectWhole(buildWideTree(mesh.span()), boxesOf(mesh));
    }
}

TEST(WideTree, LeavesHoldAtMostWhatIsAskedFor) {
    const std::vector<Bounds> boxes = boxesOf(randomTriangles(3000, 10.0f, 2.0f));
    for (unsigned maxLeaf = 1; maxLeaf <= 8; ++maxLeaf) {
        SCOPED_TRACE(maxLeaf);
        const WideTree tree = buildWideTree(boxes, maxLeaf);
        expectWhole(tree, boxes);
        for (const WideTree::Leaf& leaf : tree.leaves) ASSERT_LE(leaf.count, maxLeaf);
    }
}

TEST(WideTree, NothingGivesAnEmptyTree) {
    WideTree tree = buildWideTree(TriangleSpan{});
    EXPECT_TRUE(tree.empty());
    EXPECT_TRUE(tree.bounds.empty());
    refit(tree, TriangleSpan{});
    EXPECT_TRUE(tree.empty());
    std::vector<TriangleBlock> blocks(3);
    fillTriangleBlocks(tree, {}, blocks);
    EXPECT_TRUE(blocks.empty());
    const std::vector<Bounds> none(5);
    EXPECT_TRUE(buildWideTree(none, 1).empty());
}

TEST(WideTree, EqualTrianglesBuildATreeOfBoundedDepth) {
    Triangles mesh;
    for (int i = 0; i < 20000; ++i) mesh.add({1, 2, 3}, {2, 2, 3}, {1, 3, 3});
    const WideTree tree = buildWideTree(mesh.span());
    expectWhole(tree, boxesOf(mesh));
    EXPECT_LE(tree.depth, WideTree::maxDepth);
}

TEST(WideTree, TrianglesWithoutAreaAreKept) {
    Random random;
    Triangles mesh;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 a = random.vector(), b = random.vector();
        mesh.add(a, a, a);
        mesh.add(a, b, a);
        mesh.add(a, 0.5f * (a + b), b);
    }
    expectWhole(buildWideTree(mesh.span()), boxesOf(mesh));
}

TEST(WideTree, ExtentsOfAnySizeAreTaken) {
    Random random;
    Triangles mesh;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 center = random.vector() * std::pow(10.0f, 18.0f * random.number());
        const float size = std::pow(10.0f, 18.0f * random.number());
        mesh.add(center, center + random.vector() * size, center + random.vector() * size);
    }
    expectWhole(buildWideTree(mesh.span()), boxesOf(mesh));
}

TEST(WideTree, WhatIsEmptyOrNotFiniteIsLeftOut) {
    Triangles mesh = randomTriangles(100, 10.0f, 1.0f);
    mesh.positions[3 * 7].y = nan;
    mesh.positions[3 * 50 + 1].x = infinity;
    mesh.positions[3 * 99 + 2].z = -infinity;
    std::vector<std::size_t> leftOut = {7, 50, 99};
    expectWhole(buildWideTree(mesh.span()), boxesOf(mesh), leftOut);
    std::vector<Bounds> boxes = boxesOf(mesh);
    boxes[0] = Bounds{};
    boxes[1].max.y = nan;
    leftOut.insert(leftOut.end(), {0, 1});
    expectWhole(buildWideTree(boxes, 1), boxes, leftOut);
}

TEST(WideTree, RefitGivesTheBoxesOfWhatHasMoved) {
    Triangles mesh = randomTriangles(5000, 10.0f, 1.0f);
    WideTree tree = buildWideTree(mesh.span());
    const WideTree before = tree;
    Random random;
    for (glm::vec3& position : mesh.positions) position = position * 2.0f + random.vector();
    refit(tree, mesh.span());
    expectWhole(tree, boxesOf(mesh));
    EXPECT_EQ(tree.primitives, before.primitives);
    const std::vector<Bounds> boxes = boxesOf(mesh);
    WideTree ofBoxes = before;
    refit(ofBoxes, boxes);
    expectWhole(ofBoxes, boxes);
}

TEST(WideTree, RefitOfWhatHasNotMovedChangesNothing) {
    const Triangles mesh = randomTriangles(5000, 10.0f, 1.0f);
    const WideTree before = buildWideTree(mesh.span());
    WideTree tree = before;
    refit(tree, mesh.span());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        for (unsigned lane = 0; lane < WideNode::width; ++lane) {
            ASSERT_EQ(tree.nodes[i].child[lane], before.nodes[i].child[lane]);
            ASSERT_TRUE(equal(childBounds(tree.nodes[i], lane), childBounds(before.nodes[i], lane)));
        }
    }
}

TEST(WideTree, BlocksHoldTheTrianglesOfTheirLeaves) {
    const Triangles mesh = randomTriangles(3001, 10.0f, 1.0f);
    const WideTree tree = buildWideTree(mesh.span());
    std::vector<TriangleBlock> blocks;
    fillTriangleBlocks(tree, mesh.span(), blocks);
    ASSERT_EQ(blocks.size(), tree.leaves.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const WideTree::Leaf& leaf = tree.leaves[i];
        for (std::uint32_t lane = 0; lane < TriangleBlock::width; ++lane) {
            const std::uint32_t triangle = tree.primitives[leaf.first + (lane < leaf.count ? lane : 0)];
            ASSERT_EQ(blocks[i].triangle[lane], triangle);
            for (int corner = 0; corner < 3; ++corner) {
                const glm::vec3 position(blocks[i].x[corner][lane], blocks[i].y[corner][lane],
                                         blocks[i].z[corner][lane]);
                ASSERT_EQ(position, mesh.positions[mesh.triangles[triangle][corner]]);
            }
        }
    }
}

}  // namespace
}  // namespace candela
