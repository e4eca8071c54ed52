// The host's error for each invalid element that an importer can add.
#include "expect_error.h"
#include "note_lines.h"

#include <candela/import.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace candela {
namespace {

const PluginRegistry& fixturePlugins() {
    static const PluginRegistry plugins({std::filesystem::path(CANDELA_TEST_FIXTURES) / "importers"});
    return plugins;
}

ImportedScene add(const std::string& name, const ImportProgress& progress = {}) {
    return importScene(fixturePlugins(), "add:" + name, {Strictness::tolerant, progress});
}

struct InvalidCase {
    const char* name;
    const char* text;  // The error message after "add:CASE: ".
};

class HostRefuses : public testing::TestWithParam<InvalidCase> {};

TEST_P(HostRefuses, AndNamesTheElement) {
    const InvalidCase& invalid = GetParam();
    const std::string uri = std::string("add:") + invalid.name;
    const std::string text = expectError([&] { add(invalid.name); }, ErrorKind::badInput, "");
    EXPECT_EQ(text, uri + ": " + invalid.text);
}

std::string nameOf(const testing::TestParamInfo<InvalidCase>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

const InvalidCase invalidImages[] = {
    {"image-width-0", "image 0 'checks': width is 0, but 1 to 32768 was expected"},
    {"image-height-large", "image 0 'checks': height is 32769, but 1 to 32768 was expected"},
    {"image-format", "image 0 'checks': format is 3, but 0 to 2 was expected"},
    {"image-size", "image 0 'checks': pixels_size is 15, but 2 × 2 texels of 4 bytes make 16"},
    {"image-null", "image 0 'checks': pixels is NULL"},
    {"image-nan",
     "image 0 'checks': the texel in row 0, column 1 holds nan, but finite numbers were expected"},
};
INSTANTIATE_TEST_SUITE_P(Images, HostRefuses, testing::ValuesIn(invalidImages), nameOf);

const InvalidCase invalidMaterials[] = {
    {"material-color", "material 0 'paint': base_color is 1.5, but 0 to 1 was expected"},
    {"material-metallic", "material 0 'paint': metallic is nan, but 0 to 1 was expected"},
    {"material-roughness", "material 0 'paint': roughness is -0.1, but 0 to 1 was expected"},
    {"material-emission", "material 0 'paint': emission is inf, but a finite number was expected"},
    {"material-image",
     "material 0 'paint': normal_texture.image is 1, but 1 were added so far and -1 is none"},
    {"material-image-negative",
     "material 0 'paint': normal_texture.image is -2, but 1 were added so far and -1 is none"},
    {"material-uv-set", "material 0 'paint': emission_texture.uv_set is 18, but 0 to 17 was expected"},
    {"material-wrap", "material 0 'paint': base_color_texture.wrap_t is 3, but 0 to 2 was expected"},
    {"material-min-filter",
     "material 0 'paint': base_color_texture.min_filter is -1, but 0 to 5 was expected"},
    {"material-mag-filter",
     "material 0 'paint': base_color_texture.mag_filter is 3, but 0 to 2 was expected"},
    {"material-texture-scale",
     "material 0 'paint': base_color_texture.scale is nan, but a finite number was expected"},
    {"material-alpha-mode", "material 0 'paint': alpha_mode is 3, but 0 to 2 was expected"},
    {"material-unlit", "material 0 'paint': unlit is 7, but 0 or 1 was expected"},
};
INSTANTIATE_TEST_SUITE_P(Materials, HostRefuses, testing::ValuesIn(invalidMaterials), nameOf);

const InvalidCase invalidMeshes[] = {
    {"mesh-null", "mesh 0: the struct is NULL"},
    {"mesh-positions-null", "mesh 0 'wheel': position is NULL, but 4 elements were expected"},
    {"mesh-position-nan",
     "mesh 0 'wheel': position 2 has the component nan, but finite numbers were expected"},
    {"mesh-uv-infinite", "mesh 0 'wheel': uv1 3 has the component -inf, but finite numbers were expected"},
    {"mesh-index", "mesh 1 'wheel': index 4 is 1200, but there are 4 vertices"},
    {"mesh-index-count", "mesh 0 'wheel': index_count is 5, but a multiple of 3 was expected"},
    {"mesh-indices-null", "mesh 0 'wheel': indices is NULL, but index_count is 6"},
    {"mesh-submeshes-null", "mesh 0 'wheel': submeshes is NULL, but submesh_count is 1"},
    {"mesh-submesh-end", "mesh 0 'wheel': submesh 0 ends at index 9, but there are 6 indices"},
    {"mesh-submesh-overflow", "mesh 0 'wheel': submesh 0 ends at index 4294967298, but there are 6 indices"},
    {"mesh-submesh-count", "mesh 0 'wheel': submesh 0: index_count is 4, but a multiple of 3 was expected"},
    {"mesh-submesh-material",
     "mesh 0 'wheel': submesh 0: material is 0, but 0 were added so far and -1 is none"},
    {"mesh-name", "mesh 0 'two?lines \uFFFD': index_count is 1, but a multiple of 3 was expected"},
};
INSTANTIATE_TEST_SUITE_P(Meshes, HostRefuses, testing::ValuesIn(invalidMeshes), nameOf);

const InvalidCase invalidNodes[] = {
    {"node-parent-itself", "node 1 'axle': parent is 1, but 1 were added so far and -1 is none"},
    {"node-parent-later", "node 1 'axle': parent is 5, but 1 were added so far and -1 is none"},
    {"node-mesh", "node 1 'axle': mesh is 0, but 0 were added so far and -1 is none"},
    {"node-translation", "node 1 'axle': translation is nan, but a finite number was expected"},
    {"node-rotation", "node 1 'axle': rotation has the length 0.5, but a unit quaternion was expected"},
    {"node-matrix-projective",
     "node 1 'axle': matrix is not affine: the last number of column 2 is -1, but 0 was expected"},
    {"node-matrix-nan", "node 1 'axle': matrix 0 has the component nan, but finite numbers were expected"},
    {"node-casts-no-shadow", "node 1 'axle': casts_no_shadow is 2, but 0 or 1 was expected"},
};
INSTANTIATE_TEST_SUITE_P(Nodes, HostRefuses, testing::ValuesIn(invalidNodes), nameOf);

const InvalidCase invalidCamerasAndLights[] = {
    {"camera-fov-0", "camera 0 'front': vertical_fov is 0, but more than 0 and less than pi was expected"},
    {"camera-fov-pi", "camera 0 'front': vertical_fov is 3.2, but more than 0 and less than pi was expected"},
    {"camera-near", "camera 0 'front': near_plane is -1, but 0 or more was expected"},
    {"camera-node", "camera 0 'front': node is 0, but 0 were added so far and -1 is none"},
    {"light-type", "light 0 'lamp': type is 3, but 0 to 2 was expected"},
    {"light-color", "light 0 'lamp': color is -1, but 0 or more was expected"},
    {"light-intensity", "light 0 'lamp': intensity is nan, but a finite number was expected"},
    {"light-range", "light 0 'lamp': range is -3, but 0 or more was expected"},
    {"light-cone",
     "light 0 'lamp': inner_cone_angle is 0.5, but less than outer_cone_angle (0.5) was expected"},
    {"light-outer-cone", "light 0 'lamp': outer_cone_angle is 1.6, but 0 to 1.5708 was expected"},
    {"light-direction", "light 0 'lamp': direction has the length 0"},
    {"light-node", "light 0 'lamp': node is -7, but 0 were added so far and -1 is none"},
    {"light-casts-no-shadow", "light 0 'lamp': casts_no_shadow is 2, but 0 or 1 was expected"},
    {"light-radius", "light 0 'lamp': radius is -0.5, but 0 or more was expected"},
    {"light-radius-nan", "light 0 'lamp': radius is nan, but a finite number was expected"},
};
INSTANTIATE_TEST_SUITE_P(Views, HostRefuses, testing::ValuesIn(invalidCamerasAndLights), nameOf);

const InvalidCase invalidAnimations[] = {
    {"animation-channels-null", "animation 0 'roll': channels is NULL, but channel_count is 1"},
    {"channel-node", "animation 0 'roll': channel 0: node is 2, but 2 were added so far and -1 is none"},
    {"channel-no-node", "animation 0 'roll': channel 0: node is -1, but a node was expected"},
    {"channel-matrix-node",
     "animation 0 'roll': channel 0: node is 1, whose transform is a matrix, which cannot be animated"},
    {"channel-path", "animation 0 'roll': channel 0: path is 4, but 0 to 3 was expected"},
    {"channel-interpolation", "animation 0 'roll': channel 0: interpolation is 9, but 0 to 2 was expected"},
    {"channel-no-keys", "animation 0 'roll': channel 0: key_count is 0, but 1 or more was expected"},
    {"channel-times-null", "animation 0 'roll': channel 0: time is NULL, but 2 elements were expected"},
    {"channel-times-equal",
     "animation 0 'roll': channel 0: time 1 is 1, but more than the time before it, 1, was expected"},
    {"channel-time-negative", "animation 0 'roll': channel 0: time 0 is -1, but 0 or more was expected"},
    {"channel-value-nan",
     "animation 0 'roll': channel 0: value 4 has the component nan, but finite numbers were expected"},
};
INSTANTIATE_TEST_SUITE_P(Animations, HostRefuses, testing::ValuesIn(invalidAnimations), nameOf);

const InvalidCase otherErrors[] = {
    {"progress-nan", "progress: nan was reported, but 0 to 1 was expected"},
    {"fail", "part 7: it is broken"},
    {"fail-null", "the plugin gives no reason"},
    {"first-failure-counts", "camera 0 'front': vertical_fov is nan, but a finite number was expected"},
    {"read-null", "read_file: its path or its result is NULL"},
    {"read-in-procedural-scene", "file 'file': a procedural scene has no folder to read files from"},
    {"returns-failed", "the plugin 'add-cases' failed and gave no reason"},
    {"throws", "the plugin 'add-cases' threw an exception, which the plugin interface forbids"},
};
INSTANTIATE_TEST_SUITE_P(Others, HostRefuses, testing::ValuesIn(otherErrors), nameOf);

// The expected sizes in the messages depend on the machine.
TEST(Host, StructSizeTooSmall) {
    expectError([] { add("mesh-struct-size"); }, ErrorKind::badInput,
                "mesh 0: struct_size is 0, but version 1.0 has");
    expectError([] { add("image-struct-size"); }, ErrorKind::badInput,
                "image 0: struct_size is 8, but version 1.0");
}

TEST(Host, StructsOfALaterMinorVersionAreAccepted) {
    EXPECT_EQ(add("longer-struct").scene.cameras.size(), 1u);
}

TEST(Host, StructsOfVersion1_0AreAccepted) {
    const ImportedScene imported = importScene(fixturePlugins(), "first:");
    EXPECT_EQ(imported.report.plugin, "first-version");
    EXPECT_EQ(imported.scene.meshes.at(0).indices.size(), 6u);
}

TEST(Host, CopiesWhatIsAdded) {
    const ImportedScene imported = add("all");
    const Scene& scene = imported.scene;
    EXPECT_EQ(imported.report.plugin, "add-cases");
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].name, "checks");
    EXPECT_EQ(scene.images[0].pixels.size(), 16u);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_FALSE(scene.materials[0].baseColorTexture);
    ASSERT_TRUE(scene.materials[0].normalTexture);
    EXPECT_EQ(scene.materials[0].normalTexture->magFilter, Filter::linear);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].submeshes.at(0).material, 0u);
    EXPECT_EQ(scene.meshes[0].normals.at(1), glm::vec3(0, 0, 1)) << "normals are normalized";
    EXPECT_EQ(scene.meshes[0].tangents.size(), scene.meshes[0].positions.size())
        << "a normal texture needs tangents";
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(scene.nodes[0].mesh, 0u);
    EXPECT_FALSE(scene.nodes[0].parent);
    EXPECT_FALSE(scene.nodes[0].castsShadow);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_FALSE(scene.cameras[0].nearPlane) << "0 stands for none";
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].type, LightType::spot);
    EXPECT_FALSE(scene.lights[0].range) << "0 stands for none";
    EXPECT_EQ(scene.lights[0].direction, glm::vec3(0, 0, -1));
    EXPECT_FALSE(scene.lights[0].castsShadow);
    EXPECT_EQ(scene.lights[0].radius, 0.125f);
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].channels.at(0).values.size(), 6u);
}

TEST(Host, MissingNormalsAreFlat) {
    const Mesh mesh = add("flat").scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 6u) << "triangles do not share vertices";
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Host, AMeshWithoutSubmeshesIsDrawnAsAWhole) {
    const Mesh mesh = add("mesh-no-submesh").scene.meshes.at(0);
    ASSERT_EQ(mesh.submeshes.size(), 1u);
    EXPECT_EQ(mesh.submeshes[0].firstIndex, 0u);
    EXPECT_EQ(mesh.submeshes[0].indexCount, mesh.indices.size());
    EXPECT_FALSE(mesh.submeshes[0].material) << "the default material";
}

TEST(Host, PluginsBuiltForOlderVersionsImport) {
    const PluginRegistry old({std::filesystem::path(CANDELA_TEST_FIXTURES) / "built-for-1-0",
                              std::filesystem::path(CANDELA_TEST_FIXTURES) / "built-for-1-1",
                              std::filesystem::path(CANDELA_TEST_FIXTURES) / "built-for-1-3",
                              std::filesystem::path(CANDELA_TEST_FIXTURES) / "built-for-1-4",
                              std::filesystem::path(CANDELA_TEST_FIXTURES) / "built-for-1-5"});
    const Scene first = importScene(old, "built-for-1-0:").scene;
    EXPECT_EQ(first.meshes.at(0).indices.size(), 3u);
    ASSERT_EQ(first.lights.size(), 1u);
    EXPECT_TRUE(first.lights[0].castsShadow);
    EXPECT_TRUE(first.nodes.at(0).castsShadow);
    const Scene second = importScene(old, "built-for-1-1:").scene;
    EXPECT_EQ(second.meshes.at(0).indices.size(), 6u) << "a quad";
    EXPECT_EQ(second.cages.size(), 1u);
    ASSERT_TRUE(second.nodes.at(1).cage);
    EXPECT_EQ(second.nodes[1].cage, 0u);
    EXPECT_TRUE(second.nodes[1].castsShadow);
    const Scene third = importScene(old, "built-for-1-3:").scene;
    EXPECT_EQ(third.nodes.at(0).translationRemainder, glm::dvec3(0, 0.25, 0));
    EXPECT_EQ(third.nodes[0].skin, 0u);
    EXPECT_TRUE(third.nodes[0].castsShadow);
    ASSERT_EQ(third.lights.size(), 1u);
    EXPECT_EQ(third.lights[0].node, 0u);
    EXPECT_TRUE(third.lights[0].castsShadow);
    EXPECT_EQ(third.lights[0].radius, 0.0f);
    const Scene fourth = importScene(old, "built-for-1-4:").scene;
    EXPECT_FALSE(fourth.nodes.at(0).castsShadow);
    ASSERT_EQ(fourth.lights.size(), 1u);
    EXPECT_EQ(fourth.lights[0].radius, 0.5f);
    EXPECT_FALSE(fourth.environment);
    const Scene fifth = importScene(old, "built-for-1-5:").scene;
    ASSERT_TRUE(fifth.environment);
    EXPECT_EQ(fifth.environment->intensity, 0.5f);
    EXPECT_FALSE(fifth.environment->isBackground);
    const Material& blending = fifth.materials.at(0);
    EXPECT_EQ(blending.alphaMode, AlphaMode::blend);
    EXPECT_EQ(blending.ior, 1.5f);
    EXPECT_EQ(blending.clearcoat, Clearcoat{});
    EXPECT_TRUE(fifth.meshes.at(0).variantMaterials.empty());
    EXPECT_TRUE(fifth.meshes[0].furtherUvs.empty());
    EXPECT_EQ(fifth.meshes[0].submeshes.at(0).topology, Topology::triangles);
}

TEST(Host, RunsParallelLoops) {
    const ImportedScene imported = add("parallel-loop");
    EXPECT_EQ(imported.scene.lights.size(), 1000u) << "a light for each index that ran once";
}

TEST(Host, TangentsWithoutNormalsAreOmittedAndNoted) {
    const ImportedScene imported = add("tangents-without-normals");
    EXPECT_TRUE(imported.scene.meshes.at(0).tangents.empty());
    EXPECT_EQ(noteLines(imported), Lines{"mesh 0 'wheel': tangents without normals, not used"});
}

TEST(Host, TangentsAreNormalized) {
    EXPECT_EQ(add("tangents").scene.meshes.at(0).tangents.at(1), glm::vec4(1, 0, 0, -1));
}

TEST(Host, ZeroNormalsAreReplacedByFaceNormals) {
    const ImportedScene imported = add("zero-normal");
    EXPECT_EQ(imported.scene.meshes.at(0).normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(
        noteLines(imported),
        Lines{
            "mesh 0 'wheel': normals of length 0 or not finite, replaced by that of a face that uses them"});
}

TEST(Host, DirectionsThatAreNotFiniteAreReplaced) {
    const ImportedScene imported = add("nan-directions");
    const Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(mesh.normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(glm::dot(glm::vec3(mesh.tangents.at(1)), mesh.normals.at(1)), 0.0f);
    EXPECT_EQ(
        noteLines(imported),
        (Lines{"mesh 0 'wheel': normals of length 0 or not finite, replaced by that of a face that uses them",
               "mesh 0 'wheel': tangents of length 0 or not finite, replaced by a direction perpendicular "
               "to the normal"}));
}

TEST(Host, ProgressIsForwarded) {
    std::vector<double> reported;
    add("progress-twice", [&](double fraction) {
        reported.push_back(fraction);
        return true;
    });
    EXPECT_EQ(reported, (std::vector<double>{0.5, 1.0}));
}

// The fixture continues after the import is cancelled.
TEST(Host, ACancelledImportIsAnErrorEvenIfTheImporterContinues) {
    int calls = 0;
    const auto cancel = [&](double) {
        ++calls;
        return false;
    };
    expectError([&] { add("progress-twice", cancel); }, ErrorKind::cancelled, "the import was cancelled");
    EXPECT_EQ(calls, 1) << "progress is not called after it has cancelled";
}

TEST(Host, ExceptionsOfTheProgressCallbackReachTheCaller) {
    struct CallbackError {};
    EXPECT_THROW(add("progress-twice", [](double) -> bool { throw CallbackError{}; }), CallbackError);
}

}  // namespace
}  // namespace candela
