#pragma once

#include <candela/plugin.h>

#include <array>
#include <cstdint>

// Valid structs, to be modified one member at a time. They point to constant arrays.
namespace samples {

inline constexpr std::array<float, 12> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
inline constexpr std::array<float, 12> normals{0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0, 1};
inline constexpr std::array<float, 16> tangents{1, 0, 0, 1, 2, 0, 0, -1, 1, 0, 0, 1, 1, 0, 0, 1};
inline constexpr std::array<float, 8> uvs{0, 0, 1, 0, 1, 1, 0, 1};
inline constexpr std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
inline constexpr candela_submesh submesh{0, 6, -1};
inline constexpr std::array<std::uint8_t, 16> texels{};
inline constexpr std::array<float, 16> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
inline constexpr std::array<float, 2> times{0, 1};
inline constexpr std::array<float, 6> values{0, 0, 0, 1, 1, 1};
inline constexpr candela_animation_channel channel{
    0, CANDELA_ANIMATE_TRANSLATION, CANDELA_INTERPOLATE_LINEAR, 2, times.data(), values.data()};

// Two quads side by side:  3 4 5
//                          0 1 2
inline constexpr std::array<float, 18> cagePositions{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
inline constexpr std::array<float, 12> cageUvs{0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1};
inline constexpr std::array<std::uint32_t, 2> faceSizes{4, 4};
inline constexpr std::array<std::uint32_t, 8> faceVertices{0, 1, 4, 3, 1, 2, 5, 4};
inline constexpr std::array<std::uint32_t, 2> creaseEdge{1, 4};
inline constexpr std::array<float, 1> creaseSharpness{2.5f};
inline constexpr std::array<std::uint32_t, 1> cornerVertex{3};
inline constexpr std::array<float, 1> cornerSharpness{10.0f};
inline constexpr std::array<std::uint32_t, 1> hole{1};
inline constexpr std::array<std::uint32_t, 12> joints{0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
inline constexpr std::array<float, 12> jointWeights{1, 0, 1, 3, 0, 1, 1, 0, 1, 3, 0, 1};
inline constexpr std::array<float, 36> morphOffsets{1, 2, 3};
inline constexpr std::array<std::int32_t, 2> skinJoints{0, 1};
inline constexpr std::array<float, 2> morphWeights{0.25f, 0.5f};

/// 2 × 2 texels of RGBA8.
inline candela_image image() {
    candela_image image{};
    image.struct_size = sizeof image;
    image.name = "checks";
    image.width = image.height = 2;
    image.pixels = texels.data();
    image.pixels_size = texels.size();
    return image;
}

inline candela_texture texture(std::int32_t index) {
    candela_texture texture{};
    texture.image = index;
    texture.scale[0] = texture.scale[1] = 1.0f;
    return texture;
}

inline candela_material material() {
    candela_material material{};
    material.struct_size = sizeof material;
    material.name = "paint";
    material.base_color[3] = 1.0f;
    material.roughness = 0.5f;
    material.base_color_texture = material.metallic_roughness_texture = material.normal_texture =
        material.occlusion_texture = material.emission_texture = texture(-1);
    material.normal_scale = material.occlusion_strength = 1.0f;
    return material;
}

/// A square of two triangles with positions and normals.
inline candela_mesh mesh() {
    candela_mesh mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.name = "wheel";
    mesh.vertex_count = 4;
    mesh.positions = positions.data();
    mesh.normals = normals.data();
    mesh.index_count = indices.size();
    mesh.indices = indices.data();
    mesh.submesh_count = 1;
    mesh.submeshes = &submesh;
    return mesh;
}

inline candela_node node() {
    candela_node node{};
    node.struct_size = sizeof node;
    node.name = "axle";
    node.parent = node.mesh = -1;
    node.rotation[3] = 1.0f;
    node.scale[0] = node.scale[1] = node.scale[2] = 1.0f;
    return node;
}

inline candela_camera camera() {
    candela_camera camera{};
    camera.struct_size = sizeof camera;
    camera.name = "front";
    camera.vertical_fov = 1.0f;
    camera.node = -1;
    return camera;
}

/// A spot light, which uses every member.
inline candela_light light() {
    candela_light light{};
    light.struct_size = sizeof light;
    light.name = "lamp";
    light.type = CANDELA_LIGHT_SPOT;
    light.color[0] = light.color[1] = light.color[2] = 1.0f;
    light.intensity = 8.0f;
    light.outer_cone_angle = 0.5f;
    light.direction[2] = -3.0f;
    light.node = -1;
    light.casts_no_shadow = 1;
    light.radius = 0.125f;
    return light;
}

/// Animates node 0, which has to exist.
inline candela_animation animation() {
    candela_animation animation{};
    animation.struct_size = sizeof animation;
    animation.name = "roll";
    animation.channel_count = 1;
    animation.channels = &channel;
    return animation;
}

/// A cage with all members but materials; the first of two morph targets moves vertex 0.
inline candela_cage cage() {
    candela_cage cage{};
    cage.struct_size = sizeof cage;
    cage.name = "body";
    cage.boundary_interpolation = CANDELA_BOUNDARY_EDGES_AND_CORNERS;
    cage.face_varying_interpolation = CANDELA_FACE_VARYING_CORNERS_ONLY;
    cage.vertex_count = 6;
    cage.positions = cagePositions.data();
    cage.face_count = faceSizes.size();
    cage.face_sizes = faceSizes.data();
    cage.face_vertices = faceVertices.data();
    cage.uv_count = 6;
    cage.uvs = cageUvs.data();
    cage.face_uvs = faceVertices.data();
    cage.crease_count = 1;
    cage.crease_edges = creaseEdge.data();
    cage.crease_sharpness = creaseSharpness.data();
    cage.corner_count = 1;
    cage.corner_vertices = cornerVertex.data();
    cage.corner_sharpness = cornerSharpness.data();
    cage.hole_count = 1;
    cage.holes = hole.data();
    cage.level = 2;
    cage.influence_count = 2;
    cage.joints = joints.data();
    cage.joint_weights = jointWeights.data();
    cage.morph_target_count = 2;
    cage.morph_offsets = morphOffsets.data();
    return cage;
}

/// With nodes 0 and 1 as joints, which have to exist.
inline candela_skin skin() {
    candela_skin skin{};
    skin.struct_size = sizeof skin;
    skin.name = "rig";
    skin.joint_count = skinJoints.size();
    skin.joints = skinJoints.data();
    return skin;
}

/// Cage 0 with skin 0 at node 0, which have to exist.
inline candela_cage_instance cageInstance() {
    candela_cage_instance instance{};
    instance.struct_size = sizeof instance;
    instance.morph_weight_count = morphWeights.size();
    instance.morph_weights = morphWeights.data();
    return instance;
}

}  // namespace samples
