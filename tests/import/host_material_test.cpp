// What the host accepts and refuses of the lobes and media of a material, and the tangents that it makes for
// them.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include "import/abi_import.h"
#include "scene/model/material_textures.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace candela {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// A material with every lobe, whose textures are the images 0 to 13 in the order of `materialTextures`.
struct LayeredMaterial {
    LayeredMaterial() {
        for (int i = 0; i < 14; ++i) textures[i] = samples::texture(i);
        material.ior = 1.25f;
        material.specular = &specular;
        material.clearcoat = &clearcoat;
        material.sheen = &sheen;
        material.anisotropy = &anisotropy;
        material.iridescence = &iridescence;
        material.transmission = &transmission;
        material.volume = &volume;
        material.diffuse_transmission = &diffuse;
    }
    LayeredMaterial(const LayeredMaterial&) = delete;

    candela_texture textures[14];
    candela_specular specular{0.5f, {0.25f, 2.0f, 0.0f}, &textures[0], &textures[1]};
    candela_clearcoat clearcoat{0.75f, 0.125f, -2.0f, &textures[2], &textures[3], &textures[4]};
    candela_sheen sheen{{0.25f, 0.5f, 1.0f}, 0.375f, &textures[5], &textures[6]};
    candela_anisotropy anisotropy{0.625f, 7.0f, &textures[7]};
    candela_iridescence iridescence{0.5f, 1.75f, 50.0f, 300.0f, &textures[8], &textures[9]};
    candela_transmission transmission{0.875f, &textures[10]};
    candela_volume volume{0.25f, 4.0f, {0.5f, 0.75f, 1.0f}, 0.2f, &textures[11]};
    candela_diffuse_transmission diffuse{0.5f, {1.0f, 0.5f, 0.25f}, &textures[12], &textures[13]};
    candela_material material = samples::material();
};

Scene sceneWith(const candela_material& material) {
    return importedScene([&](const candela_host& host) {
        const candela_image image = samples::image();
        for (int i = 0; i < 14; ++i) host.add_image(host.self, &image);
        host.add_material(host.self, &material);
    });
}

TEST(HostMaterial, TakesEveryLobe) {
    const LayeredMaterial source;
    const Scene scene = sceneWith(source.material);
    EXPECT_NO_THROW(validate(scene));
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(material.ior, 1.25f);
    EXPECT_EQ(material.specular.factor, 0.5f);
    EXPECT_EQ(material.specular.color, glm::vec3(0.25f, 2.0f, 0.0f));
    EXPECT_EQ(material.clearcoat.factor, 0.75f);
    EXPECT_EQ(material.clearcoat.roughness, 0.125f);
    EXPECT_EQ(material.clearcoat.normalScale, -2.0f);
    EXPECT_EQ(material.sheen.color, glm::vec3(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(material.sheen.roughness, 0.375f);
    EXPECT_EQ(material.anisotropy.strength, 0.625f);
    EXPECT_EQ(material.anisotropy.rotation, 7.0f);
    EXPECT_EQ(material.iridescence.factor, 0.5f);
    EXPECT_EQ(material.iridescence.ior, 1.75f);
    EXPECT_EQ(material.iridescence.minThickness, 50.0f);
    EXPECT_EQ(material.iridescence.maxThickness, 300.0f);
    EXPECT_EQ(material.transmission.factor, 0.875f);
    EXPECT_EQ(material.volume.thickness, 0.25f);
    EXPECT_EQ(material.volume.attenuationDistance, 4.0f);
    EXPECT_EQ(material.volume.attenuationColor, glm::vec3(0.5f, 0.75f, 1.0f));
    EXPECT_EQ(material.volume.dispersion, 0.2f);
    EXPECT_EQ(material.diffuseTransmission.factor, 0.5f);
    EXPECT_EQ(material.diffuseTransmission.color, glm::vec3(1.0f, 0.5f, 0.25f));
    const auto textures = materialTextures();
    ASSERT_EQ(textures.size(), basicTextureCount + 14);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const std::optional<Texture>& texture = textures[i].of(material);
        ASSERT_EQ(texture.has_value(), i >= basicTextureCount) << textures[i].name;
        if (!texture) continue;
        EXPECT_EQ(texture->image, i - basicTextureCount) << textures[i].name;
    }
}

TEST(HostMaterial, WhatIsNullIsAbsent) {
    const Material material = sceneWith(samples::material()).materials.at(0);
    const Material plain;
    EXPECT_EQ(material.ior, 1.5f) << "0 stands for it";
    EXPECT_EQ(material.specular, plain.specular);
    EXPECT_EQ(material.clearcoat, plain.clearcoat);
    EXPECT_EQ(material.sheen, plain.sheen);
    EXPECT_EQ(material.anisotropy, plain.anisotropy);
    EXPECT_EQ(material.iridescence, plain.iridescence);
    EXPECT_EQ(material.transmission, plain.transmission);
    EXPECT_EQ(material.volume, plain.volume);
    EXPECT_EQ(material.diffuseTransmission, plain.diffuseTransmission);
}

TEST(HostMaterial, MembersBeyondAnOlderStructAreNotRead) {
    LayeredMaterial source;
    source.material.struct_size = offsetof(candela_material, ior);
    const Material material = sceneWith(source.material).materials.at(0);
    EXPECT_EQ(material.ior, 1.5f);
    EXPECT_EQ(material.clearcoat, Clearcoat{});
}

TEST(HostMaterial, InfiniteNumbersThatAreAllowed) {
    LayeredMaterial source;
    source.material.ior = infinity;
    source.volume.attenuation_distance = infinity;
    const Scene scene = sceneWith(source.material);
    EXPECT_NO_THROW(validate(scene));
    EXPECT_EQ(scene.materials.at(0).ior, infinity);
    EXPECT_EQ(scene.materials.at(0).volume.attenuationDistance, infinity);
    source.volume.attenuation_distance = 0.0f;
    EXPECT_EQ(sceneWith(source.material).materials.at(0).volume.attenuationDistance, infinity)
        << "0 stands for it";
}

TEST(HostMaterial, RefusesWhatIsWrong) {
    const auto expectRefused = [](const std::function<void(LayeredMaterial&)>& modify,
                                  const std::string& text) {
        LayeredMaterial source;
        modify(source);
        EXPECT_EQ(expectError([&] { sceneWith(source.material); }, ErrorKind::badInput, ""),
                  "test: material 0 'paint': " + text);
    };
    const std::string share = ", but 0 to 1 was expected", more = ", but 0 or more was expected",
                      finite = ", but a finite number was expected", ior = ", but 1 or more was expected";
    expectRefused([](auto& m) { m.material.ior = 0.5f; }, "ior is 0.5" + ior);
    expectRefused([](auto& m) { m.material.ior = NAN; }, "ior is nan" + ior);
    expectRefused([](auto& m) { m.specular.factor = 2.0f; }, "specular.factor is 2" + share);
    expectRefused([](auto& m) { m.specular.color[2] = -1.0f; }, "specular.color is -1" + more);
    expectRefused([](auto& m) { m.textures[1].image = 14; },
                  "specular.color_texture.image is 14, but 14 were added so far and -1 is none");
    expectRefused([](auto& m) { m.clearcoat.factor = -1.0f; }, "clearcoat.factor is -1" + share);
    expectRefused([](auto& m) { m.clearcoat.roughness = NAN; }, "clearcoat.roughness is nan" + share);
    expectRefused([](auto& m) { m.clearcoat.normal_scale = infinity; },
                  "clearcoat.normal_scale is inf" + finite);
    expectRefused([](auto& m) { m.sheen.color[0] = 1.5f; }, "sheen.color is 1.5" + share);
    expectRefused([](auto& m) { m.sheen.roughness = 1.5f; }, "sheen.roughness is 1.5" + share);
    expectRefused([](auto& m) { m.anisotropy.strength = -0.5f; }, "anisotropy.strength is -0.5" + share);
    expectRefused([](auto& m) { m.anisotropy.rotation = NAN; }, "anisotropy.rotation is nan" + finite);
    expectRefused([](auto& m) { m.iridescence.factor = 3.0f; }, "iridescence.factor is 3" + share);
    expectRefused([](auto& m) { m.iridescence.ior = infinity; }, "iridescence.ior is inf" + ior);
    expectRefused([](auto& m) { m.iridescence.min_thickness = -1.0f; },
                  "iridescence.min_thickness is -1" + more);
    expectRefused([](auto& m) { m.iridescence.max_thickness = -1.0f; },
                  "iridescence.max_thickness is -1" + more);
    expectRefused([](auto& m) { m.transmission.factor = 2.0f; }, "transmission.factor is 2" + share);
    expectRefused([](auto& m) { m.volume.thickness = -2.0f; }, "volume.thickness is -2" + more);
    expectRefused([](auto& m) { m.volume.attenuation_distance = -2.0f; },
                  "volume.attenuation_distance is -2" + more);
    expectRefused([](auto& m) { m.volume.attenuation_color[1] = 2.0f; },
                  "volume.attenuation_color is 2" + share);
    expectRefused([](auto& m) { m.volume.dispersion = -0.5f; }, "volume.dispersion is -0.5" + more);
    expectRefused([](auto& m) { m.diffuse.factor = 2.0f; }, "diffuse_transmission.factor is 2" + share);
    expectRefused([](auto& m) { m.diffuse.color[1] = 2.0f; }, "diffuse_transmission.color is 2" + share);
}

/// The mesh of a scene whose material has one lobe that needs tangents.
Mesh meshWith(const std::function<void(candela_material&)>& modify) {
    Scene scene = importedScene([&](const candela_host& host) {
        const candela_image image = samples::image();
        host.add_image(host.self, &image);
        const candela_material material = modified(samples::material(), modify);
        host.add_material(host.self, &material);
        const candela_submesh submesh{0, 6, 0};
        add(host, modified(samples::mesh(), [&](candela_mesh& m) {
                m.submeshes = &submesh;
                m.submesh_count = 1;
                m.uv0 = samples::uvs.data();
            }));
    });
    NoteList notes;
    addMissingAttributes(scene, notes);
    EXPECT_NO_THROW(validate(scene));
    return scene.meshes.at(0);
}

TEST(HostMaterial, ClearcoatNormalsAndAnisotropyGetTangents) {
    const candela_texture texture = samples::texture(0);
    candela_clearcoat coat{};
    candela_anisotropy anisotropy{};
    const auto withCoat = [&](candela_material& m) { m.clearcoat = &coat; };
    const auto withAnisotropy = [&](candela_material& m) { m.anisotropy = &anisotropy; };
    EXPECT_TRUE(meshWith(withCoat).tangents.empty());
    EXPECT_TRUE(meshWith(withAnisotropy).tangents.empty()) << "its strength is 0";
    coat.normal_texture = &texture;
    EXPECT_EQ(meshWith(withCoat).tangents.size(), 4u);
    anisotropy.strength = 0.5f;
    EXPECT_EQ(meshWith(withAnisotropy).tangents.size(), 4u);
    EXPECT_EQ(meshWith(withAnisotropy).tangents.at(0), glm::vec4(1, 0, 0, -1))
        << "along the coordinates 0, whose second one grows upwards";
}

}  // namespace
}  // namespace candela
