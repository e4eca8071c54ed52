// What the host accepts and refuses of what deforms meshes.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>

namespace candela {
namespace {

constexpr std::array<std::uint32_t, 8> joints{0, 1, 0, 1, 0, 1, 0, 1};
constexpr std::array<float, 8> weights{1, 0, 1, 3, 2, 2, 0, 5};
constexpr std::array<float, 24> offsets{1, 2, 3};
constexpr std::array<float, 24> normalOffsets{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f};
constexpr std::array<float, 2> morphWeights{0.25f, 0.5f};

/// The square of the samples with two influences a vertex and two morph targets.
candela_mesh deformedMesh() {
    candela_mesh mesh = samples::mesh();
    mesh.influence_count = 2;
    mesh.joints = joints.data();
    mesh.joint_weights = weights.data();
    mesh.morph_target_count = 2;
    mesh.morph_offsets = offsets.data();
    mesh.morph_normals = normalOffsets.data();
    return mesh;
}

/// Two joints, their skin, and node 2 with the mesh.
void addRequiredElements(const candela_host& host, const candela_mesh& mesh = deformedMesh()) {
    add(host, samples::node());
    add(host, samples::node());
    add(host, samples::skin());
    add(host, mesh);
    add(host, modified(samples::node(), [](candela_node& n) { n.mesh = 0; }));
}

candela_deformation deformation() {
    candela_deformation deformation{};
    deformation.struct_size = sizeof deformation;
    deformation.node = 2;
    deformation.morph_weight_count = 2;
    deformation.morph_weights = morphWeights.data();
    return deformation;
}

void addDeformation(const candela_host& host, const candela_deformation& source) {
    host.add_deformation(host.self, &source);
}

void expectRefused(const std::function<void(const candela_host&)>& addElements, const std::string& text) {
    EXPECT_EQ(expectError([&] { importedScene(addElements); }, ErrorKind::badInput, ""), "test: " + text);
}

void expectDeformationRefused(const std::function<void(candela_deformation&)>& modify,
                              const std::string& text) {
    expectRefused(
        [&](const candela_host& host) {
            addRequiredElements(host);
            addDeformation(host, modified(deformation(), modify));
        },
        text);
}

TEST(HostDeformation, CopiesWhatIsAdded) {
    const Scene scene = importedScene([](const candela_host& host) {
        addRequiredElements(host);
        addDeformation(host, deformation());
    });
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.influenceCount, 2u);
    EXPECT_EQ(mesh.joints, std::vector<std::uint32_t>(joints.begin(), joints.end()));
    EXPECT_EQ(mesh.jointWeights, (std::vector<float>{1, 0, 0.25f, 0.75f, 0.5f, 0.5f, 0, 1}));
    ASSERT_EQ(mesh.morphTargets.size(), 2u);
    EXPECT_EQ(mesh.morphTargets[0].offsets[0], glm::vec3(1, 2, 3));
    EXPECT_EQ(mesh.morphTargets[1].normalOffsets[0], glm::vec3(0, 0, 0.5f));
    EXPECT_TRUE(mesh.morphTargets[0].tangentOffsets.empty()) << "NULL";
    const Node& node = scene.nodes.at(2);
    EXPECT_EQ(node.skin, 0u);
    EXPECT_EQ(node.morphWeights, (std::vector<float>{0.25f, 0.5f}));
}

TEST(HostDeformation, IsOptional) {
    const Scene scene = importedScene([](const candela_host& host) {
        addRequiredElements(host, samples::mesh());
        addDeformation(host, modified(deformation(), [](candela_deformation& d) {
                           d.skin = -1;
                           d.morph_weight_count = 0;
                       }));
    });
    EXPECT_FALSE(scene.nodes.at(2).skin);
    EXPECT_TRUE(scene.nodes.at(2).morphWeights.empty());
}

// Plugins that were built for 1.0 and for 1.1 and 1.2.
TEST(HostDeformation, MeshesOfOlderVersionsHaveNone) {
    for (const std::size_t size :
         {offsetof(candela_mesh, face_count), offsetof(candela_mesh, influence_count)}) {
        const Scene scene = importedScene([&](const candela_host& host) {
            add(host, modified(deformedMesh(),
                               [&](candela_mesh& m) { m.struct_size = static_cast<std::uint32_t>(size); }));
        });
        EXPECT_EQ(scene.meshes.at(0).influenceCount, 0u);
        EXPECT_TRUE(scene.meshes.at(0).morphTargets.empty());
    }
}

TEST(HostDeformation, OfAMeshThatIsRefused) {
    const auto expectMeshRefused = [](const std::function<void(candela_mesh&)>& modify,
                                      const std::string& text) {
        expectRefused([&](const candela_host& host) { add(host, modified(deformedMesh(), modify)); },
                      "mesh 0 'wheel': " + text);
    };
    expectMeshRefused([](candela_mesh& m) { m.joints = nullptr; },
                      "joints is NULL, but 8 elements were expected");
    expectMeshRefused([](candela_mesh& m) { m.morph_offsets = nullptr; },
                      "morph_offsets is NULL, but morph_target_count is 2");
    constexpr std::array<float, 8> negative{1, 0, -1, 2, 1, 1, 1, 1}, none{};
    expectMeshRefused([&](candela_mesh& m) { m.joint_weights = negative.data(); },
                      "vertex 1 has the joint weight -1, but 0 or more was expected");
    expectMeshRefused([&](candela_mesh& m) { m.joint_weights = none.data(); },
                      "vertex 0 has joint weights that are all 0");
}

TEST(HostDeformationRefuses, AndNamesTheNode) {
    expectDeformationRefused([](candela_deformation& d) { d.node = -1; },
                             "add_deformation: node is -1, but a node was expected");
    expectDeformationRefused([](candela_deformation& d) { d.node = 0; },
                             "node 0 'axle': it has no mesh to deform");
    expectDeformationRefused([](candela_deformation& d) { d.skin = 1; },
                             "node 2 'axle': skin is 1, but 1 were added so far and -1 is none");
    expectDeformationRefused(
        [](candela_deformation& d) { d.morph_weight_count = 1; },
        "node 2 'axle': morph_weight_count is 1, but mesh 0 'wheel' has 2 morph targets");
    expectDeformationRefused([](candela_deformation& d) { d.struct_size = 8; },
                             "add_deformation: struct_size is 8, but version 1.3 has 24 bytes");
    expectRefused(
        [](const candela_host& host) {
            addRequiredElements(host);
            addDeformation(host, deformation());
            addDeformation(host, deformation());
        },
        "node 2 'axle': it has a skin or morph weights already, and can not have others");
}

}  // namespace
}  // namespace candela
