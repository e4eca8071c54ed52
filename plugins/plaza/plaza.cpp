#include "plaza.h"

#include "count.h"
#include "generator.h"
#include "hash.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace plaza {
namespace {

constexpr float groundSide = 100.0f;  // metres
constexpr std::uint32_t groundQuads = 64;
constexpr std::uint32_t spheresASide = 16;
constexpr float sphereRadius = 0.8f;  // metres
constexpr float lightCandela = 8.0f;
constexpr float lightRange = 3.0f;  // metres
constexpr std::uint32_t lightsBetweenProgress = 4096;

// Properties of an element that are drawn by hash. The numbers are part of the scene: a change makes another
// plaza.
enum Property : std::uint32_t { lightX, lightY, lightZ, lightHue, sphereRed, sphereGreen, sphereBlue };

double between(double low, double high, double share) {
    return low + (high - low) * share;
}

void tellProgress(const candela_host& host, double fraction) {
    if (host.progress(host.self, fraction) != CANDELA_OK) throw HostRefused{};
}

// The pure colour of a hue of [0, 1): one channel is 1, one is 0, one lies between.
std::array<float, 3> hueColor(double hue) {
    const auto channel = [&](double center) {
        const double away = std::abs(hue * 6.0 - center);
        return static_cast<float>(std::clamp(2.0 - std::min(away, 6.0 - away), 0.0, 1.0));
    };
    return {channel(0.0), channel(2.0), channel(4.0)};
}

candela_material plainMaterial(const std::string& name) {
    candela_texture none{};
    none.image = -1;
    candela_material material{};
    material.struct_size = sizeof material;
    material.name = name.c_str();
    material.base_color[3] = 1.0f;
    material.base_color_texture = none;
    material.metallic_roughness_texture = none;
    material.normal_texture = none;
    material.occlusion_texture = none;
    material.emission_texture = none;
    material.normal_scale = 1.0f;
    material.occlusion_strength = 1.0f;
    material.alpha_cutoff = 0.5f;
    return material;
}

int32_t addGroundMaterial(const candela_host& host) {
    const std::string name = "ground";
    candela_material material = plainMaterial(name);
    std::fill_n(material.base_color, 3, 0.75f);
    material.roughness = 0.8f;
    return accepted(host.add_material(host.self, &material));
}

// Roughness grows along x; rows along z take turns between dielectric and metal.
int32_t addSphereMaterial(const candela_host& host, std::uint32_t column, std::uint32_t row,
                          const std::string& name) {
    const std::uint32_t index = row * spheresASide + column;
    candela_material material = plainMaterial(name);
    for (std::uint32_t i = 0; i < 3; ++i)
        material.base_color[i] = static_cast<float>(between(0.2, 0.95, hashedShare(index, sphereRed + i)));
    material.metallic = row % 2 == 0 ? 0.0f : 1.0f;
    material.roughness =
        static_cast<float>(between(0.05, 1.0, static_cast<double>(column) / (spheresASide - 1)));
    return accepted(host.add_material(host.self, &material));
}

int32_t addMesh(const candela_host& host, const Shape& shape, int32_t material, const std::string& name) {
    candela_submesh submesh{};
    submesh.index_count = static_cast<std::uint32_t>(shape.indices.size());
    submesh.material = material;
    candela_mesh mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.name = name.c_str();
    mesh.vertex_count = static_cast<std::uint32_t>(shape.positions.size());
    mesh.positions = shape.positions.front().data();
    mesh.normals = shape.normals.front().data();
    mesh.index_count = submesh.index_count;
    mesh.indices = shape.indices.data();
    mesh.submesh_count = 1;
    mesh.submeshes = &submesh;
    return accepted(host.add_mesh(host.self, &mesh));
}

candela_node plainNode(const std::string& name, int32_t mesh) {
    candela_node node{};
    node.struct_size = sizeof node;
    node.name = name.c_str();
    node.parent = -1;
    node.rotation[3] = 1.0f;
    std::fill_n(node.scale, 3, 1.0f);
    node.mesh = mesh;
    return node;
}

void addGround(const candela_host& host) {
    const std::string name = "ground";
    const int32_t material = addGroundMaterial(host);
    const int32_t mesh = addMesh(host, makeGround(groundSide, groundQuads), material, name);
    const candela_node node = plainNode(name, mesh);
    accepted(host.add_node(host.self, &node));
}

// A submesh carries its material, so every sphere is a mesh of its own: 256 × 20 kB.
void addSpheres(const candela_host& host) {
    const Shape shape = makeSphere(sphereRadius, 32, 16);
    const auto center = [](std::uint32_t i) {
        return static_cast<float>(groundSide * ((i + 0.5) / spheresASide - 0.5));
    };
    for (std::uint32_t row = 0; row < spheresASide; ++row)
        for (std::uint32_t column = 0; column < spheresASide; ++column) {
            const std::string name = "sphere " + std::to_string(column) + "," + std::to_string(row);
            const int32_t material = addSphereMaterial(host, column, row, name);
            candela_node node = plainNode(name, addMesh(host, shape, material, name));
            node.translation[0] = center(column);
            node.translation[1] = sphereRadius;
            node.translation[2] = center(row);
            accepted(host.add_node(host.self, &node));
        }
}

// At (0, 12, 45), looking at the origin: turned about x by the angle whose cosine is 45 / |eye|. Square roots
// and divisions round the same everywhere.
void addCamera(const candela_host& host) {
    constexpr double height = 12.0, distance = 45.0;
    const double cosine = distance / std::sqrt(height * height + distance * distance);
    const std::string name = "camera";
    candela_node node = plainNode(name, -1);
    node.translation[1] = static_cast<float>(height);
    node.translation[2] = static_cast<float>(distance);
    node.rotation[0] = static_cast<float>(-std::sqrt((1.0 - cosine) / 2.0));
    node.rotation[3] = static_cast<float>(std::sqrt((1.0 + cosine) / 2.0));
    candela_camera camera{};
    camera.struct_size = sizeof camera;
    camera.name = name.c_str();
    camera.vertical_fov = 0.785398163f;
    camera.node = accepted(host.add_node(host.self, &node));
    accepted(host.add_camera(host.self, &camera));
}

candela_light lightAt(std::uint32_t index) {
    const auto drawn = [&](Property property, double low, double high) {
        return static_cast<float>(between(low, high, hashedShare(index, property)));
    };
    candela_light light{};
    light.struct_size = sizeof light;
    light.type = CANDELA_LIGHT_POINT;
    light.intensity = lightCandela;
    light.range = lightRange;
    light.position[0] = drawn(lightX, -48.0, 48.0);
    light.position[1] = drawn(lightY, 0.3, 3.0);
    light.position[2] = drawn(lightZ, -48.0, 48.0);
    const std::array<float, 3> color = hueColor(hashedShare(index, lightHue));
    std::copy(color.begin(), color.end(), light.color);
    light.node = -1;
    return light;
}

void addLights(const candela_host& host, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % lightsBetweenProgress == 0) tellProgress(host, static_cast<double>(i) / count);
        const candela_light light = lightAt(i);
        accepted(host.add_light(host.self, &light));
    }
}

}  // namespace

void makePlaza(const candela_host& host, const std::string& arguments) {
    const std::uint32_t lights = parseCount(arguments, "number of lights", "plaza:4096");
    addGround(host);
    addSpheres(host);
    addCamera(host);
    addLights(host, lights);
    tellProgress(host, 1.0);
}

}  // namespace plaza
