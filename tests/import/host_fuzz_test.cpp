// Random bytes in all numbers of all structs of plugin.h: the host refuses or accepts them, and never
// crashes. The arrays have the lengths that the counts say, since the host cannot check those.
#include "import_samples.h"

#include "import/abi_import.h"
#include "import/host.h"
#include "support/fuzz_iterations.h"

#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <random>
#include <vector>

namespace candela {
namespace {

constexpr std::uint32_t maxElements = 24;

class Fuzzer {
  public:
    explicit Fuzzer(std::uint32_t seed) : random_(seed) {}

    bool oneIn(std::uint32_t count) { return below(count) == 0; }
    std::uint32_t below(std::uint32_t count) { return any() % count; }

    // Mostly numbers that pass a first check, some random bits, some edge cases.
    std::uint32_t bits() {
        constexpr std::array<std::uint32_t, 10> edges{
            0, 1, 2, 3, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7F800000, 0x7FC00000, 0x00000001};
        if (oneIn(3)) return any();
        if (oneIn(3)) return edges[below(edges.size())];
        const float moderate = static_cast<float>(below(2001)) / 1000.0f - 0.5f;
        std::uint32_t number = 0;
        std::memcpy(&number, &moderate, sizeof number);
        return oneIn(2) ? number : below(4);
    }

    float number() {
        const std::uint32_t source = bits();
        float value = 0.0f;
        std::memcpy(&value, &source, sizeof value);
        return value;
    }

    template <class T>
    void modify(T& member) {
        static_assert(sizeof(T) % 4 == 0 && std::is_trivially_copyable_v<T>);
        if (!oneIn(3)) return;
        for (std::size_t offset = 0; offset < sizeof(T); offset += 4) {
            const std::uint32_t source = bits();
            std::memcpy(reinterpret_cast<char*>(&member) + offset, &source, 4);
        }
    }

    // NULL at times; mostly finite numbers, so that later checks are reached too.
    const float* array(std::vector<float>& storage, std::size_t count) {
        if (oneIn(6)) return nullptr;
        storage.resize(count);
        for (float& value : storage) value = oneIn(200) ? number() : static_cast<float>(below(9)) - 4.0f;
        return storage.data();
    }

    const std::uint32_t* indices(std::vector<std::uint32_t>& storage, std::size_t count, std::uint32_t end) {
        if (oneIn(20)) return nullptr;
        storage.resize(count);
        for (std::uint32_t& index : storage) index = oneIn(60) ? bits() : below(std::max(end, 1u));
        return storage.data();
    }

    // Sizes of faces.
    const std::uint32_t* sizes(std::vector<std::uint32_t>& storage, std::size_t count) {
        if (oneIn(20)) return nullptr;
        storage.resize(count);
        for (std::uint32_t& size : storage) size = oneIn(20) ? bits() : 3 + below(4);
        return storage.data();
    }

    std::uint32_t structSize(std::uint32_t size) { return oneIn(20) ? bits() % (size + 1) : size; }

  private:
    std::uint32_t any() { return static_cast<std::uint32_t>(random_()); }

    std::mt19937 random_;
};

// At most 1000, to bound the memory of the test: the host must refuse more before it reads the array.
std::uint32_t sumOf(const std::vector<std::uint32_t>& sizes) {
    std::uint64_t sum = 0;
    for (const std::uint32_t size : sizes) sum += size;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, 1000));
}

void addImage(Fuzzer& fuzz, const candela_host& host) {
    std::array<std::uint8_t, 256> texels;
    texels.fill(static_cast<std::uint8_t>(fuzz.bits()));
    candela_image image = samples::image();
    image.struct_size = fuzz.structSize(image.struct_size);
    fuzz.modify(image.width);
    fuzz.modify(image.height);
    fuzz.modify(image.format);
    fuzz.modify(image.pixels_size);
    if (image.pixels_size > texels.size()) image.pixels_size = texels.size();
    image.pixels = fuzz.oneIn(9) ? nullptr : texels.data();
    host.add_image(host.self, &image);
}

struct Lobes {
    candela_texture texture = samples::texture(-1);
    candela_specular specular{1.0f, {1, 1, 1}, &texture, nullptr};
    candela_clearcoat clearcoat{0.5f, 0.5f, 1.0f, nullptr, nullptr, &texture};
    candela_sheen sheen{{0, 1, 1}, 0.5f, &texture, nullptr};
    candela_anisotropy anisotropy{0.5f, 1.0f, &texture};
    candela_iridescence iridescence{0.5f, 1.5f, 100.0f, 400.0f, &texture, nullptr};
    candela_transmission transmission{0.5f, &texture};
    candela_volume volume{0.5f, 1.0f, {1, 1, 0}, 0.1f, &texture};
    candela_diffuse_transmission diffuse{0.5f, {1, 0, 1}, nullptr, &texture};

    void addTo(candela_material& material, Fuzzer& fuzz) {
        fuzz.modify(texture.image);
        fuzz.modify(material.ior);
        fuzz.modify(specular.color);
        fuzz.modify(clearcoat.normal_scale);
        fuzz.modify(anisotropy.rotation);
        fuzz.modify(iridescence.ior);
        fuzz.modify(volume.attenuation_distance);
        if (fuzz.oneIn(3)) material.specular = &specular;
        if (fuzz.oneIn(3)) material.clearcoat = &clearcoat;
        if (fuzz.oneIn(3)) material.sheen = &sheen;
        if (fuzz.oneIn(3)) material.anisotropy = &anisotropy;
        if (fuzz.oneIn(3)) material.iridescence = &iridescence;
        if (fuzz.oneIn(3)) material.transmission = &transmission;
        if (fuzz.oneIn(3)) material.volume = &volume;
        if (fuzz.oneIn(3)) material.diffuse_transmission = &diffuse;
    }
};

void addMaterial(Fuzzer& fuzz, const candela_host& host) {
    candela_material material = samples::material();
    material.struct_size = fuzz.structSize(material.struct_size);
    fuzz.modify(material.base_color);
    fuzz.modify(material.metallic);
    fuzz.modify(material.roughness);
    fuzz.modify(material.emission);
    fuzz.modify(material.normal_texture);
    fuzz.modify(material.emission_texture.image);
    fuzz.modify(material.emission_texture.uv_set);
    fuzz.modify(material.normal_scale);
    fuzz.modify(material.occlusion_strength);
    fuzz.modify(material.alpha_mode);
    fuzz.modify(material.alpha_cutoff);
    fuzz.modify(material.double_sided);
    fuzz.modify(material.unlit);
    Lobes lobes;
    if (fuzz.oneIn(2)) lobes.addTo(material, fuzz);
    host.add_material(host.self, &material);
}

void addMesh(Fuzzer& fuzz, const candela_host& host) {
    candela_mesh mesh = samples::mesh();
    mesh.struct_size = fuzz.structSize(mesh.struct_size);
    mesh.vertex_count = fuzz.below(maxElements);
    mesh.index_count = fuzz.oneIn(5) ? fuzz.below(maxElements) : 3 * fuzz.below(maxElements / 3);
    mesh.submesh_count = fuzz.below(4);
    std::array<std::vector<float>, 6> storage;
    mesh.positions = fuzz.array(storage[0], 3 * mesh.vertex_count);
    mesh.normals = fuzz.array(storage[1], 3 * mesh.vertex_count);
    mesh.tangents = fuzz.array(storage[2], 4 * mesh.vertex_count);
    mesh.uv0 = fuzz.array(storage[3], 2 * mesh.vertex_count);
    mesh.uv1 = fuzz.array(storage[4], 2 * mesh.vertex_count);
    mesh.colors = fuzz.array(storage[5], 4 * mesh.vertex_count);
    std::vector<std::uint32_t> sizes, indices;
    if (fuzz.oneIn(2)) {
        mesh.face_count = fuzz.below(6);
        mesh.face_sizes = fuzz.sizes(sizes, mesh.face_count);
        if (!fuzz.oneIn(9)) mesh.index_count = sumOf(sizes);
    }
    mesh.indices = fuzz.indices(indices, mesh.index_count, mesh.vertex_count);
    std::vector<candela_submesh> submeshes(mesh.submesh_count, {0, mesh.index_count, -1});
    for (candela_submesh& submesh : submeshes)
        if (fuzz.oneIn(4)) fuzz.modify(submesh);
    mesh.submeshes = submeshes.data();
    candela_variant_material variant{0, 0, -1};
    if (fuzz.oneIn(4)) host.add_variant(host.self, "look");
    if (fuzz.oneIn(4)) {
        fuzz.modify(variant);
        mesh.variant_material_count = 1;
        mesh.variant_materials = &variant;
    }
    const float* furtherUvs[] = {mesh.uv0, nullptr, mesh.uv1};
    if (fuzz.oneIn(3)) {
        mesh.further_uv_count = fuzz.below(4);
        mesh.further_uvs = furtherUvs;
    }
    host.add_mesh(host.self, &mesh);
}

void addNode(Fuzzer& fuzz, const candela_host& host) {
    candela_node node = samples::node();
    node.struct_size = fuzz.structSize(node.struct_size);
    fuzz.modify(node.parent);
    fuzz.modify(node.translation);
    if (fuzz.oneIn(9)) fuzz.modify(node.rotation);
    fuzz.modify(node.scale);
    fuzz.modify(node.mesh);
    if (fuzz.oneIn(9)) fuzz.modify(node.casts_no_shadow);
    std::array<float, 16> matrix = samples::identity;
    if (fuzz.oneIn(9)) fuzz.modify(matrix);
    if (fuzz.oneIn(3)) node.matrix = matrix.data();
    host.add_node(host.self, &node);
}

void addCamera(Fuzzer& fuzz, const candela_host& host) {
    candela_camera camera = samples::camera();
    camera.struct_size = fuzz.structSize(camera.struct_size);
    fuzz.modify(camera.vertical_fov);
    fuzz.modify(camera.near_plane);
    fuzz.modify(camera.node);
    host.add_camera(host.self, &camera);
}

void addLight(Fuzzer& fuzz, const candela_host& host) {
    candela_light light = samples::light();
    light.struct_size = fuzz.structSize(light.struct_size);
    fuzz.modify(light.type);
    fuzz.modify(light.color);
    fuzz.modify(light.intensity);
    fuzz.modify(light.range);
    fuzz.modify(light.inner_cone_angle);
    fuzz.modify(light.outer_cone_angle);
    fuzz.modify(light.position);
    fuzz.modify(light.direction);
    fuzz.modify(light.node);
    if (fuzz.oneIn(9)) fuzz.modify(light.casts_no_shadow);
    fuzz.modify(light.radius);
    host.add_light(host.self, &light);
}

void addAnimation(Fuzzer& fuzz, const candela_host& host) {
    candela_animation_channel channel = samples::channel;
    fuzz.modify(channel.node);
    fuzz.modify(channel.path);
    fuzz.modify(channel.interpolation);
    channel.key_count = fuzz.below(maxElements);
    std::vector<float> times, values;
    channel.times = fuzz.array(times, channel.key_count);
    for (std::size_t i = 0; i < times.size(); ++i)
        if (!fuzz.oneIn(20)) times[i] = static_cast<float>(i);
    channel.values = fuzz.array(values, 12 * channel.key_count);
    candela_animation animation = samples::animation();
    animation.struct_size = fuzz.structSize(animation.struct_size);
    animation.channel_count = fuzz.below(2);
    animation.channels = fuzz.oneIn(9) ? nullptr : &channel;
    candela_property_channel property{};
    property.property = candela_animated_property(fuzz.below(CANDELA_PROPERTY_FAR_PLANE + 1));
    if (fuzz.oneIn(9)) fuzz.modify(property.property);
    fuzz.modify(property.element);
    property.part = fuzz.below(20);
    fuzz.modify(property.interpolation);
    property.key_count = channel.key_count;
    property.times = channel.times;
    property.values = channel.values;
    animation.property_count = fuzz.below(2);
    animation.properties = fuzz.oneIn(9) ? nullptr : &property;
    host.add_animation(host.self, &animation);
}

void addCage(Fuzzer& fuzz, const candela_host& host) {
    candela_cage cage = samples::cage();
    cage.struct_size = fuzz.structSize(cage.struct_size);
    if (fuzz.oneIn(4)) fuzz.modify(cage.scheme);
    if (fuzz.oneIn(4)) fuzz.modify(cage.boundary_interpolation);
    if (fuzz.oneIn(4)) fuzz.modify(cage.crease_method);
    if (fuzz.oneIn(4)) fuzz.modify(cage.level);
    std::array<std::vector<float>, 6> numbers;
    std::array<std::vector<std::uint32_t>, 7> indices;
    cage.vertex_count = 4 + fuzz.below(maxElements);
    cage.positions = fuzz.array(numbers[0], 3 * cage.vertex_count);
    cage.face_count = fuzz.below(6);
    cage.face_sizes = fuzz.sizes(indices[0], cage.face_count);
    const std::uint32_t corners = sumOf(indices[0]);
    cage.face_vertices = fuzz.indices(indices[1], corners, cage.vertex_count);
    cage.uv_count = fuzz.below(6);
    cage.uvs = fuzz.array(numbers[1], 2 * cage.uv_count);
    cage.face_uvs = fuzz.indices(indices[2], corners, cage.uv_count);
    cage.crease_count = fuzz.below(3);
    cage.crease_edges = fuzz.indices(indices[3], 2 * cage.crease_count, cage.vertex_count);
    cage.crease_sharpness = fuzz.array(numbers[2], cage.crease_count);
    cage.corner_count = fuzz.below(3);
    cage.corner_vertices = fuzz.indices(indices[4], cage.corner_count, cage.vertex_count);
    cage.corner_sharpness = fuzz.array(numbers[3], cage.corner_count);
    cage.hole_count = fuzz.below(3);
    cage.holes = fuzz.indices(indices[5], cage.hole_count, cage.face_count);
    cage.influence_count = fuzz.below(3);
    cage.joints = fuzz.indices(indices[6], cage.influence_count * cage.vertex_count, 3);
    cage.joint_weights = fuzz.array(numbers[4], cage.influence_count * cage.vertex_count);
    for (float& weight : numbers[4])
        if (!fuzz.oneIn(200)) weight = std::abs(weight);
    cage.morph_target_count = fuzz.below(3);
    cage.morph_offsets = fuzz.array(numbers[5], 3 * cage.morph_target_count * cage.vertex_count);
    host.add_cage(host.self, &cage);
}

void addSkin(Fuzzer& fuzz, const candela_host& host) {
    candela_skin skin = samples::skin();
    skin.struct_size = fuzz.structSize(skin.struct_size);
    std::array<std::int32_t, 4> joints{};
    fuzz.modify(joints);
    skin.joint_count = fuzz.below(5);
    skin.joints = joints.data();
    std::array<float, 64> matrices;
    for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] = samples::identity[i % 16];
    if (fuzz.oneIn(9)) fuzz.modify(matrices);
    if (fuzz.oneIn(2)) skin.inverse_bind_matrices = matrices.data();
    host.add_skin(host.self, &skin);
}

void addCageInstance(Fuzzer& fuzz, const candela_host& host) {
    candela_cage_instance instance = samples::cageInstance();
    instance.struct_size = fuzz.structSize(instance.struct_size);
    if (fuzz.oneIn(2)) fuzz.modify(instance.node);
    if (fuzz.oneIn(2)) fuzz.modify(instance.cage);
    if (fuzz.oneIn(2)) fuzz.modify(instance.skin);
    std::vector<float> weights;
    if (fuzz.oneIn(2)) {
        instance.morph_weight_count = fuzz.below(4);
        instance.morph_weights = fuzz.array(weights, instance.morph_weight_count);
    }
    host.add_cage_instance(host.self, &instance);
}

void setEnvironment(Fuzzer& fuzz, const candela_host& host) {
    std::array<float, 32> texels;
    texels.fill(fuzz.oneIn(4) ? fuzz.number() : 1.0f);
    candela_environment environment{};
    environment.struct_size = fuzz.structSize(sizeof environment);
    environment.width = 4;
    environment.height = 2;
    fuzz.modify(environment.width);
    fuzz.modify(environment.height);
    environment.pixels_size = sizeof texels;
    environment.pixels = fuzz.oneIn(9) ? nullptr : texels.data();
    environment.rotation[3] = 1.0f;
    fuzz.modify(environment.rotation);
    environment.intensity = 1.0f;
    fuzz.modify(environment.intensity);
    if (fuzz.oneIn(9)) fuzz.modify(environment.is_hidden);
    fuzz.modify(environment.occlusion_distance);
    host.set_environment(host.self, &environment);
}

using Add = void (*)(Fuzzer&, const candela_host&);
constexpr std::array<Add, 11> adds{addImage,  addMaterial,     addMesh,       addNode,
                                   addCamera, addLight,        addAnimation,  addCage,
                                   addSkin,   addCageInstance, setEnvironment};

// Without these elements cage instances would hardly ever be valid.
void addValidCage(const candela_host& host) {
    const candela_node node = samples::node();
    const candela_cage cage = samples::cage();
    const candela_skin skin = samples::skin();
    for (int i = 0; i < 2; ++i) host.add_node(host.self, &node);
    host.add_cage(host.self, &cage);
    host.add_skin(host.self, &skin);
}

// The scene; none when the host refuses any of it.
std::optional<Scene> importRandomScene(std::uint32_t seed) {
    Fuzzer fuzz(seed);
    ImportHost host("fuzz:" + std::to_string(seed), nullptr, {});
    if (fuzz.oneIn(3)) addValidCage(host.interface());
    const std::uint32_t count = 1 + fuzz.below(6);
    for (std::uint32_t i = 0; i < count; ++i) adds[fuzz.below(adds.size())](fuzz, host.interface());
    try {
        host.rethrowFailure();
        Scene scene = host.takeScene();
        NoteList notes = host.takeNotes();
        addMissingAttributes(scene, notes);
        validate(scene);
        return scene;
    } catch (const Error& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
        return std::nullopt;
    }
}

bool hasCageInstance(const Scene& scene) {
    return std::any_of(scene.nodes.begin(), scene.nodes.end(),
                       [](const Node& node) { return node.cage.has_value(); });
}

TEST(HostFuzz, RandomNumbersNeverCrash) {
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20000);
    std::uint32_t accepted = 0, instances = 0;
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        const auto scene = importRandomScene(seed);
        accepted += scene ? 1 : 0;
        instances += scene && hasCageInstance(*scene) ? 1 : 0;
    }
    // The scenes have to exercise both outcomes.
    EXPECT_GT(accepted, rounds / 50);
    EXPECT_LT(accepted, rounds / 2);
    EXPECT_GT(instances, rounds / 500);
}

}  // namespace
}  // namespace candela
