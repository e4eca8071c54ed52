// What the host accepts and refuses of variants.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include "import/abi_import.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace candela {
namespace {

constexpr candela_variant_material entries[] = {{0, 0, 1}, {0, 1, -1}};

/// A square with two variants and two materials.
void addAll(const candela_host& host, const std::function<void(candela_mesh&)>& modify) {
    const candela_material material = samples::material();
    for (int i = 0; i < 2; ++i) host.add_material(host.self, &material);
    EXPECT_EQ(host.add_variant(host.self, "red"), 0);
    EXPECT_EQ(host.add_variant(host.self, nullptr), 1);
    const candela_submesh submesh{0, 6, 0};
    candela_mesh mesh = samples::mesh();
    mesh.submeshes = &submesh;
    mesh.submesh_count = 1;
    mesh.variant_material_count = 2;
    mesh.variant_materials = entries;
    modify(mesh);
    add(host, mesh);
}

Scene sceneWith(const std::function<void(candela_mesh&)>& modify) {
    return importedScene([&](const candela_host& host) { addAll(host, modify); });
}

TEST(HostVariants, AreTaken) {
    const Scene scene = sceneWith([](candela_mesh&) {});
    EXPECT_NO_THROW(validate(scene));
    EXPECT_EQ(scene.variants, (std::vector<std::string>{"red", ""}));
    const std::vector<VariantMaterial> expected{{0, std::nullopt, 0}, {0, 0, 1}, {0, 1, std::nullopt}};
    EXPECT_EQ(scene.meshes.at(0).variantMaterials, expected);
    EXPECT_EQ(scene.meshes.at(0).submeshes.at(0).material, 0u);
}

TEST(HostVariants, OfAnOlderStructAreNotRead) {
    const Scene scene =
        sceneWith([](candela_mesh& m) { m.struct_size = offsetof(candela_mesh, variant_material_count); });
    EXPECT_TRUE(scene.meshes.at(0).variantMaterials.empty());
}

TEST(HostVariants, RefusesWhatIsWrong) {
    const auto expectRefused = [](candela_variant_material first, const std::string& text) {
        const candela_variant_material wrong[] = {first, entries[1]};
        EXPECT_EQ(expectError([&] { sceneWith([&](candela_mesh& m) { m.variant_materials = wrong; }); },
                              ErrorKind::badInput, ""),
                  "test: mesh 0 'wheel': " + text);
    };
    expectRefused({1, 0, 1}, "variant material 0: submesh is 1, but there are 1");
    expectRefused({0, 2, 1}, "variant material 0: variant is 2, but there are 2");
    expectRefused({0, 0, 2}, "variant material 0: material is 2, but 2 were added so far and -1 is none");
    expectRefused({0, 1, 1}, "variant material 1: submesh 0 has a material for variant 1 already");
    EXPECT_EQ(expectError([] { sceneWith([](candela_mesh& m) { m.variant_materials = nullptr; }); },
                          ErrorKind::badInput, ""),
              "test: mesh 0 'wheel': variant_materials is NULL, but variant_material_count is 2");
}

constexpr std::array<std::int32_t, 2> plainFaces{0, -1}, redFaces{1, 1}, blueFaces{-1, 0};
constexpr candela_cage_variant cageVariants[] = {{0, redFaces.data()}, {1, blueFaces.data()}};

Scene sceneWithCage(const std::function<void(candela_cage&)>& modify) {
    return importedScene([&](const candela_host& host) {
        const candela_material material = samples::material();
        for (int i = 0; i < 2; ++i) host.add_material(host.self, &material);
        host.add_variant(host.self, "red");
        host.add_variant(host.self, "blue");
        candela_cage cage = samples::cage();
        cage.face_materials = plainFaces.data();
        cage.variant_count = 2;
        cage.variants = cageVariants;
        modify(cage);
        host.add_cage(host.self, &cage);
    });
}

TEST(HostVariants, OfCagesAreTaken) {
    const Scene scene = sceneWithCage([](candela_cage&) {});
    EXPECT_NO_THROW(validate(scene));
    const std::vector<CageVariant> expected{
        {std::nullopt, {0, std::nullopt}}, {0, {1, 1}}, {1, {std::nullopt, 0}}};
    EXPECT_EQ(scene.cages.at(0).variants, expected);
    const Scene older =
        sceneWithCage([](candela_cage& c) { c.struct_size = offsetof(candela_cage, variant_count); });
    EXPECT_TRUE(older.cages.at(0).variants.empty());
    EXPECT_EQ(older.cages[0].faceMaterials.at(0), 0u);
}

TEST(HostVariants, OfCagesRefuseWhatIsWrong) {
    const auto expectRefused = [](candela_cage_variant first, const std::string& text) {
        const candela_cage_variant wrong[] = {first, cageVariants[1]};
        EXPECT_EQ(expectError([&] { sceneWithCage([&](candela_cage& c) { c.variants = wrong; }); },
                              ErrorKind::badInput, ""),
                  "test: cage 0 'body': " + text);
    };
    constexpr std::array<std::int32_t, 2> beyond{0, 2};
    expectRefused({2, redFaces.data()}, "variants[0].variant is 2, but 0 to 1 was expected");
    expectRefused({1, redFaces.data()}, "variants[1]: variant 1 has its materials already");
    expectRefused({0, nullptr}, "variants[0].face_materials is NULL, but 2 elements were expected");
    expectRefused({0, beyond.data()},
                  "variants[0]: face 1: material is 2, but 2 were added so far and -1 is none");
    EXPECT_EQ(expectError([] { sceneWithCage([](candela_cage& c) { c.variants = nullptr; }); },
                          ErrorKind::badInput, ""),
              "test: cage 0 'body': variants is NULL, but 2 elements were expected");
}

TEST(HostVariants, AMaterialOfAVariantGetsTangents) {
    const candela_texture texture = samples::texture(0);
    Scene scene = importedScene([&](const candela_host& host) {
        const candela_image image = samples::image();
        host.add_image(host.self, &image);
        const candela_material plain = samples::material();
        host.add_material(host.self, &plain);
        const candela_material bumpy =
            modified(samples::material(), [&](candela_material& m) { m.normal_texture = texture; });
        host.add_material(host.self, &bumpy);
        host.add_variant(host.self, "bumpy");
        const candela_submesh submesh{0, 6, 0};
        add(host, modified(samples::mesh(), [&](candela_mesh& m) {
                m.submeshes = &submesh;
                m.submesh_count = 1;
                m.uv0 = samples::uvs.data();
                m.variant_material_count = 1;
                m.variant_materials = entries;
            }));
    });
    NoteList notes;
    addMissingAttributes(scene, notes);
    EXPECT_EQ(scene.meshes.at(0).tangents.size(), 4u);
}

}  // namespace
}  // namespace candela
