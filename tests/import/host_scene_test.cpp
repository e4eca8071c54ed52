// What version 1.6 lets an importer say in few calls: initialisers, many nodes and lights, images that the
// host decodes, parts of files, smooth normals, axis and unit.
#include "expect_error.h"
#include "host_calls.h"
#include "import/abi_import.h"
#include "import_samples.h"
#include "temporary_folder.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace candela {
namespace {

std::string errorOf(const std::function<void(const candela_host&)>& addAll) {
    return expectError([&] { importedScene(addAll); }, ErrorKind::badInput, "");
}

TEST(HostInitialisers, MakeElementsOfThePlainKind) {
    const Scene scene = importedScene([](const candela_host& host) {
        candela_texture texture = CANDELA_TEXTURE_INIT;
        candela_specular specular = CANDELA_SPECULAR_INIT;
        candela_clearcoat clearcoat = CANDELA_CLEARCOAT_INIT;
        candela_sheen sheen = CANDELA_SHEEN_INIT;
        candela_anisotropy anisotropy = CANDELA_ANISOTROPY_INIT;
        candela_iridescence iridescence = CANDELA_IRIDESCENCE_INIT;
        candela_transmission transmission = CANDELA_TRANSMISSION_INIT;
        candela_volume volume = CANDELA_VOLUME_INIT;
        candela_diffuse_transmission scattering = CANDELA_DIFFUSE_TRANSMISSION_INIT;
        const candela_image image = samples::image();
        candela_material material = CANDELA_MATERIAL_INIT;
        host.add_image(host.self, &image);
        host.add_material(host.self, &material);
        texture.image = 0;
        material.base_color_texture = texture;
        material.specular = &specular;
        material.clearcoat = &clearcoat;
        material.sheen = &sheen;
        material.anisotropy = &anisotropy;
        material.iridescence = &iridescence;
        material.transmission = &transmission;
        material.volume = &volume;
        material.diffuse_transmission = &scattering;
        host.add_material(host.self, &material);
        candela_mesh mesh = CANDELA_MESH_INIT;
        candela_node node = CANDELA_NODE_INIT;
        candela_light light = CANDELA_LIGHT_INIT;
        candela_camera camera = CANDELA_CAMERA_INIT;
        host.add_mesh(host.self, &mesh);
        host.add_node(host.self, &node);
        host.add_light(host.self, &light);
        host.add_camera(host.self, &camera);
    });
    EXPECT_NO_THROW(validate(scene));
    Material plain, textured;
    textured.baseColorTexture = Texture{};
    EXPECT_EQ(scene.materials.at(0).baseColor, plain.baseColor);
    EXPECT_EQ(scene.materials[0].roughness, plain.roughness);
    EXPECT_EQ(scene.materials[0].alphaCutoff, plain.alphaCutoff);
    EXPECT_FALSE(scene.materials[0].baseColorTexture || scene.materials[0].emissionTexture);
    const Material& lobes = scene.materials.at(1);
    EXPECT_EQ(lobes.baseColorTexture, textured.baseColorTexture);
    EXPECT_EQ(lobes.specular, plain.specular);
    EXPECT_EQ(lobes.clearcoat, plain.clearcoat);
    EXPECT_EQ(lobes.sheen, plain.sheen);
    EXPECT_EQ(lobes.anisotropy, plain.anisotropy);
    EXPECT_EQ(lobes.iridescence, plain.iridescence);
    EXPECT_EQ(lobes.transmission, plain.transmission);
    EXPECT_EQ(lobes.volume, plain.volume);
    EXPECT_EQ(lobes.diffuseTransmission, plain.diffuseTransmission);
    EXPECT_FALSE(scene.nodes.at(0).parent || scene.nodes[0].mesh);
    EXPECT_EQ(scene.lights.at(0).intensity, Light{}.intensity);
    EXPECT_EQ(scene.lights[0].color, Light{}.color);
    EXPECT_EQ(scene.cameras.at(0).verticalFov, Camera{}.verticalFov);
}

/// As a later version's plugin has it: larger than the host's struct.
struct LaterNode {
    candela_node node = CANDELA_NODE_INIT;
    double added[3] = {1, 2, 3};
};

TEST(HostBulk, AddsManyInOneCall) {
    const Scene scene = importedScene([](const candela_host& host) {
        const candela_mesh mesh = samples::mesh();
        add(host, mesh);
        std::vector<LaterNode> nodes(100);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i].node.struct_size = sizeof(LaterNode);
            nodes[i].node.parent = static_cast<std::int32_t>(i) - 1;
            nodes[i].node.mesh = 0;
        }
        EXPECT_EQ(host.add_nodes(host.self, &nodes[0].node, 60), 0);
        EXPECT_EQ(host.add_nodes(host.self, &nodes[60].node, 40), 60);
        EXPECT_EQ(host.add_nodes(host.self, nullptr, 0), 100);
        std::vector<candela_light> lights(3, candela_light CANDELA_LIGHT_INIT);
        for (std::int32_t i = 0; i < 3; ++i) lights[static_cast<std::size_t>(i)].node = 10 * i;
        EXPECT_EQ(host.add_lights(host.self, lights.data(), 3), 0);
    });
    ASSERT_EQ(scene.nodes.size(), 100u);
    for (std::uint32_t i = 1; i < 100; ++i) EXPECT_EQ(scene.nodes[i].parent, i - 1);
    EXPECT_EQ(scene.lights.at(2).node, 20u);
    EXPECT_NO_THROW(validate(scene));
}

TEST(HostBulk, NamesTheElementAtFault) {
    std::vector<candela_node> nodes(3, candela_node CANDELA_NODE_INIT);
    nodes[1].parent = 7;
    nodes[1].name = "arm";
    const auto addNodes = [&](const candela_host& host) {
        EXPECT_EQ(host.add_nodes(host.self, nodes.data(), 3), -1);
    };
    EXPECT_EQ(errorOf(addNodes), "test: node 1 'arm': parent is 7, but 1 were added so far and -1 is none");
    nodes[1] = CANDELA_NODE_INIT;
    nodes[2].struct_size = 80;
    EXPECT_EQ(errorOf(addNodes), "test: node 2: struct_size is 80, but that of the array is 120");
    EXPECT_EQ(errorOf([](const candela_host& host) { host.add_lights(host.self, nullptr, 2); }),
              "test: light 0: the array is NULL");
}

// ---- Images that the host decodes: a format of "PIX", a grey and nothing else.

std::uint32_t recognizesPix(const std::uint8_t* bytes, std::uint64_t size) {
    return size >= 3 && std::memcmp(bytes, "PIX", 3) == 0 ? 1 : 0;
}

candela_status decodePix(const candela_decoding* decoding, const std::uint8_t* bytes, std::uint64_t size) {
    if (size == 3) {
        decoding->fail(decoding->self, "a PIX file that is cut off");
        return CANDELA_FAILED;
    }
    if (bytes[3] == 'S') return CANDELA_OK;
    const std::array<std::uint8_t, 4> texel{bytes[3], bytes[3], bytes[3], 255};
    candela_image image = CANDELA_IMAGE_INIT;
    image.width = image.height = bytes[3] == '0' ? 0 : 1;
    image.pixels = texel.data();
    image.pixels_size = texel.size();
    return decoding->set_result(decoding->self, &image);
}

const candela_image_decoder pixDecoder{sizeof(candela_image_decoder), recognizesPix, decodePix};
const candela_plugin pixPlugin{sizeof(candela_plugin), 1, 6, "pix", "1.0", "", nullptr, nullptr, &pixDecoder};

TEST(HostImageBytes, AreDecodedByPlugins) {
    ImportHost importing("test", nullptr, {}, {&pixPlugin});
    const candela_host& host = importing.interface();
    const std::array<std::string, 6> files{"PIXa", "PIX", "other", "PIXS", "PIX0", "PIXb"};
    std::vector<candela_image_bytes> images;
    for (const std::string& file : files)
        images.push_back({"name", reinterpret_cast<const std::uint8_t*>(file.data()), file.size()});
    images.push_back({nullptr, nullptr, 0});
    std::array<std::int32_t, 7> indices{};
    std::array<const char*, 7> reasons{};
    EXPECT_EQ(host.add_image_bytes(host.self, images.data(), 7, indices.data(), reasons.data()), CANDELA_OK);
    EXPECT_EQ(indices, (std::array<std::int32_t, 7>{0, -1, -1, -1, -1, 1, -1}));
    EXPECT_EQ(reasons[0], nullptr);
    EXPECT_STREQ(reasons[1], "a PIX file that is cut off");
    EXPECT_STREQ(reasons[2], "no plugin decodes a file that begins like this one");
    EXPECT_STREQ(reasons[3], "the plugin 'pix' failed and gave no reason");
    EXPECT_STREQ(reasons[4], "image 4 'name': width is 0, but 1 to 32768 was expected");
    EXPECT_STREQ(reasons[6], "the file is empty");
    importing.rethrowFailure();
    const Scene scene = importing.takeScene();
    ASSERT_EQ(scene.images.size(), 2u);
    EXPECT_EQ(scene.images[0].pixels.at(0), std::byte{'a'});
    EXPECT_EQ(scene.images[1].pixels.at(0), std::byte{'b'});
}

TEST(HostImageBytes, NeedAPlugin) {
    EXPECT_TRUE(importedScene([](const candela_host& host) {
                    const candela_image_bytes file{"", samples::texels.data(), 4};
                    std::int32_t index = 5;
                    const char* reason = nullptr;
                    EXPECT_EQ(host.add_image_bytes(host.self, &file, 1, &index, &reason), CANDELA_OK);
                    EXPECT_EQ(index, -1);
                    EXPECT_STREQ(reason, "no plugin that decodes images is loaded");
                }).images.empty());
    EXPECT_EQ(errorOf([](const candela_host& host) {
                  host.add_image_bytes(host.self, nullptr, 1, nullptr, nullptr);
              }),
              "test: add_image_bytes: its images, its indices or its reasons are NULL");
}

TEST(HostFiles, AreReadInParts) {
    const TemporaryFolder folder;
    folder.write("big.bin", "0123456789");
    folder.write("deep/file", "x");
    const auto failureOf = [&](const std::function<void(const candela_host&)>& read) {
        ImportHost host("test", std::make_unique<FileAccess>(folder.path()), {});
        read(host.interface());
        return expectError([&] { host.rethrowFailure(); }, ErrorKind::badInput, "");
    };
    ImportHost importing("test", std::make_unique<FileAccess>(folder.path()), {});
    const candela_host& host = importing.interface();
    std::uint64_t size = 0;
    EXPECT_EQ(host.file_size(host.self, "big.bin", &size), CANDELA_OK);
    EXPECT_EQ(size, 10u);
    std::array<char, 4> part{};
    EXPECT_EQ(host.read_file_part(host.self, "big.bin", 6, 4, part.data()), CANDELA_OK);
    EXPECT_EQ(std::string(part.data(), 4), "6789");
    EXPECT_EQ(host.read_file_part(host.self, "big.bin", 10, 0, nullptr), CANDELA_OK);
    importing.rethrowFailure();
    EXPECT_EQ(failureOf([&](const candela_host& h) {
                  EXPECT_EQ(h.read_file_part(h.self, "big.bin", 7, 4, part.data()), CANDELA_FAILED);
              }),
              "test: file 'big.bin': it has 10 bytes, but 4 from byte 7 on were expected");
    EXPECT_EQ(failureOf([&](const candela_host& h) {
                  h.read_file_part(h.self, "big.bin", ~std::uint64_t{0}, 2, part.data());
              }),
              "test: file 'big.bin': it has 10 bytes, but 2 from byte 18446744073709551615 on were expected");
    EXPECT_EQ(failureOf([&](const candela_host& h) { h.file_size(h.self, "../outside", &size); }),
              "test: file '../outside': it leads out of the scene's folder");
    EXPECT_EQ(failureOf([&](const candela_host& h) { h.read_file_part(h.self, "deep", 0, 1, part.data()); }),
              "test: file 'deep': it is a folder, but a file was expected");
}

TEST(HostMesh, NormalsFollowTheCreaseAngle) {
    // A roof: two squares that meet at a right angle along x.
    constexpr std::array<float, 18> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1};
    constexpr std::array<std::uint32_t, 12> indices{0, 1, 3, 0, 3, 2, 0, 4, 5, 0, 5, 1};
    const auto meshWith = [&](float angle) {
        return importedScene([&](const candela_host& host) {
                   candela_mesh mesh = CANDELA_MESH_INIT;
                   mesh.vertex_count = 6;
                   mesh.positions = positions.data();
                   mesh.index_count = indices.size();
                   mesh.indices = indices.data();
                   mesh.crease_angle = angle;
                   add(host, mesh);
               })
            .meshes.at(0);
    };
    EXPECT_TRUE(meshWith(0.0f).normals.empty()) << "flat ones are made at the end of the import";
    EXPECT_EQ(meshWith(1.0f).positions.size(), 8u);
    const Mesh smooth = meshWith(2.0f);
    ASSERT_EQ(smooth.positions.size(), 6u);
    // Both sides have a right angle at the ridge.
    EXPECT_LT(glm::distance(smooth.normals[1], glm::normalize(glm::vec3(0, 1, 1))), 1e-6f);
    EXPECT_EQ(smooth.normals[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(expectError([&] { meshWith(4.0f); }, ErrorKind::badInput, "crease_angle"),
              "test: mesh 0: crease_angle is 4, but 0 to 3.14159 was expected");
}

/// A node that turns and has a child, a light and a camera, in centimetres with +Z up.
void addArm(const candela_host& host) {
    candela_scene_info info = CANDELA_SCENE_INFO_INIT;
    info.up_axis = CANDELA_UP_Z;
    info.metres_per_unit = 0.01;
    info.generator = "a\nmodeller";
    EXPECT_EQ(host.set_scene_info(host.self, &info), CANDELA_OK);
    const candela_mesh mesh = samples::mesh();
    add(host, mesh);
    std::vector<candela_node> nodes(2, candela_node CANDELA_NODE_INIT);
    nodes[0].translation[2] = 100;
    nodes[1].parent = 0;
    nodes[1].mesh = 0;
    nodes[1].translation[0] = 50;
    host.add_nodes(host.self, nodes.data(), 2);
    std::vector<candela_light> lights(2, candela_light CANDELA_LIGHT_INIT);
    lights[0].position[1] = 300;
    lights[0].range = 5;
    lights[1].node = 1;
    host.add_lights(host.self, lights.data(), 2);
    candela_animation_channel channel = samples::channel;
    channel.node = 0;
    candela_animation animation = CANDELA_ANIMATION_INIT;
    animation.channel_count = 1;
    animation.channels = &channel;
    add(host, animation);
}

TEST(HostSceneInfo, BringsTheSceneToMetresWithYUp) {
    ImportHost host("test", nullptr, {});
    addArm(host.interface());
    host.rethrowFailure();
    Scene scene = host.takeScene();
    const SceneInfo info = host.sceneInfo();
    EXPECT_EQ(info.upAxis, UpAxis::z);
    EXPECT_EQ(info.metresPerUnit, 0.01);
    EXPECT_EQ(info.generator, "a modeller");
    bringToMetres(info, scene);
    EXPECT_NO_THROW(validate(scene));
    scene.animations.at(0).plays = false;
    const auto world = worldTransforms(scene);
    ASSERT_EQ(world.size(), 3u);
    const auto expectPlace = [](const glm::vec3& place, const glm::vec3& expected) {
        EXPECT_LT(glm::distance(place, expected), 1e-6f) << place.x << " " << place.y << " " << place.z;
    };
    expectPlace(glm::vec3(world[2][3]), {0.5f, 1, 0});
    // +Y of the file goes away from the viewer.
    expectPlace(glm::vec3(world[2] * glm::vec4(0, 1, 0, 0)), {0, 0, -0.01f});
    const auto lights = worldLights(scene, world);
    expectPlace(lights.at(0).position, {0, 0, -3});
    EXPECT_EQ(lights[0].range, 5.0f) << "metres as ever";
    expectPlace(lights.at(1).position, {0.5f, 1, 0});
    EXPECT_EQ(scene.animations[0].channels.at(0).node, 1u);
    scene.animations[0].plays = true;
    // From (0, 0, 0) to (1, 1, 1) of the file.
    expectPlace(glm::vec3(worldTransforms(scene, 1.0).at(1)[3]), {0.01f, 0.01f, -0.01f});
}

TEST(HostSceneInfo, WithXUp) {
    Scene scene;
    scene.nodes.emplace_back();
    SceneInfo info;
    info.upAxis = UpAxis::x;
    bringToMetres(info, scene);
    const auto world = worldTransforms(scene);
    EXPECT_EQ(glm::vec3(world.at(1) * glm::vec4(1, 2, 3, 0)), glm::vec3(-2, 1, 3));
}

TEST(HostSceneInfo, ThatSaysNothingChangesNothing) {
    Scene scene;
    scene.nodes.emplace_back();
    bringToMetres({}, scene);
    EXPECT_EQ(scene.nodes.size(), 1u);
}

TEST(HostSceneInfo, IsChecked) {
    const auto fault = [](auto change) {
        return errorOf([&](const candela_host& host) {
            candela_scene_info info = CANDELA_SCENE_INFO_INIT;
            change(info);
            EXPECT_EQ(host.set_scene_info(host.self, &info), CANDELA_FAILED);
        });
    };
    EXPECT_EQ(fault([](auto& info) { info.up_axis = static_cast<candela_up_axis>(3); }),
              "test: set_scene_info: up_axis is 3, but 0 to 2 was expected");
    EXPECT_EQ(fault([](auto& info) { info.metres_per_unit = -1; }),
              "test: set_scene_info: metres_per_unit is -1, but 1e-09 to 1e+09 was expected");
    EXPECT_EQ(fault([](auto& info) { info.metres_per_unit = std::nan(""); }),
              "test: set_scene_info: metres_per_unit is nan, but 1e-09 to 1e+09 was expected");
    EXPECT_EQ(errorOf([](const candela_host& host) {
                  const candela_scene_info info = CANDELA_SCENE_INFO_INIT;
                  host.set_scene_info(host.self, &info);
                  host.set_scene_info(host.self, &info);
              }),
              "test: set_scene_info: it has been called before");
}

}  // namespace
}  // namespace candela
