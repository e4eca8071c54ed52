#include "scene_builder.h"

#include <algorithm>
#include <cmath>

namespace candela_plugins::plaza {

namespace {

bool parseDigits(const std::string& digits, const CountRange& range, std::uint32_t& count) {
    if (digits.empty()) return false;
    std::uint64_t value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return false;
        value = value * 10 + static_cast<std::uint64_t>(c - '0');
        if (value > range.max) return false;
    }
    count = static_cast<std::uint32_t>(value);
    return count >= range.min;
}

}  // namespace

std::uint32_t parseCount(const std::string& text, const std::string& element, const std::string& example,
                         const CountRange& range) {
    std::uint32_t count = 0;
    if (!parseDigits(text, range, count))
        throw Failure{element, "'" + text + "' is not a whole number from " + std::to_string(range.min) +
                                   " to " + std::to_string(range.max) + ", as in " + example};
    return count;
}

double between(double low, double high, double fraction) {
    return low + (high - low) * fraction;
}

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

int32_t addGreyMaterial(const Host& host, const std::string& name, float grey, float roughness) {
    candela_material material = plainMaterial(name);
    std::fill_n(material.base_color, 3, grey);
    material.roughness = roughness;
    return host.add(material);
}

int32_t addMesh(const Host& host, const Geometry& geometry, int32_t material, const std::string& name) {
    candela_submesh submesh{};
    submesh.index_count = static_cast<std::uint32_t>(geometry.indices.size());
    submesh.material = material;
    candela_mesh mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.name = name.c_str();
    mesh.vertex_count = static_cast<std::uint32_t>(geometry.positions.size());
    mesh.positions = geometry.positions.front().data();
    mesh.normals = geometry.normals.front().data();
    mesh.index_count = submesh.index_count;
    mesh.indices = geometry.indices.data();
    mesh.submesh_count = 1;
    mesh.submeshes = &submesh;
    return host.add(mesh);
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

void addGeometry(const Host& host, const Geometry& geometry, int32_t material, const std::string& name) {
    const candela_node node = plainNode(name, addMesh(host, geometry, material, name));
    host.add(node);
}

void addCamera(const Host& host, const candela_node& node) {
    candela_camera camera{};
    camera.struct_size = sizeof camera;
    camera.name = node.name;
    camera.vertical_fov = 0.785398163f;
    camera.node = host.add(node);
    host.add(camera);
}

// Rotated about x by the angle whose cosine is distance / |eye|. Square roots and divisions round the same on
// every machine.
void addCameraAt(const Host& host, double height, double distance) {
    const double cosine = distance / std::sqrt(height * height + distance * distance);
    const std::string name = "camera";
    candela_node node = plainNode(name, -1);
    node.translation[1] = static_cast<float>(height);
    node.translation[2] = static_cast<float>(distance);
    node.rotation[0] = static_cast<float>(-std::sqrt((1.0 - cosine) / 2.0));
    node.rotation[3] = static_cast<float>(std::sqrt((1.0 + cosine) / 2.0));
    addCamera(host, node);
}

candela_light plainLight(float candela, float range) {
    candela_light light{};
    light.struct_size = sizeof light;
    light.type = CANDELA_LIGHT_POINT;
    light.intensity = candela;
    light.range = range;
    light.node = -1;
    return light;
}

}  // namespace candela_plugins::plaza
