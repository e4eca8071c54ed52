// Random bytes in all numbers of all pushed structs: the host refuses or takes them, and never crashes. The
// arrays are as long as the counts say, for a plugin that lies about those can not be helped.
#include "pushed_samples.h"

#include "import/finish_scene.h"
#include "import/host.h"

#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>
#include <vector>

namespace candela {
namespace {

constexpr std::uint32_t maxElements = 24;

class Fuzzer {
  public:
    explicit Fuzzer(std::uint32_t seed) : random_(seed) {}

    bool oneIn(std::uint32_t chances) { return below(chances) == 0; }
    std::uint32_t below(std::uint32_t count) { return any() % count; }

    // Mostly numbers that get past a first check, some of all bits, some on an edge.
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
    void spoil(T& member) {
        static_assert(sizeof(T) % 4 == 0 && std::is_trivially_copyable_v<T>);
        if (!oneIn(3)) return;
        for (std::size_t offset = 0; offset < sizeof(T); offset += 4) {
            const std::uint32_t source = bits();
            std::memcpy(reinterpret_cast<char*>(&member) + offset, &source, 4);
        }
    }

    // NULL now and then; mostly finite numbers, so that the rest is reached too.
    const float* array(std::vector<float>& storage, std::size_t count) {
        if (oneIn(6)) return nullptr;
        storage.resize(count);
        for (float& value : storage) value = oneIn(200) ? number() : static_cast<float>(below(9)) - 4.0f;
        return storage.data();
    }

    std::uint32_t structSize(std::uint32_t size) { return oneIn(20) ? bits() % (size + 1) : size; }

  private:
    std::uint32_t any() { return static_cast<std::uint32_t>(random_()); }

    std::mt19937 random_;
};

void pushImage(Fuzzer& fuzz, const candela_host& host) {
    std::array<std::uint8_t, 256> texels;
    texels.fill(static_cast<std::uint8_t>(fuzz.bits()));
    candela_image image = samples::image();
    image.struct_size = fuzz.structSize(image.struct_size);
    fuzz.spoil(image.width);
    fuzz.spoil(image.height);
    fuzz.spoil(image.format);
    fuzz.spoil(image.pixels_size);
    if (image.pixels_size > texels.size()) image.pixels_size = texels.size();
    image.pixels = fuzz.oneIn(9) ? nullptr : texels.data();
    host.add_image(host.self, &image);
}

void pushMaterial(Fuzzer& fuzz, const candela_host& host) {
    candela_material material = samples::material();
    material.struct_size = fuzz.structSize(material.struct_size);
    fuzz.spoil(material.base_color);
    fuzz.spoil(material.metallic);
    fuzz.spoil(material.roughness);
    fuzz.spoil(material.emission);
    fuzz.spoil(material.normal_texture);
    fuzz.spoil(material.emission_texture.image);
    fuzz.spoil(material.emission_texture.uv_set);
    fuzz.spoil(material.normal_scale);
    fuzz.spoil(material.occlusion_strength);
    fuzz.spoil(material.alpha_mode);
    fuzz.spoil(material.alpha_cutoff);
    fuzz.spoil(material.double_sided);
    fuzz.spoil(material.unlit);
    host.add_material(host.self, &material);
}

void pushMesh(Fuzzer& fuzz, const candela_host& host) {
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
    std::vector<std::uint32_t> indices(mesh.index_count);
    for (std::uint32_t& index : indices)
        index = fuzz.oneIn(50) ? fuzz.bits() : fuzz.below(std::max(mesh.vertex_count, 1u));
    mesh.indices = indices.data();
    std::vector<candela_submesh> submeshes(mesh.submesh_count, {0, mesh.index_count, -1});
    for (candela_submesh& submesh : submeshes)
        if (fuzz.oneIn(4)) fuzz.spoil(submesh);
    mesh.submeshes = submeshes.data();
    host.add_mesh(host.self, &mesh);
}

void pushNode(Fuzzer& fuzz, const candela_host& host) {
    candela_node node = samples::node();
    node.struct_size = fuzz.structSize(node.struct_size);
    fuzz.spoil(node.parent);
    fuzz.spoil(node.translation);
    if (fuzz.oneIn(9)) fuzz.spoil(node.rotation);
    fuzz.spoil(node.scale);
    fuzz.spoil(node.mesh);
    std::array<float, 16> matrix = samples::identity;
    if (fuzz.oneIn(9)) fuzz.spoil(matrix);
    if (fuzz.oneIn(3)) node.matrix = matrix.data();
    host.add_node(host.self, &node);
}

void pushCamera(Fuzzer& fuzz, const candela_host& host) {
    candela_camera camera = samples::camera();
    camera.struct_size = fuzz.structSize(camera.struct_size);
    fuzz.spoil(camera.vertical_fov);
    fuzz.spoil(camera.near_plane);
    fuzz.spoil(camera.node);
    host.add_camera(host.self, &camera);
}

void pushLight(Fuzzer& fuzz, const candela_host& host) {
    candela_light light = samples::light();
    light.struct_size = fuzz.structSize(light.struct_size);
    fuzz.spoil(light.type);
    fuzz.spoil(light.color);
    fuzz.spoil(light.intensity);
    fuzz.spoil(light.range);
    fuzz.spoil(light.inner_cone_angle);
    fuzz.spoil(light.outer_cone_angle);
    fuzz.spoil(light.position);
    fuzz.spoil(light.direction);
    fuzz.spoil(light.node);
    host.add_light(host.self, &light);
}

void pushAnimation(Fuzzer& fuzz, const candela_host& host) {
    candela_animation_channel channel = samples::channel;
    fuzz.spoil(channel.node);
    fuzz.spoil(channel.path);
    fuzz.spoil(channel.interpolation);
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
    host.add_animation(host.self, &animation);
}

using Push = void (*)(Fuzzer&, const candela_host&);
constexpr std::array<Push, 7> pushes{pushImage,  pushMaterial, pushMesh,     pushNode,
                                     pushCamera, pushLight,    pushAnimation};

// True when the whole scene was taken.
bool importRandomScene(std::uint32_t seed) {
    Fuzzer fuzz(seed);
    ImportHost host("fuzz:" + std::to_string(seed), nullptr, {});
    const std::uint32_t count = 1 + fuzz.below(6);
    for (std::uint32_t i = 0; i < count; ++i) pushes[fuzz.below(pushes.size())](fuzz, host.interface());
    try {
        host.rethrowFailure();
        Scene scene = host.takeScene();
        std::vector<std::string> notes = host.takeNotes();
        addMissingAttributes(scene, notes);
        validate(scene);
        return true;
    } catch (const Error& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
        return false;
    }
}

TEST(HostFuzz, RandomNumbersNeverCrash) {
    constexpr std::uint32_t rounds = 20000;
    std::uint32_t taken = 0;
    for (std::uint32_t seed = 0; seed < rounds; ++seed) taken += importRandomScene(seed) ? 1 : 0;
    // A fuzzer whose scenes are all refused at the first number, or none of them, would test little.
    EXPECT_GT(taken, rounds / 50);
    EXPECT_LT(taken, rounds / 2);
}

}  // namespace
}  // namespace candela
