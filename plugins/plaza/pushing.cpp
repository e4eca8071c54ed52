#include "pushing.h"

#include <algorithm>
#include <cmath>

namespace plaza {

double between(double low, double high, double share) {
    return low + (high - low) * share;
}

std::array<float, 3> hueColor(double hue) {
    const auto channel = [&](double center) {
        const double away = std::abs(hue * 6.0 - center);
        return static_cast<float>(std::clamp(2.0 - std::min(away, 6.0 - away), 0.0, 1.0));
    };
    return {channel(0.0), channel(2.0), channel(4.0)};
}

void tellProgress(const candela_host& host, double fraction) {
    if (host.progress(host.self, fraction) != CANDELA_OK) throw HostRefused{};
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

int32_t addGreyMaterial(const candela_host& host, const std::string& name, float grey, float roughness) {
    candela_material material = plainMaterial(name);
    std::fill_n(material.base_color, 3, grey);
    material.roughness = roughness;
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

void addShape(const candela_host& host, const Shape& shape, int32_t material, const std::string& name) {
    const candela_node node = plainNode(name, addMesh(host, shape, material, name));
    accepted(host.add_node(host.self, &node));
}

void addCamera(const candela_host& host, const candela_node& node) {
    candela_camera camera{};
    camera.struct_size = sizeof camera;
    camera.name = node.name;
    camera.vertical_fov = 0.785398163f;
    camera.node = accepted(host.add_node(host.self, &node));
    accepted(host.add_camera(host.self, &camera));
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

}  // namespace plaza
