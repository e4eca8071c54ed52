// The binary layout of plugin.h, which plugins and hosts of different versions share. Names may change.
// Structs may only grow at their end, and only those that begin with struct_size: then a line is added here.
#include <candela/plugin.h>

#include <cstddef>

static_assert(sizeof(void*) == 8, "the offsets below are those of 64-bit platforms");

// clang-format off
static_assert(offsetof(candela_image, struct_size) == 0);
static_assert(offsetof(candela_image, name) == 8);
static_assert(offsetof(candela_image, width) == 16);
static_assert(offsetof(candela_image, height) == 20);
static_assert(offsetof(candela_image, format) == 24);
static_assert(offsetof(candela_image, pixels) == 32);
static_assert(offsetof(candela_image, pixels_size) == 40);
static_assert(sizeof(candela_image) == 48);

static_assert(offsetof(candela_texture, image) == 0);
static_assert(offsetof(candela_texture, uv_set) == 4);
static_assert(offsetof(candela_texture, wrap_s) == 8);
static_assert(offsetof(candela_texture, wrap_t) == 12);
static_assert(offsetof(candela_texture, min_filter) == 16);
static_assert(offsetof(candela_texture, mag_filter) == 20);
static_assert(offsetof(candela_texture, offset) == 24);
static_assert(offsetof(candela_texture, rotation) == 32);
static_assert(offsetof(candela_texture, scale) == 36);
static_assert(sizeof(candela_texture) == 44);

static_assert(offsetof(candela_material, struct_size) == 0);
static_assert(offsetof(candela_material, name) == 8);
static_assert(offsetof(candela_material, base_color) == 16);
static_assert(offsetof(candela_material, metallic) == 32);
static_assert(offsetof(candela_material, roughness) == 36);
static_assert(offsetof(candela_material, emission) == 40);
static_assert(offsetof(candela_material, base_color_texture) == 52);
static_assert(offsetof(candela_material, metallic_roughness_texture) == 96);
static_assert(offsetof(candela_material, normal_texture) == 140);
static_assert(offsetof(candela_material, occlusion_texture) == 184);
static_assert(offsetof(candela_material, emission_texture) == 228);
static_assert(offsetof(candela_material, normal_scale) == 272);
static_assert(offsetof(candela_material, occlusion_strength) == 276);
static_assert(offsetof(candela_material, alpha_mode) == 280);
static_assert(offsetof(candela_material, alpha_cutoff) == 284);
static_assert(offsetof(candela_material, double_sided) == 288);
static_assert(offsetof(candela_material, unlit) == 292);
static_assert(offsetof(candela_material, ior) == 296);
static_assert(offsetof(candela_material, specular) == 304);
static_assert(offsetof(candela_material, clearcoat) == 312);
static_assert(offsetof(candela_material, sheen) == 320);
static_assert(offsetof(candela_material, anisotropy) == 328);
static_assert(offsetof(candela_material, iridescence) == 336);
static_assert(offsetof(candela_material, transmission) == 344);
static_assert(offsetof(candela_material, volume) == 352);
static_assert(offsetof(candela_material, diffuse_transmission) == 360);
static_assert(offsetof(candela_material, emission_strength) == 368);
static_assert(sizeof(candela_material) == 376);

static_assert(offsetof(candela_specular, factor) == 0);
static_assert(offsetof(candela_specular, color) == 4);
static_assert(offsetof(candela_specular, texture) == 16);
static_assert(offsetof(candela_specular, color_texture) == 24);
static_assert(sizeof(candela_specular) == 32);

static_assert(offsetof(candela_clearcoat, factor) == 0);
static_assert(offsetof(candela_clearcoat, roughness) == 4);
static_assert(offsetof(candela_clearcoat, normal_scale) == 8);
static_assert(offsetof(candela_clearcoat, texture) == 16);
static_assert(offsetof(candela_clearcoat, roughness_texture) == 24);
static_assert(offsetof(candela_clearcoat, normal_texture) == 32);
static_assert(sizeof(candela_clearcoat) == 40);

static_assert(offsetof(candela_sheen, color) == 0);
static_assert(offsetof(candela_sheen, roughness) == 12);
static_assert(offsetof(candela_sheen, color_texture) == 16);
static_assert(offsetof(candela_sheen, roughness_texture) == 24);
static_assert(sizeof(candela_sheen) == 32);

static_assert(offsetof(candela_anisotropy, strength) == 0);
static_assert(offsetof(candela_anisotropy, rotation) == 4);
static_assert(offsetof(candela_anisotropy, texture) == 8);
static_assert(sizeof(candela_anisotropy) == 16);

static_assert(offsetof(candela_iridescence, factor) == 0);
static_assert(offsetof(candela_iridescence, ior) == 4);
static_assert(offsetof(candela_iridescence, min_thickness) == 8);
static_assert(offsetof(candela_iridescence, max_thickness) == 12);
static_assert(offsetof(candela_iridescence, texture) == 16);
static_assert(offsetof(candela_iridescence, thickness_texture) == 24);
static_assert(sizeof(candela_iridescence) == 32);

static_assert(offsetof(candela_transmission, factor) == 0);
static_assert(offsetof(candela_transmission, texture) == 8);
static_assert(sizeof(candela_transmission) == 16);

static_assert(offsetof(candela_volume, thickness) == 0);
static_assert(offsetof(candela_volume, attenuation_distance) == 4);
static_assert(offsetof(candela_volume, attenuation_color) == 8);
static_assert(offsetof(candela_volume, dispersion) == 20);
static_assert(offsetof(candela_volume, thickness_texture) == 24);
static_assert(sizeof(candela_volume) == 32);

static_assert(offsetof(candela_diffuse_transmission, factor) == 0);
static_assert(offsetof(candela_diffuse_transmission, color) == 4);
static_assert(offsetof(candela_diffuse_transmission, texture) == 16);
static_assert(offsetof(candela_diffuse_transmission, color_texture) == 24);
static_assert(sizeof(candela_diffuse_transmission) == 32);

static_assert(offsetof(candela_submesh, first_index) == 0);
static_assert(offsetof(candela_submesh, index_count) == 4);
static_assert(offsetof(candela_submesh, material) == 8);
static_assert(sizeof(candela_submesh) == 12);

static_assert(offsetof(candela_variant_material, submesh) == 0);
static_assert(offsetof(candela_variant_material, variant) == 4);
static_assert(offsetof(candela_variant_material, material) == 8);
static_assert(sizeof(candela_variant_material) == 12);

static_assert(offsetof(candela_mesh, struct_size) == 0);
static_assert(offsetof(candela_mesh, name) == 8);
static_assert(offsetof(candela_mesh, vertex_count) == 16);
static_assert(offsetof(candela_mesh, positions) == 24);
static_assert(offsetof(candela_mesh, normals) == 32);
static_assert(offsetof(candela_mesh, tangents) == 40);
static_assert(offsetof(candela_mesh, uv0) == 48);
static_assert(offsetof(candela_mesh, uv1) == 56);
static_assert(offsetof(candela_mesh, colors) == 64);
static_assert(offsetof(candela_mesh, index_count) == 72);
static_assert(offsetof(candela_mesh, indices) == 80);
static_assert(offsetof(candela_mesh, submesh_count) == 88);
static_assert(offsetof(candela_mesh, submeshes) == 96);
static_assert(offsetof(candela_mesh, face_count) == 104);
static_assert(offsetof(candela_mesh, face_sizes) == 112);
static_assert(offsetof(candela_mesh, influence_count) == 120);
static_assert(offsetof(candela_mesh, joints) == 128);
static_assert(offsetof(candela_mesh, joint_weights) == 136);
static_assert(offsetof(candela_mesh, morph_target_count) == 144);
static_assert(offsetof(candela_mesh, morph_offsets) == 152);
static_assert(offsetof(candela_mesh, morph_normals) == 160);
static_assert(offsetof(candela_mesh, morph_tangents) == 168);
static_assert(offsetof(candela_mesh, variant_material_count) == 176);
static_assert(offsetof(candela_mesh, variant_materials) == 184);
static_assert(offsetof(candela_mesh, topologies) == 192);
static_assert(offsetof(candela_mesh, further_uv_count) == 200);
static_assert(offsetof(candela_mesh, further_uvs) == 208);
static_assert(offsetof(candela_mesh, crease_angle) == 216);
static_assert(offsetof(candela_mesh, is_moved) == 220);
static_assert(sizeof(candela_mesh) == 224);

static_assert(offsetof(candela_cage_variant, variant) == 0);
static_assert(offsetof(candela_cage_variant, face_materials) == 8);
static_assert(sizeof(candela_cage_variant) == 16);

static_assert(offsetof(candela_cage, struct_size) == 0);
static_assert(offsetof(candela_cage, name) == 8);
static_assert(offsetof(candela_cage, scheme) == 16);
static_assert(offsetof(candela_cage, boundary_interpolation) == 20);
static_assert(offsetof(candela_cage, face_varying_interpolation) == 24);
static_assert(offsetof(candela_cage, crease_method) == 28);
static_assert(offsetof(candela_cage, triangle_subdivision) == 32);
static_assert(offsetof(candela_cage, vertex_count) == 36);
static_assert(offsetof(candela_cage, positions) == 40);
static_assert(offsetof(candela_cage, face_count) == 48);
static_assert(offsetof(candela_cage, face_sizes) == 56);
static_assert(offsetof(candela_cage, face_vertices) == 64);
static_assert(offsetof(candela_cage, uv_count) == 72);
static_assert(offsetof(candela_cage, uvs) == 80);
static_assert(offsetof(candela_cage, face_uvs) == 88);
static_assert(offsetof(candela_cage, crease_count) == 96);
static_assert(offsetof(candela_cage, crease_edges) == 104);
static_assert(offsetof(candela_cage, crease_sharpness) == 112);
static_assert(offsetof(candela_cage, corner_count) == 120);
static_assert(offsetof(candela_cage, corner_vertices) == 128);
static_assert(offsetof(candela_cage, corner_sharpness) == 136);
static_assert(offsetof(candela_cage, hole_count) == 144);
static_assert(offsetof(candela_cage, holes) == 152);
static_assert(offsetof(candela_cage, face_materials) == 160);
static_assert(offsetof(candela_cage, level) == 168);
static_assert(offsetof(candela_cage, influence_count) == 172);
static_assert(offsetof(candela_cage, joints) == 176);
static_assert(offsetof(candela_cage, joint_weights) == 184);
static_assert(offsetof(candela_cage, morph_target_count) == 192);
static_assert(offsetof(candela_cage, morph_offsets) == 200);
static_assert(offsetof(candela_cage, variant_count) == 208);
static_assert(offsetof(candela_cage, variants) == 216);
static_assert(offsetof(candela_cage, is_moved) == 224);
static_assert(sizeof(candela_cage) == 232);

static_assert(offsetof(candela_skin, struct_size) == 0);
static_assert(offsetof(candela_skin, name) == 8);
static_assert(offsetof(candela_skin, joint_count) == 16);
static_assert(offsetof(candela_skin, joints) == 24);
static_assert(offsetof(candela_skin, inverse_bind_matrices) == 32);
static_assert(sizeof(candela_skin) == 40);

static_assert(offsetof(candela_cage_instance, struct_size) == 0);
static_assert(offsetof(candela_cage_instance, node) == 4);
static_assert(offsetof(candela_cage_instance, cage) == 8);
static_assert(offsetof(candela_cage_instance, skin) == 12);
static_assert(offsetof(candela_cage_instance, morph_weight_count) == 16);
static_assert(offsetof(candela_cage_instance, morph_weights) == 24);
static_assert(sizeof(candela_cage_instance) == 32);

static_assert(offsetof(candela_deformation, struct_size) == 0);
static_assert(offsetof(candela_deformation, node) == 4);
static_assert(offsetof(candela_deformation, skin) == 8);
static_assert(offsetof(candela_deformation, morph_weight_count) == 12);
static_assert(offsetof(candela_deformation, morph_weights) == 16);
static_assert(sizeof(candela_deformation) == 24);

static_assert(offsetof(candela_camera, struct_size) == 0);
static_assert(offsetof(candela_camera, name) == 8);
static_assert(offsetof(candela_camera, vertical_fov) == 16);
static_assert(offsetof(candela_camera, near_plane) == 20);
static_assert(offsetof(candela_camera, node) == 24);
static_assert(offsetof(candela_camera, unused) == 28);
static_assert(offsetof(candela_camera, number) == 32);
static_assert(offsetof(candela_camera, orthographic_height) == 36);
static_assert(offsetof(candela_camera, far_plane) == 40);
static_assert(sizeof(candela_camera) == 48);

static_assert(offsetof(candela_light, struct_size) == 0);
static_assert(offsetof(candela_light, name) == 8);
static_assert(offsetof(candela_light, type) == 16);
static_assert(offsetof(candela_light, color) == 20);
static_assert(offsetof(candela_light, intensity) == 32);
static_assert(offsetof(candela_light, range) == 36);
static_assert(offsetof(candela_light, inner_cone_angle) == 40);
static_assert(offsetof(candela_light, outer_cone_angle) == 44);
static_assert(offsetof(candela_light, position) == 48);
static_assert(offsetof(candela_light, direction) == 60);
static_assert(offsetof(candela_light, node) == 72);
static_assert(offsetof(candela_light, unused) == 76);
static_assert(offsetof(candela_light, casts_no_shadow) == 80);
static_assert(offsetof(candela_light, radius) == 84);
static_assert(sizeof(candela_light) == 88);

static_assert(offsetof(candela_environment, struct_size) == 0);
static_assert(offsetof(candela_environment, name) == 8);
static_assert(offsetof(candela_environment, width) == 16);
static_assert(offsetof(candela_environment, height) == 20);
static_assert(offsetof(candela_environment, pixels) == 24);
static_assert(offsetof(candela_environment, pixels_size) == 32);
static_assert(offsetof(candela_environment, rotation) == 40);
static_assert(offsetof(candela_environment, intensity) == 56);
static_assert(offsetof(candela_environment, is_hidden) == 60);
static_assert(offsetof(candela_environment, occlusion_distance) == 64);
static_assert(sizeof(candela_environment) == 72);

static_assert(offsetof(candela_node, struct_size) == 0);
static_assert(offsetof(candela_node, name) == 8);
static_assert(offsetof(candela_node, parent) == 16);
static_assert(offsetof(candela_node, translation) == 20);
static_assert(offsetof(candela_node, rotation) == 32);
static_assert(offsetof(candela_node, scale) == 48);
static_assert(offsetof(candela_node, matrix) == 64);
static_assert(offsetof(candela_node, mesh) == 72);
static_assert(offsetof(candela_node, unused) == 76);
static_assert(offsetof(candela_node, translation_remainder) == 80);
static_assert(offsetof(candela_node, casts_no_shadow) == 104);
static_assert(offsetof(candela_node, unused_1_4) == 108);
static_assert(offsetof(candela_node, is_hidden) == 112);
static_assert(sizeof(candela_node) == 120);

static_assert(offsetof(candela_animation_channel, node) == 0);
static_assert(offsetof(candela_animation_channel, path) == 4);
static_assert(offsetof(candela_animation_channel, interpolation) == 8);
static_assert(offsetof(candela_animation_channel, key_count) == 12);
static_assert(offsetof(candela_animation_channel, times) == 16);
static_assert(offsetof(candela_animation_channel, values) == 24);
static_assert(sizeof(candela_animation_channel) == 32);

static_assert(offsetof(candela_animation, struct_size) == 0);
static_assert(offsetof(candela_animation, name) == 8);
static_assert(offsetof(candela_animation, channel_count) == 16);
static_assert(offsetof(candela_animation, channels) == 24);
static_assert(offsetof(candela_animation, property_count) == 32);
static_assert(offsetof(candela_animation, properties) == 40);
static_assert(sizeof(candela_animation) == 48);

static_assert(offsetof(candela_property_channel, property) == 0);
static_assert(offsetof(candela_property_channel, element) == 4);
static_assert(offsetof(candela_property_channel, part) == 8);
static_assert(offsetof(candela_property_channel, interpolation) == 12);
static_assert(offsetof(candela_property_channel, key_count) == 16);
static_assert(offsetof(candela_property_channel, unused) == 20);
static_assert(offsetof(candela_property_channel, times) == 24);
static_assert(offsetof(candela_property_channel, values) == 32);
static_assert(sizeof(candela_property_channel) == 40);

static_assert(offsetof(candela_bytes, data) == 0);
static_assert(offsetof(candela_bytes, size) == 8);
static_assert(sizeof(candela_bytes) == 16);

static_assert(offsetof(candela_host, struct_size) == 0);
static_assert(offsetof(candela_host, self) == 8);
static_assert(offsetof(candela_host, read_file) == 16);
static_assert(offsetof(candela_host, fail) == 24);
static_assert(offsetof(candela_host, note) == 32);
static_assert(offsetof(candela_host, progress) == 40);
static_assert(offsetof(candela_host, add_image) == 48);
static_assert(offsetof(candela_host, add_material) == 56);
static_assert(offsetof(candela_host, add_mesh) == 64);
static_assert(offsetof(candela_host, add_node) == 72);
static_assert(offsetof(candela_host, add_camera) == 80);
static_assert(offsetof(candela_host, add_light) == 88);
static_assert(offsetof(candela_host, add_animation) == 96);
static_assert(offsetof(candela_host, add_cage) == 104);
static_assert(offsetof(candela_host, add_skin) == 112);
static_assert(offsetof(candela_host, add_cage_instance) == 120);
static_assert(offsetof(candela_host, worker_count) == 128);
static_assert(offsetof(candela_host, parallel_for) == 136);
static_assert(offsetof(candela_host, add_note) == 144);
static_assert(offsetof(candela_host, read_optional_file) == 152);
static_assert(offsetof(candela_host, add_deformation) == 160);
static_assert(offsetof(candela_host, set_environment) == 168);
static_assert(offsetof(candela_host, add_variant) == 176);
static_assert(offsetof(candela_host, add_nodes) == 184);
static_assert(offsetof(candela_host, add_lights) == 192);
static_assert(offsetof(candela_host, add_image_bytes) == 200);
static_assert(offsetof(candela_host, set_scene_info) == 208);
static_assert(offsetof(candela_host, file_size) == 216);
static_assert(offsetof(candela_host, read_file_part) == 224);
static_assert(offsetof(candela_host, set_frame_callback) == 232);
static_assert(sizeof(candela_host) == 240);

static_assert(offsetof(candela_stencil_table, stencil_count) == 0);
static_assert(offsetof(candela_stencil_table, offsets) == 8);
static_assert(offsetof(candela_stencil_table, control_indices) == 16);
static_assert(offsetof(candela_stencil_table, weights) == 24);
static_assert(offsetof(candela_stencil_table, du_weights) == 32);
static_assert(offsetof(candela_stencil_table, dv_weights) == 40);
static_assert(sizeof(candela_stencil_table) == 48);

static_assert(offsetof(candela_refined_cage, struct_size) == 0);
static_assert(offsetof(candela_refined_cage, point_count) == 4);
static_assert(offsetof(candela_refined_cage, vertex_count) == 8);
static_assert(offsetof(candela_refined_cage, seam_points) == 16);
static_assert(offsetof(candela_refined_cage, positions) == 24);
static_assert(offsetof(candela_refined_cage, uvs) == 72);
static_assert(offsetof(candela_refined_cage, face_size) == 120);
static_assert(offsetof(candela_refined_cage, face_count) == 124);
static_assert(offsetof(candela_refined_cage, face_vertices) == 128);
static_assert(offsetof(candela_refined_cage, cage_faces) == 136);
static_assert(sizeof(candela_refined_cage) == 144);

static_assert(offsetof(candela_refinement, struct_size) == 0);
static_assert(offsetof(candela_refinement, self) == 8);
static_assert(offsetof(candela_refinement, fail) == 16);
static_assert(offsetof(candela_refinement, set_result) == 24);
static_assert(offsetof(candela_refinement, worker_count) == 32);
static_assert(offsetof(candela_refinement, parallel_for) == 40);
static_assert(sizeof(candela_refinement) == 48);

static_assert(offsetof(candela_subdivider, struct_size) == 0);
static_assert(offsetof(candela_subdivider, refine) == 8);
static_assert(sizeof(candela_subdivider) == 16);

static_assert(offsetof(candela_request, struct_size) == 0);
static_assert(offsetof(candela_request, uri) == 8);
static_assert(offsetof(candela_request, name) == 16);
static_assert(offsetof(candela_request, query) == 24);
static_assert(offsetof(candela_request, option_count) == 32);
static_assert(offsetof(candela_request, options) == 40);
static_assert(sizeof(candela_request) == 48);

static_assert(offsetof(candela_importer, struct_size) == 0);
static_assert(offsetof(candela_importer, extensions) == 8);
static_assert(offsetof(candela_importer, schemes) == 16);
static_assert(offsetof(candela_importer, import_scene) == 24);
static_assert(offsetof(candela_importer, option_count) == 32);
static_assert(offsetof(candela_importer, options) == 40);
static_assert(sizeof(candela_importer) == 48);

static_assert(offsetof(candela_plugin, struct_size) == 0);
static_assert(offsetof(candela_plugin, major) == 4);
static_assert(offsetof(candela_plugin, minor) == 8);
static_assert(offsetof(candela_plugin, name) == 16);
static_assert(offsetof(candela_plugin, version) == 24);
static_assert(offsetof(candela_plugin, description) == 32);
static_assert(offsetof(candela_plugin, importer) == 40);
static_assert(offsetof(candela_plugin, subdivider) == 48);
static_assert(offsetof(candela_plugin, image_decoder) == 56);
static_assert(sizeof(candela_plugin) == 64);

static_assert(offsetof(candela_image_bytes, name) == 0);
static_assert(offsetof(candela_image_bytes, bytes) == 8);
static_assert(offsetof(candela_image_bytes, size) == 16);
static_assert(sizeof(candela_image_bytes) == 24);

static_assert(offsetof(candela_decoding, struct_size) == 0);
static_assert(offsetof(candela_decoding, self) == 8);
static_assert(offsetof(candela_decoding, fail) == 16);
static_assert(offsetof(candela_decoding, set_result) == 24);
static_assert(sizeof(candela_decoding) == 32);

static_assert(offsetof(candela_image_decoder, struct_size) == 0);
static_assert(offsetof(candela_image_decoder, recognizes) == 8);
static_assert(offsetof(candela_image_decoder, decode) == 16);
static_assert(sizeof(candela_image_decoder) == 24);

static_assert(offsetof(candela_option, name) == 0);
static_assert(offsetof(candela_option, help) == 8);
static_assert(offsetof(candela_option, type) == 16);
static_assert(offsetof(candela_option, unused) == 20);
static_assert(offsetof(candela_option, minimum) == 24);
static_assert(offsetof(candela_option, maximum) == 32);
static_assert(offsetof(candela_option, keywords) == 40);
static_assert(sizeof(candela_option) == 48);

static_assert(offsetof(candela_option_value, option) == 0);
static_assert(offsetof(candela_option_value, unused) == 4);
static_assert(offsetof(candela_option_value, number) == 8);
static_assert(offsetof(candela_option_value, text) == 16);
static_assert(sizeof(candela_option_value) == 24);
// clang-format on
