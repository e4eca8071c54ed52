#include "panels/scene_tree.h"
#include "panels/panel_values.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using Branch = SceneTree::Branch;

/// Nodes by their parents; -1 is none.
std::vector<candela::Node> nodesOf(const std::vector<int>& parents) {
    std::vector<candela::Node> nodes(parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] >= 0) nodes[i].parent = static_cast<std::uint32_t>(parents[i]);
    return nodes;
}

/// The rows, each as its node index after one dot per level.
std::string linesOf(const SceneTree& tree) {
    std::string text;
    for (const SceneTree::Row& row : tree.rows())
        text += std::string(row.depth, '.') + std::to_string(row.node) + " ";
    return text;
}

// 0 has the children 1 and 3, 1 has 2; 4 has 5.
const std::vector<candela::Node> twoTrees = nodesOf({-1, 0, 1, 0, -1, 4});

TEST(SceneTree, ShowsOnlyRootsWhenTheyExceedTheLimit) {
    EXPECT_EQ(linesOf(SceneTree(twoTrees, 2)), "0 4 ");
    EXPECT_EQ(linesOf(SceneTree({}, 2)), "");
}

TEST(SceneTree, OpensBranchesUpToTheLimit) {
    EXPECT_EQ(linesOf(SceneTree(twoTrees, 5)), "0 .1 .3 4 .5 ");
    EXPECT_EQ(linesOf(SceneTree(twoTrees, 100)), "0 .1 ..2 .3 4 .5 ");
}

TEST(SceneTree, OpensAndClosesBranches) {
    SceneTree tree(twoTrees, 2);
    tree.set(0, Branch::open);
    EXPECT_EQ(linesOf(tree), "0 .1 .3 4 ");
    tree.setAll(0, Branch::open);
    EXPECT_EQ(linesOf(tree), "0 .1 ..2 .3 4 ");
    tree.set(0, Branch::closed);
    EXPECT_EQ(linesOf(tree), "0 4 ");
}

TEST(SceneTree, RevealsANodeAndReturnsItsRow) {
    SceneTree tree(twoTrees, 2);
    EXPECT_EQ(tree.reveal(2), 2u);
    EXPECT_EQ(linesOf(tree), "0 .1 ..2 .3 4 ");
    EXPECT_EQ(tree.reveal(4), 4u);
}

TEST(SceneTree, ListsTheSubtreeOfANode) {
    const SceneTree tree(twoTrees, 2);
    EXPECT_EQ(tree.subtree(0), (std::vector<std::uint32_t>{0, 1, 3, 2}));
    EXPECT_TRUE(tree.hasChildren(4));
    EXPECT_FALSE(tree.hasChildren(5));
}

TEST(SceneTree, SupportsALongChainOfNodes) {
    constexpr int count = 100'000;
    std::vector<int> parents(count);
    for (int i = 0; i < count; ++i) parents[static_cast<std::size_t>(i)] = i - 1;
    SceneTree tree(nodesOf(parents), 10);
    EXPECT_EQ(tree.rows().size(), 10u);
    EXPECT_EQ(tree.reveal(count - 1), static_cast<std::size_t>(count - 1));
    EXPECT_EQ(tree.rows().back().depth, static_cast<std::uint32_t>(count - 1));
}

TEST(SceneFacts, NameTheObjectsOfANode) {
    candela::Scene scene;
    scene.nodes.resize(3);
    scene.nodes[0].mesh = 0;
    scene.lights.resize(3);
    scene.lights[0].node = 0;
    scene.lights[1].node = 0;
    scene.cameras.resize(1);
    scene.cameras[0].node = 1;
    EXPECT_EQ(kindsOfNodes(scene), (std::vector<std::string>{"mesh, light", "camera", ""}));
}

TEST(SceneFacts, ListEachMaterialOfANodeOnce) {
    candela::Scene scene;
    scene.materials.resize(5);
    scene.meshes.resize(1);
    for (const std::uint32_t material : {3u, 1u, 3u}) scene.meshes[0].submeshes.push_back({0, 3, material});
    scene.meshes[0].submeshes.push_back({});
    scene.cages.resize(1);
    scene.cages[0].faceMaterials = {1, std::nullopt, 4};
    scene.nodes.resize(2);
    scene.nodes[0].mesh = 0;
    scene.nodes[0].cage = 0;
    EXPECT_EQ(materialsOfNode(scene, 0), (std::vector<std::uint32_t>{3, 1, 4}));
    EXPECT_TRUE(materialsOfNode(scene, 1).empty());
}

}  // namespace
