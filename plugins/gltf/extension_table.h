#pragma once

#include <string_view>

namespace candela_plugins::gltf {

enum class Support {
    drawn,      ///< All that it adds to a picture.
    partly,     ///< Some of it.
    notDrawn,   ///< The picture lacks what it adds.
    noPicture,  ///< It adds nothing to a picture.
};

struct Extension {
    std::string_view name;
    Support support;
    std::string_view remark;  ///< For docs/gltf.md: what is drawn, what is missing, or why.
    /// The note for an element that has it: what is missing. Empty where nothing is, or where it is noted
    /// elsewhere.
    std::string_view loss = {};
};

/// The extensions that the importer knows, by name: those of the Khronos registry and others that files have.
/// docs/gltf.md shows them.
inline constexpr Extension extensionTable[] = {
    {"ADOBE_materials_clearcoat_specular", Support::notDrawn,
     "the coat reflects as a dielectric of index 1.5",
     "the reflectance of its clear coat (ADOBE_materials_clearcoat_specular)"},
    {"ADOBE_materials_clearcoat_tint", Support::notDrawn, "the coat is colourless",
     "the colour of its clear coat (ADOBE_materials_clearcoat_tint)"},
    {"ADOBE_materials_thin_transparency", Support::notDrawn, "replaced by KHR_materials_transmission"},
    {"AGI_articulations", Support::noPicture, "names of movable parts"},
    {"AGI_stk_metadata", Support::noPicture, "metadata"},
    {"CESIUM_primitive_outline", Support::notDrawn, "edges to be outlined; surfaces are drawn without them"},
    {"CESIUM_RTC", Support::notDrawn, "of glTF 1.0"},
    {"EXT_instance_features", Support::noPicture, "metadata"},
    {"EXT_lights_ies", Support::notDrawn, "profiles of lights; the light shines as if it had none",
     "the profile of its light (EXT_lights_ies)"},
    {"EXT_lights_image_based", Support::drawn,
     "the sharpest cube map; irradiance and rougher levels are computed from it"},
    {"EXT_mesh_features", Support::noPicture, "metadata"},
    {"EXT_mesh_gpu_instancing", Support::drawn,
     "with rotations as floats and as integers; of a subdivision cage once"},
    {"EXT_mesh_manifold", Support::noPicture, "topology for modelling programs"},
    {"EXT_meshopt_compression", Support::drawn, "all modes and filters"},
    {"EXT_structural_metadata", Support::noPicture, "metadata"},
    {"EXT_texture_avif", Support::notDrawn, "no decoder; the PNG or JPEG image beside it is drawn"},
    {"EXT_texture_webp", Support::drawn, "lossy and lossless, not animated"},
    {"FB_geometry_metadata", Support::noPicture, "metadata"},
    {"FB_ngon_encoding", Support::drawn, "polygons of subdivision cages"},
    {"GODOT_single_root", Support::noPicture, "for Godot's editor"},
    {"KHR_animation_pointer", Support::partly,
     "materials, texture transforms, lights, cameras, visibility, nodes and weights; see above"},
    {"KHR_draco_mesh_compression", Support::drawn, "meshes; sequential and Edgebreaker"},
    {"KHR_lights_punctual", Support::drawn, "point, spot and directional lights"},
    {"KHR_materials_anisotropy", Support::drawn, "with the texture of directions"},
    {"KHR_materials_clearcoat", Support::drawn, "with its own normals"},
    {"KHR_materials_diffuse_transmission", Support::drawn, "of thin surfaces"},
    {"KHR_materials_dispersion", Support::drawn, "red, green and blue are refracted apart"},
    {"KHR_materials_emissive_strength", Support::drawn, "any strength"},
    {"KHR_materials_ior", Support::drawn, "1 and more, and 0 for infinity"},
    {"KHR_materials_iridescence", Support::drawn, "after Belcour and Barla"},
    {"KHR_materials_pbrSpecularGlossiness", Support::partly,
     "as a dielectric whose reflectance is the specular colour; see above"},
    {"KHR_materials_sheen", Support::drawn, "the Charlie lobe"},
    {"KHR_materials_specular", Support::drawn, "strength and colour"},
    {"KHR_materials_transmission", Support::drawn,
     "of the picture behind the surface, deeper layers included; see layers.md"},
    {"KHR_materials_unlit", Support::drawn, "as emission of the base colour"},
    {"KHR_materials_variants", Support::drawn,
     "the one that --variant names; of meshes and subdivision cages"},
    {"KHR_materials_volume", Support::drawn, "refraction at the front of the volume, by its thickness"},
    {"KHR_mesh_quantization", Support::drawn, "all encodings, morph targets included"},
    {"KHR_meshopt_compression", Support::partly,
     "attributes of format 0 and all filters; format 1 where the build has meshoptimizer 0.23"},
    {"KHR_node_visibility", Support::drawn,
     "hidden nodes and what is below them, at the times at which they are hidden"},
    {"KHR_texture_basisu", Support::drawn, "ETC1S and UASTC; not in a build without CANDELA_KTX2"},
    {"KHR_texture_transform", Support::drawn, "offset, rotation, scale and set"},
    {"KHR_xmp", Support::noPicture, "metadata"},
    {"KHR_xmp_json_ld", Support::noPicture, "metadata"},
    {"MSFT_lod", Support::drawn, "the level that the node itself shows, the finest"},
    {"MSFT_packing_normalRoughnessMetallic", Support::notDrawn, "the textures beside it are drawn"},
    {"MSFT_packing_occlusionRoughnessMetallic", Support::notDrawn, "the textures beside it are drawn"},
    {"MSFT_texture_dds", Support::notDrawn,
     "no small library reads it, see above; the PNG or JPEG image beside it is drawn"},
    {"VRM", Support::noPicture, "metadata, and motion while an application runs"},
    {"VRMC_node_constraint", Support::noPicture, "motion while an application runs"},
    {"VRMC_springBone", Support::noPicture, "motion while an application runs"},
    {"VRMC_vrm", Support::noPicture, "metadata"},
};

}  // namespace candela_plugins::gltf
