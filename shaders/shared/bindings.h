// Binding points and uniform locations: read by C++ and GLSL both.

// Uniform blocks.
const int FRAME_BINDING = 0;

// Texture units of the geometry pass.
const int INSTANCES_UNIT = 0;  // RGBA32F buffer: INSTANCE_TEXELS an instance
const int MATERIALS_UNIT = 1;  // RGBA32UI buffer: MATERIAL_TEXELS a material
const int BASE_COLOR_UNIT = 2;
const int METALLIC_ROUGHNESS_UNIT = 3;
const int NORMAL_UNIT = 4;
const int EMISSION_UNIT = 5;
const int OCCLUSION_TEXTURE_UNIT = 6;
const int PREVIOUS_VERTICES_UNIT = 3;  // instance pass: RGBA32F buffer: where vertices were
const int PREVIOUS_OFFSETS_UNIT = 4;   // instance pass: R32UI buffer: an int an instance, which leads from the number of a vertex to its place there
const int PREVIOUS_NONE = -2147483647;  // its value where vertices rest
const int LOBE_RECORDS_UNIT = 7;   // RGBA32F buffer: LOBE_TEXELS a material
const int LOBE_TEXTURES_UNIT = 8;  // the first of LOBE_TEXTURE_COUNT, in the order of shaders/lib/extended_material.glsl
const int LOBE_TEXTURE_COUNT = 14;

const int LAYER_NUMBERS_UNIT = 22;  // R32UI: where surfaces share the depth of a layer, which of them it holds
const int LAYER_DEPTHS_UNIT = 23;   // R32UI array: the depths of the fragments of each pixel, bits of floats, nearest first

// Texture units of the lighting passes.
const int SURFACE_UNIT = 0;  // RG32UI: the G-buffer's two words
const int DEPTH_UNIT = 1;    // reversed depth
const int LIGHTS_UNIT = 2;   // RGBA32F buffer: LIGHT_TEXELS a light: points, then spots, then directional lights
const int CONES_UNIT = 3;    // RGBA32F buffer: one texel a spot
const int SHADOW_UNIT = 7;   // R32UI: the G-buffer's shadow word
const int LOBES_UNIT = 13;   // RGBA32UI: the G-buffer's lobe words
const int DIFFUSE_TRANSMISSION_UNIT = 14;  // R32UI: the word of diffuse transmission
const int LAYER_UNIT = 15;   // R32UI: the G-buffer's word of a layer
const int SHEEN_UNIT = 16;   // RG32F: the sheen's directional albedo table, in frames with lobe words
const int REFRACTION_UNIT = 20;  // RG32UI: its words of refraction
const int ALBEDO_UNIT = 4;   // RG32F: the model's directional albedo table

// Texture units of the environment's passes.
const int ENVIRONMENT_UNIT = 5;             // RGBA32F buffer: ENVIRONMENT_HEADER texels, then maps
const int ENVIRONMENT_VISIBILITY_UNIT = 6;  // R8: the share of the environment that a pixel sees
const int ENVIRONMENT_PICTURE_UNIT = 0;     // RGBA32F: the picture, for the background

// Texture units of the lighting passes with shadows, shaders/lib/occlusion.glsl.
const int OCCLUSION_NODES_UNIT = 8;      // RGBA32UI buffer: OCCLUSION_NODE_TEXELS a node
const int OCCLUSION_TRIANGLES_UNIT = 9;  // RGBA32UI buffer: OCCLUSION_TRIANGLE_TEXELS a triangle
const int OCCLUSION_INSTANCES_UNIT = 10; // RGBA32UI buffer: OCCLUSION_INSTANCE_TEXELS an instance, after the first ones
const int OCCLUSION_CUTOUTS_UNIT = 11;   // RGBA32UI buffer: OCCLUSION_CUTOUT_TEXELS a triangle that masks or blends by alpha
const int OCCLUSION_ALPHAS_UNIT = 12;    // R32UI buffer: images of alpha, four texels a word

// Texture units of the display pass; look-up textures of the display transform follow.
const int RADIANCE_UNIT = 0;
const int LOOKUP_UNIT = 1;

// Texture units of the mean of samples.
const int SUM_UNIT = 0;
const int LARGE_SUM_UNIT = 1;

// Texture units of the layers of transparent surfaces.
const int LAYER_COLOR_UNIT = 17;       // RGBA32F: radiance and coverage of a layer
const int LAYER_REFRACTION_UNIT = 18;  // RGBA32UI: what is kept of its refraction
const int OPAQUE_DEPTH_UNIT = 21;      // depth of the opaque surfaces
const int BEHIND_UNIT = 19;            // RGBA32F: the picture behind a layer, with levels where it is blurred

// Texture units of the debug views, after those of the G-buffer.
const int VIEW_UNIT = 2;             // what the view shows besides the G-buffer: emission, light counts or instances
const int INSTANCE_COLORS_UNIT = 3;  // RGBA32F buffer: a texel an instance

// Texture unit of the overlay display.
const int OVERLAY_UNIT = 0;

// Storage buffers and images of the compute passes.
const int TILE_BOXES_STORAGE = 0;
const int TILE_COUNTS_STORAGE = 1;
const int TILE_STARTS_STORAGE = 2;
const int TILE_LISTS_STORAGE = 3;
const int TILE_TOTAL_STORAGE = 4;
const int TILE_GROUPS_STORAGE = 5;
const int MAX_REDUCTION_STORAGE = 0;
const int LIMIT_OFFSETS_STORAGE = 0;
const int LIMIT_ENTRIES_STORAGE = 1;
const int LIMIT_POINTS_STORAGE = 2;
const int LIMIT_SURFACE_STORAGE = 3;
const int LIMIT_UVS_STORAGE = 4;
const int LIMIT_TANGENTS_STORAGE = 5;
const int DEFORM_REST_STORAGE = 0;
const int DEFORM_RUNS_STORAGE = 1;
const int DEFORM_INFLUENCES_STORAGE = 2;
const int DEFORM_ROWS_STORAGE = 3;
const int DEFORM_ENTRIES_STORAGE = 4;
const int DEFORM_POSES_STORAGE = 5;
const int DEFORM_SURFACE_STORAGE = 6;
const int DEFORM_TANGENTS_STORAGE = 7;
const int FILTER_DRAWS_STORAGE = 0;
const int FILTER_INDICES_STORAGE = 1;
const int FILTER_RESULTS_STORAGE = 2;
const int FILTER_SUMS_STORAGE = 3;
const int FILTER_CLUSTERS_STORAGE = 4;
const int FILTER_VERTICES_STORAGE = 5;
const int FILTER_OUTPUT_STORAGE = 6;
const int FILTER_COMMANDS_STORAGE = 7;
const int LAYERS_OF_DRAWS_STORAGE = 0;
const int RADIANCE_IMAGE = 0;
const int HIDDEN_IMAGE = 0;      // environment_occlusion: R32F, of each pixel the rays that do not arrive
const int VISIBILITY_IMAGE = 1;  // environment_occlusion: R8
const int FRAGMENT_DEPTHS_IMAGE = 0;  // layer_fragment: as LAYER_DEPTHS_UNIT
const int FRAGMENT_COUNTS_IMAGE = 1;  // layer_fragment: R32UI, the fragments of each pixel
const int DEPTH_TIES_IMAGE = 2;       // layer_fragment, layer_ties: R32UI, not 0 where fragments share a depth; bits of layers
const int LAYER_NUMBERS_IMAGE = 3;    // layer_fragment: as LAYER_NUMBERS_UNIT

// Uniform locations.
const int FIRST_LIGHT_LOCATION = 0;       // tile_fill: the first light of a dispatch
const int LIST_PART_LOCATION = 1;         // tile_shade: which part of the lists, and the lights of a part; tile_prefix: the lights of a part
const int LIGHT_SPAN_LOCATION = 2;        // tile_fill, tile_prefix, tile_shade: first and end of the lights that the lists are of
const int LIGHT_SPANS_LOCATION = 0;       // fullscreen: first and end of points and spots
const int DIRECTIONAL_SPAN_LOCATION = 1;  // fullscreen: first and end of directional lights
const int ENVIRONMENT_PARTS_LOCATION = 0; // environment: factors on diffuse and specular reflection
const int LAYER_LOCATION = 0;             // layer_fragment, layer_depth: the layer, from 0, or the first number of a draw; surfaces of a layer: 1 where some share its depth
const int EXPOSURE_LOCATION = 0;          // display: factor before the transform
const int ORIGIN_LOCATION = 1;            // display: lower left corner of the picture in the target
const int PLACE_LOCATION = 2;             // display: lower left corner of a part in its picture
const int DEPTH_PLACE_LOCATION = 0;       // depth_conversion: corner in the target, orthographic, same planes
const int DEPTH_FROM_LOCATION = 1;        // depth_conversion: the scale that is read
const int DEPTH_TO_LOCATION = 2;          // depth_conversion: the scale that is written
const int SAMPLE_COUNT_LOCATION = 0;      // sample_mean: what the sum is divided by
const int ENVIRONMENT_RAYS_LOCATION = 0;  // environment_occlusion: first and end of a dispatch's rays, rays of a pixel, number of the sample
const int ENVIRONMENT_DISTANCE_LOCATION = 1;  // environment_occlusion: metres; what is farther hides nothing
const int LIMIT_RANGE_LOCATION = 0;       // cage_limit: first and end of a dispatch's vertices, number of points, number of vertices
const int LIMIT_TANGENTS_LOCATION = 1;    // cage_limit: are tangents needed?
const int DEFORM_POSE_LOCATION = 0;       // deform: number of vertices; first joint and morph weight in the poses; has it tangents?
const int DEFORM_SCALE_LOCATION = 1;      // deform: scale of directions
const int FILTER_COUNTS_LOCATION = 0;     // triangle_filter_*: draws, and clusters of all of them
const int HEAT_STOPS_LOCATION = 0;        // debug_view: the colours between which the heat map blends
const int LINE_COLOR_LOCATION = 0;        // overlays: the colour of a line, code values
const int LINE_INSTANCE_LOCATION = 1;     // overlays: the instance on which lines of a cage lie

// Fragment outputs of the geometry pass. Further words of the G-buffer follow.
const int SURFACE_OUTPUT = 0;
const int RADIANCE_OUTPUT = 1;  // emissive surfaces only
const int SHADOW_OUTPUT = 2;    // frames that trace rays only
const int OCCLUSION_OUTPUT = 3; // with an environment and occlusion textures only
const int LOBES_OUTPUT = 4;     // with materials of more lobes in view only; the next one too
const int DIFFUSE_TRANSMISSION_OUTPUT = 5;
const int LAYER_OUTPUT = 6;     // layers of transparent surfaces only
const int REFRACTION_OUTPUT = 7;  // layers of which a surface in view transmits only

// Vertex attributes.
const int POSITION_ATTRIBUTE = 0;
const int NORMAL_ATTRIBUTE = 1;
const int DRAW_ATTRIBUTE = 2;  // uvec3 a draw: instance, material, its place among the scene's draws
const int TANGENT_ATTRIBUTE = 3;
const int UV0_ATTRIBUTE = 4;
const int UV1_ATTRIBUTE = 5;
const int COLOR_ATTRIBUTE = 6;
const int FURTHER_UVS_ATTRIBUTE = 7;  // and those that follow: sets of texture coordinates from 2 on, two each
const int FURTHER_UVS_VARYING = 8;    // their first location between stages, behind those of surface_textured.vert
const int LIGHT_ATTRIBUTE = 1;  // uint an instance of a light volume: light

const uint DEFORM_NONE = 0xffffffffu;
const uint LAYER_NO_NUMBER = 0xffffffffu;  // as many layers share the depth as surfaces do, or more

// Texels a record.
const int INSTANCE_TEXELS = 6;  // rows of the world matrix, then of its cofactor matrix with the handedness in w
const int MATERIAL_TEXELS = 14;
const int LIGHT_TEXELS = 2;  // position and 1 / range², or of a directional light the direction to it and 0;
                             // then intensity, and in w 1 where the light casts shadows, else 0

// The first texels of an environment (lib/render/environment/environment_map.h).
const int ENVIRONMENT_LEVELS = 10;      // a texel each: first texel and size of its map
const int ENVIRONMENT_IRRADIANCE = 10;  // the same of the irradiance
const int ENVIRONMENT_PEAK_COUNT = 11;
const int ENVIRONMENT_PEAKS = 12;       // two texels each: direction, irradiance
const int ENVIRONMENT_HEADER = 20;

// The tree of occlusion rays. Numbers are the bits of floats unless marked as uint; lib/render/occlusion/gpu_occlusion.cpp writes them.
const int OCCLUSION_NODE_TEXELS = 6;      // origin; in w uint: the exponents of the step along each axis, 8 bits each, then a bit a child;
                                          // x, y, z uint: 8 bits a child, the lower sides of the boxes in two words, then the upper sides;
                                          // uint: eight children
const int OCCLUSION_TRIANGLE_TEXELS = 3;  // corners; w of the first uint: index of its cut-out or OCCLUSION_NONE
const int OCCLUSION_INSTANCE_TEXELS = 4;  // rows of the linear part of the matrix to the mesh, its world position in w; then uint: root.
                                          // The first texel of the buffer has the root of the tree over instances or OCCLUSION_NONE
const int OCCLUSION_CUTOUT_TEXELS = 4;    // texture coordinates, alpha factors, cutoff and what a mask transmits; then uint: first texel of the image in the
                                          // alphas or OCCLUSION_NONE, width, height, flags
const uint OCCLUSION_NONE = 0xffffffffu;
const uint OCCLUSION_LEAF = 0x80000000u;   // a child is an instance, or a run of triangles: the number less one in 3 bits, then the first
const int OCCLUSION_LEAF_COUNT_SHIFT = 28;
const uint OCCLUSION_LEAF_FIRST_MASK = 0x0fffffffu;
const int OCCLUSION_MAX_DEPTH = 24;        // nodes on the longest way through one tree
const int OCCLUSION_WRAP_T_SHIFT = 2;      // in the flags, after wrapS
const uint OCCLUSION_NEAREST = 16u;
const uint OCCLUSION_BLENDS = 32u;

// Texels of a material's record.
const int MATERIAL_BASE_COLOR = 0;  // base colour factor and alpha
const int MATERIAL_FACTORS = 1;     // metallic, roughness, normal scale, alpha cutoff (negative: no mask; of a material that blends over a half)
const int MATERIAL_EMISSION = 2;    // emission factor; 1 when unlit
const int MATERIAL_PACKED = 3;      // x: base colour and metallic as the G-buffer packs them (uint); y: strength of the occlusion texture;
                                    // z: 1 where the material blends; w: code of the roughness (uints)
const int MATERIAL_UV_ROWS = 4;     // two rows of the coordinate transform a texture: base colour, metallic-roughness, normal,
                                    // emission, occlusion; w of the first is the set of texture coordinates

// Texels of the record of a material's further lobes.
const int LOBE_TEXELS = 36;
const int LOBE_SPECULAR = 0;               // index of refraction, specular factor, factor and roughness of the clear coat
const int LOBE_SPECULAR_COLOR = 1;         // w: normal scale of the clear coat, 0 without a texture
const int LOBE_SHEEN = 2;                  // colour, roughness
const int LOBE_ANISOTROPY = 3;             // strength, cosine and sine of the rotation, 1 with a texture
const int LOBE_IRIDESCENCE = 4;            // factor, index of refraction, minimum and maximum thickness in nanometres
const int LOBE_DIFFUSE_TRANSMISSION = 5;   // colour, factor
const int LOBE_ABSORPTION = 6;             // absorption coefficient, 1 / metre; transmission factor
const int LOBE_VOLUME = 7;                 // thickness in metres, dispersion
const int LOBE_UV_ROWS = 8;                // two rows of the coordinate transform a texture, as in MATERIAL_UV_ROWS
