/* The whole of what a candela plugin sees: a C interface, so that a plugin may be built with any compiler.
 *
 * A plugin is a shared library that exports one symbol, `candela_plugin_query`. It includes this header and
 * nothing else of candela, and does not link candela.
 *
 * Rules:
 *  - Version: the major number must match. The minor number grows when a struct that begins with
 * `struct_size` gains members at its end; who fills a struct sets `struct_size` to its own `sizeof`. A member
 * that lies beyond the sender's `struct_size` is taken as zero. Structs without `struct_size` never change
 * within a major version.
 *  - Memory: whoever allocates frees. The host copies what is added before the call returns; what the host
 * lends (file bytes, strings) is valid until `import_scene` returns.
 *  - Errors: no C++ exception crosses this border. A host function that returns a negative index or a status
 * other than CANDELA_OK has recorded its reason; the importer then returns CANDELA_FAILED. The host treats
 * the import as failed even if the importer goes on.
 *  - Members that came after version 1.0 say so. Before a plugin uses one of them, it checks that the host's
 * `struct_size` reaches behind it. Before it uses a value of an enum that came later, it checks the minor
 * number that `candela_plugin_query` was given.
 *  - Threads: the functions of the host are called on the thread that called the plugin, and not from a body
 * that `parallel_for` runs.
 *  - Units and conventions: metres, right-handed, +Y up, a camera or a spot looks along -Z of its node,
 * angles in radians, matrices column-major, counter-clockwise front faces, colours linear with Rec.709
 * primaries, texture coordinates with (0, 0) at the first texel of the first row.
 *  - Strings are UTF-8 and end with a zero. A name may be NULL or empty.
 */
#ifndef CANDELA_PLUGIN_H
#define CANDELA_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CANDELA_PLUGIN_MAJOR 1u
#define CANDELA_PLUGIN_MINOR 6u

typedef enum candela_status { CANDELA_OK = 0, CANDELA_FAILED = 1 } candela_status;

/* ---- What an importer adds to the scene */
typedef enum candela_pixel_format {
    CANDELA_PIXELS_RGBA8 = 0,  /* 4 × uint8_t, normalised; sRGB or linear, as the texture's use says */
    CANDELA_PIXELS_RGBA16 = 1, /* 4 × uint16_t, normalised, host byte order */
    CANDELA_PIXELS_RGBA32F = 2 /* 4 × float, linear */
} candela_pixel_format;

typedef struct candela_image {
    uint32_t struct_size;
    const char* name;
    uint32_t width, height; /* 1 to 32768 */
    candela_pixel_format format;
    const void* pixels;   /* rows from the top, tightly packed */
    uint64_t pixels_size; /* bytes: width × height × texel size */
} candela_image;

/* A file of an image, PNG, JPEG or whatever else the host's plugins decode (since 1.6). */
typedef struct candela_image_bytes {
    const char* name;
    const uint8_t* bytes;
    uint64_t size;
} candela_image_bytes;

typedef enum candela_wrap {
    CANDELA_WRAP_REPEAT = 0,
    CANDELA_WRAP_CLAMP_TO_EDGE = 1,
    CANDELA_WRAP_MIRRORED_REPEAT = 2
} candela_wrap;

typedef enum candela_filter {
    CANDELA_FILTER_LINEAR_MIPMAP_LINEAR = 0,
    CANDELA_FILTER_NEAREST = 1,
    CANDELA_FILTER_LINEAR = 2,
    CANDELA_FILTER_NEAREST_MIPMAP_NEAREST = 3,
    CANDELA_FILTER_LINEAR_MIPMAP_NEAREST = 4,
    CANDELA_FILTER_NEAREST_MIPMAP_LINEAR = 5
} candela_filter;

/* How a material samples an image. The coordinate is uv' = offset + rotate(rotation) × (scale × uv), as
 * KHR_texture_transform. */
typedef struct candela_texture {
    int32_t image;   /* index of an added image, -1 for none: the rest is then ignored */
    uint32_t uv_set; /* 0: uv0 of the mesh, 1: uv1; since 1.6: 2 to 17: further_uvs; 0 for cages */
    candela_wrap wrap_s, wrap_t;
    candela_filter min_filter;
    candela_filter mag_filter; /* NEAREST or LINEAR; LINEAR_MIPMAP_LINEAR (0) stands for LINEAR */
    float offset[2];
    float rotation; /* radians, counter-clockwise */
    float scale[2];
} candela_texture;

typedef enum candela_alpha_mode {
    CANDELA_ALPHA_OPAQUE = 0,
    CANDELA_ALPHA_MASK = 1, /* a fragment whose alpha is below alpha_cutoff is not drawn */
    CANDELA_ALPHA_BLEND = 2 /* since 1.5; covers the share alpha of what is behind, and lets 1 - alpha
                                of each light through */
} candela_alpha_mode;

/* Lobes and media that a material may have besides metallic and roughness (since 1.6), as the glTF extensions
 * of their names define them. Each texture multiplies its factor, and is NULL where there is none; the
 * letters name the channels that are read. Colours are linear Rec.709, 0 to 1; textures of colours are
 * sRGB-encoded (linear when 32F), others are linear. */
typedef struct candela_specular {
    float factor;                         /* 0 to 1 */
    float color[3];                       /* 0 or more */
    const candela_texture* texture;       /* A: the factor */
    const candela_texture* color_texture; /* RGB */
} candela_specular;

typedef struct candela_clearcoat {
    float factor;                             /* 0 to 1 */
    float roughness;                          /* perceptual roughness, 0 to 1 */
    float normal_scale;                       /* multiplies x and y of the normal texture */
    const candela_texture* texture;           /* R: the factor */
    const candela_texture* roughness_texture; /* G */
    const candela_texture* normal_texture;    /* tangent space; NULL: the normal of the mesh */
} candela_clearcoat;

typedef struct candela_sheen {
    float color[3];
    float roughness;                          /* perceptual roughness, 0 to 1 */
    const candela_texture* color_texture;     /* RGB */
    const candela_texture* roughness_texture; /* A */
} candela_sheen;

typedef struct candela_anisotropy {
    float strength;                 /* 0 to 1 */
    float rotation;                 /* of the wide direction, radians, counter-clockwise from the tangent */
    const candela_texture* texture; /* RG: direction, -1 to 1; B: the strength */
} candela_anisotropy;

typedef struct candela_iridescence {
    float factor;                             /* 0 to 1 */
    float ior;                                /* of the film, 1 or more */
    float min_thickness;                      /* nanometres, 0 or more: where the texture is 0 */
    float max_thickness;                      /* nanometres, 0 or more: where it is 1, or there is none */
    const candela_texture* texture;           /* R: the factor */
    const candela_texture* thickness_texture; /* G */
} candela_iridescence;

typedef struct candela_transmission {
    float factor;                   /* 0 to 1 */
    const candela_texture* texture; /* R */
} candela_transmission;

typedef struct candela_volume {
    float thickness;                          /* metres in the space of the mesh, 0 or more; 0: a thin wall */
    float attenuation_distance;               /* metres, over 0; 0: nothing is absorbed */
    float attenuation_color[3];               /* what is left of white light after that distance */
    float dispersion;                         /* 20 / Abbe number, 0 or more */
    const candela_texture* thickness_texture; /* G */
} candela_volume;

typedef struct candela_diffuse_transmission {
    float factor; /* 0 to 1 */
    float color[3];
    const candela_texture* texture;       /* A: the factor */
    const candela_texture* color_texture; /* RGB */
} candela_diffuse_transmission;

/* A metallic-roughness material as in glTF 2.0; each texture multiplies its factor. */
typedef struct candela_material {
    uint32_t struct_size;
    const char* name;
    float base_color[4];                        /* linear Rec.709 and alpha, 0 to 1 */
    float metallic;                             /* 0 to 1 */
    float roughness;                            /* perceptual roughness, 0 to 1 */
    float emission[3];                          /* radiance, linear Rec.709, 0 or more */
    candela_texture base_color_texture;         /* RGB sRGB-encoded (linear when 32F), A linear */
    candela_texture metallic_roughness_texture; /* G roughness, B metallic, linear */
    candela_texture normal_texture;             /* tangent space, linear */
    candela_texture occlusion_texture;          /* R, linear: dims the light of the environment */
    candela_texture emission_texture;           /* RGB sRGB-encoded (linear when 32F) */
    float normal_scale;                         /* multiplies x and y of the normal texture */
    float occlusion_strength;                   /* 0 to 1 */
    candela_alpha_mode alpha_mode;
    float alpha_cutoff;
    uint32_t double_sided; /* 0 or 1 */
    uint32_t unlit;        /* 1: radiance is the base colour, and no light falls on it */
    /* since 1.6; NULL: the material has no such lobe */
    float ior; /* index of refraction, 1 or more, or infinity; 0: 1.5 */
    const candela_specular* specular;
    const candela_clearcoat* clearcoat;
    const candela_sheen* sheen;
    const candela_anisotropy* anisotropy;
    const candela_iridescence* iridescence;
    const candela_transmission* transmission;
    const candela_volume* volume;
    const candela_diffuse_transmission* diffuse_transmission;
    const float* emission_strength; /* multiplies the emission, 0 or more; NULL: 1 */
} candela_material;

/* A run of a mesh's indices drawn with one material. */
typedef struct candela_submesh {
    uint32_t first_index, index_count; /* of whole triangles, polygons, lines or points */
    int32_t material; /* index of an added material, -1: the default material (white, rough, no metal) */
} candela_submesh;

/* The material that a submesh has in a variant of the scene (since 1.6). */
typedef struct candela_variant_material {
    uint32_t submesh; /* index of the mesh's submeshes */
    uint32_t variant; /* index of an added variant */
    int32_t material; /* index of an added material, -1: the default material */
} candela_variant_material;

/* What the indices of a submesh are (since 1.6). Lines and points have a width in pixels and cast no shadows;
 * those of a mesh without normals show their base colour and emission, and no light falls on them. */
typedef enum candela_topology {
    CANDELA_TRIANGLES = 0, /* three indices each */
    CANDELA_LINES = 1,     /* two each */
    CANDELA_POINTS = 2     /* one each */
} candela_topology;

/* Triangles, and since 1.6 lines and points. Arrays hold vertex_count elements; a NULL array is absent. Where
 * normals are absent the host makes those of triangles, flat or by crease_angle; where a normal texture or
 * anisotropy needs tangents and none are given, the host makes them the MikkTSpace way. */
typedef struct candela_mesh {
    uint32_t struct_size;
    const char* name;
    uint32_t vertex_count;
    const float* positions; /* 3 a vertex, metres */
    const float* normals;   /* 3 a vertex; the host normalises them, and replaces those that it cannot */
    const float* tangents;  /* 4 a vertex: direction, and the bitangent's sign in w; likewise */
    const float* uv0;       /* 2 a vertex */
    const float* uv1;       /* 2 a vertex */
    const float* colors;    /* 4 a vertex, linear Rec.709 and alpha: multiplies the base colour */
    uint32_t index_count;   /* a multiple of 3, or the sum of face_sizes, or any with topologies */
    const uint32_t* indices;
    uint32_t submesh_count;
    const candela_submesh* submeshes;
    /* since 1.1: polygons, which the host cuts into triangles; they may be concave, but not have holes */
    uint32_t face_count;
    const uint32_t* face_sizes; /* corners of each face, 3 or more; NULL: all faces are triangles */
    /* since 1.3: what deforms the mesh */
    uint32_t influence_count; /* joints of each vertex; 0: no skin deforms the mesh */
    const uint32_t* joints;   /* influence_count for each vertex: indices into the skin's joints */
    const float*
        joint_weights; /* influence_count for each vertex, 0 or more; the host divides by their sum */
    uint32_t morph_target_count;
    const float* morph_offsets;  /* target after target, 3 a vertex, metres */
    const float* morph_normals;  /* the same for normals; NULL: no target changes them */
    const float* morph_tangents; /* the same for the direction of tangents; NULL: no target changes them */
    /* since 1.6: where submeshes have other materials in variants, at most one for each of both */
    uint32_t variant_material_count;
    const candela_variant_material* variant_materials;
    const candela_topology*
        topologies;                  /* submesh_count of them; NULL: all are triangles. Not with face_sizes */
    uint32_t further_uv_count;       /* sets of texture coordinates from 2 on, 0 to 16 */
    const float* const* further_uvs; /* further_uv_count arrays, 2 a vertex each; NULL: not that set */
    float crease_angle; /* radians, 0 to pi: where normals are absent, those of triangles that meet at an edge
                         * at a smaller angle become smooth; 0: flat ones */
    uint32_t is_moved;  /* 1: the frame callback may move its vertices; influences and morph targets are then
                         * absent; or 0 */
} candela_mesh;

/* ---- Subdivision cages (since 1.1) */
typedef enum candela_scheme {
    CANDELA_SCHEME_CATMULL_CLARK = 0,
    CANDELA_SCHEME_LOOP = 1, /* triangles only */
    CANDELA_SCHEME_BILINEAR = 2
} candela_scheme;

/* How the surface ends where the cage does. */
typedef enum candela_boundary_interpolation {
    CANDELA_BOUNDARY_NONE = 0, /* faces at a boundary have no surface */
    CANDELA_BOUNDARY_EDGES = 1,
    CANDELA_BOUNDARY_EDGES_AND_CORNERS = 2 /* and it passes through vertices that belong to one face only */
} candela_boundary_interpolation;

/* Where face-varying values are interpolated linearly, by OpenSubdiv's names. */
typedef enum candela_face_varying_interpolation {
    CANDELA_FACE_VARYING_NONE = 0, /* nowhere: smooth everywhere */
    CANDELA_FACE_VARYING_CORNERS_ONLY = 1,
    CANDELA_FACE_VARYING_CORNERS_PLUS1 = 2,
    CANDELA_FACE_VARYING_CORNERS_PLUS2 = 3,
    CANDELA_FACE_VARYING_BOUNDARIES = 4,
    CANDELA_FACE_VARYING_ALL = 5
} candela_face_varying_interpolation;

typedef enum candela_crease_method {
    CANDELA_CREASE_UNIFORM = 0,
    CANDELA_CREASE_CHAIKIN = 1
} candela_crease_method;

typedef enum candela_triangle_subdivision {
    CANDELA_TRIANGLE_CATMULL_CLARK = 0,
    CANDELA_TRIANGLE_SMOOTH = 1
} candela_triangle_subdivision;

/* The materials of a cage's faces in a variant of the scene (since 1.6). */
typedef struct candela_cage_variant {
    uint32_t variant;              /* index of an added variant */
    const int32_t* face_materials; /* a material for each face, -1: the default */
} candela_cage_variant;

/* A control polyhedron of a subdivision surface. A corner is one vertex of one face; corners are counted face
 * after face. Sharpness is 0 or more; 10 and more is infinite. */
typedef struct candela_cage {
    uint32_t struct_size;
    const char* name;
    candela_scheme scheme;
    candela_boundary_interpolation boundary_interpolation;
    candela_face_varying_interpolation face_varying_interpolation;
    candela_crease_method crease_method;
    candela_triangle_subdivision triangle_subdivision;
    uint32_t vertex_count;
    const float* positions; /* 3 a vertex, metres */
    uint32_t face_count;
    const uint32_t* face_sizes;    /* corners of each face, 3 to vertex_count */
    const uint32_t* face_vertices; /* a vertex a corner */
    uint32_t uv_count;             /* 0: no texture coordinates */
    const float* uvs;              /* 2 each */
    const uint32_t* face_uvs;      /* an index of uvs a corner */
    uint32_t crease_count;
    const uint32_t* crease_edges; /* 2 vertices a crease: an edge of the cage */
    const float* crease_sharpness;
    uint32_t corner_count; /* sharp vertices */
    const uint32_t* corner_vertices;
    const float* corner_sharpness;
    uint32_t hole_count;
    const uint32_t* holes;         /* faces without a surface; they shape that of their neighbours */
    const int32_t* face_materials; /* a material for each face, -1: the default; NULL: -1 for all */
    uint32_t level;                /* 1 to 8: refine to this level; 0: by the size on the screen */
    /* What deforms the cage; a subdivider does not read it. */
    uint32_t influence_count; /* joints of each vertex; 0: no skin deforms the cage */
    const uint32_t* joints;   /* influence_count for each vertex: indices into the skin's joints */
    const float*
        joint_weights; /* influence_count for each vertex, 0 or more; the host divides by their sum */
    uint32_t morph_target_count;
    const float* morph_offsets; /* target after target, 3 a vertex, metres */
    /* since 1.6: where faces have other materials in variants; a subdivider does not read it */
    uint32_t variant_count;
    const candela_cage_variant* variants; /* one at most for each variant */
    uint32_t is_moved; /* 1: the frame callback may move its vertices; influences and morph targets are then
                        * absent; or 0 */
} candela_cage;

/* The joints that the influences of meshes and cages refer to. */
typedef struct candela_skin {
    uint32_t struct_size;
    const char* name;
    uint32_t joint_count;               /* 1 or more */
    const int32_t* joints;              /* indices of added nodes */
    const float* inverse_bind_matrices; /* 16 numbers for each joint, column-major, affine; NULL: identity */
} candela_skin;

/* An instance of a cage at a node. A skinned cage is placed by its joints and not by its node. */
typedef struct candela_cage_instance {
    uint32_t struct_size;
    int32_t node;                /* index of an added node; one cage instance a node at most */
    int32_t cage;                /* index of an added cage */
    int32_t skin;                /* index of an added skin, -1 for none */
    uint32_t morph_weight_count; /* the cage's morph_target_count, or 0: all weights are 0 */
    const float* morph_weights;
} candela_cage_instance;

/* What deforms the mesh of a node (since 1.3). A mesh with a skin is placed by its joints and not by its
 * node. */
typedef struct candela_deformation {
    uint32_t struct_size;
    int32_t node; /* index of an added node that shows a mesh; one deformation a node at most */
    int32_t skin; /* index of an added skin, -1 for none */
    uint32_t morph_weight_count; /* the mesh's morph_target_count, or 0: all weights are 0 */
    const float* morph_weights;
} candela_deformation;

typedef struct candela_camera {
    uint32_t struct_size;
    const char* name;   /* the camera's own, not that of its node */
    float vertical_fov; /* radians, over 0 and under pi */
    float near_plane;   /* metres, over 0; 0: the size of the scene decides */
    int32_t node;       /* index of an added node that places the camera, -1: the camera is in world space */
    uint32_t unused;    /* padding of version 1.0, which is not read */
    /* since 1.3 */
    uint32_t number;           /* 1 + the number by which a user finds the camera in the file; 0: its index */
    float orthographic_height; /* metres, over 0: an orthographic camera, whose vertical_fov is not read; 0: a
                                * perspective one */
    float far_plane;           /* metres, over near_plane: nothing beyond is drawn; 0: at infinity */
} candela_camera;

typedef enum candela_light_type {
    CANDELA_LIGHT_POINT = 0,
    CANDELA_LIGHT_SPOT = 1,
    CANDELA_LIGHT_DIRECTIONAL = 2
} candela_light_type;

/* A punctual light as in KHR_lights_punctual. */
typedef struct candela_light {
    uint32_t struct_size;
    const char* name;
    candela_light_type type;
    float color[3];         /* linear Rec.709, 0 or more */
    float intensity;        /* candela for point and spot lights, lux for a directional light; 0 or more */
    float range;            /* metres; 0: the renderer derives one beyond which little is lost */
    float inner_cone_angle; /* spot: radians, 0 or more and less than outer_cone_angle */
    float outer_cone_angle; /* spot: radians, at most pi / 2 */
    float position[3];      /* in the node's space; directional: ignored */
    float direction[3]; /* in the node's space, of any length but 0: where the light goes; point: ignored */
    int32_t node;       /* index of an added node, -1: world space */
    uint32_t unused;    /* padding of version 1.0, which is not read */
    /* since 1.4 */
    uint32_t casts_no_shadow; /* 1: surfaces do not keep its light from what lies behind them; or 0 */
    float radius; /* metres, 0 or more: of the sphere that emits the light, which softens the edges of
                   * shadows; directional: ignored */
} candela_light;

/* Light from everywhere, infinitely far away (since 1.5): an equirectangular picture of what surrounds the
 * scene. Its rows go from the top (+Y), its columns from the left, where the middle column lies at -Z, the
 * quarter to its right at +X and the borders at +Z. */
typedef struct candela_environment {
    uint32_t struct_size;
    const char* name;
    uint32_t width, height; /* 1 to 32768 */
    const float* pixels;  /* 4 a texel: radiance, linear Rec.709, candela per square metre, 0 or more; and an
                           * alpha that is not read */
    uint64_t pixels_size; /* bytes: width × height × 16 */
    float rotation[4];    /* world from the picture's frame: unit quaternion x, y, z, w */
    float intensity;      /* factor on the radiance, 0 or more */
    uint32_t is_hidden;   /* 1: it is not seen behind the scene; or 0 */
    float occlusion_distance; /* metres: surfaces farther from a point do not hide the environment from it; 0:
                               * every surface hides what lies behind it */
} candela_environment;

/* A node of the hierarchy. Parents are added before their children. The local matrix is `matrix` where it is
 * not NULL, and translation × rotation × scale otherwise. */
typedef struct candela_node {
    uint32_t struct_size;
    const char* name;
    int32_t parent; /* index of an added node, -1 for a root */
    float translation[3];
    float rotation[4]; /* unit quaternion x, y, z, w */
    float scale[3];
    const float* matrix; /* 16 numbers, column-major, affine */
    int32_t mesh;        /* index of an added mesh, -1 for none */
    uint32_t unused;     /* padding of version 1.0, which is not read */
    /* since 1.3: metres, added in double precision to the translation, or to that of the matrix: what a
     * float can not hold of it */
    double translation_remainder[3];
    /* since 1.4: 1: the node's own mesh and cages cast no shadows; or 0. Its children are not affected. */
    uint32_t casts_no_shadow;
    uint32_t unused_1_4; /* padding of version 1.4, which is not read */
    /* since 1.6: 1: what the node and all nodes below it show is not drawn, and their lights do not light; or
     * 0 */
    uint32_t is_hidden;
} candela_node;

typedef enum candela_animation_path {
    CANDELA_ANIMATE_TRANSLATION = 0, /* 3 numbers a key */
    CANDELA_ANIMATE_ROTATION = 1,    /* 4 numbers a key: quaternion x, y, z, w */
    CANDELA_ANIMATE_SCALE = 2,       /* 3 numbers a key */
    /* since 1.1: a number for each morph target of the node's cage; since 1.3 also of its mesh */
    CANDELA_ANIMATE_MORPH_WEIGHTS = 3
} candela_animation_path;

typedef enum candela_interpolation {
    CANDELA_INTERPOLATE_LINEAR = 0, /* spherical for rotations */
    CANDELA_INTERPOLATE_STEP = 1,
    CANDELA_INTERPOLATE_CUBIC_SPLINE = 2 /* three values a key: in-tangent, value, out-tangent */
} candela_interpolation;

typedef struct candela_animation_channel {
    int32_t node; /* index of an added node, without `matrix` unless the path is MORPH_WEIGHTS */
    candela_animation_path path;
    candela_interpolation interpolation;
    uint32_t key_count;  /* 1 or more */
    const float* times;  /* seconds, 0 or more, strictly increasing */
    const float* values; /* key_count × numbers a key (× 3 for cubic splines) */
} candela_animation_channel;

/* What a candela_property_channel changes (since 1.6): the value of that name of a node, a material, a light
 * or a camera. A value is one number unless another count is given, and has the range of the member that it
 * changes. One that is over 0 is at least 1e-6, and one without a limit at most 1e9. */
typedef enum candela_animated_property {
    /* of a node */
    CANDELA_PROPERTY_MORPH_WEIGHT = 0, /* the weight of one morph target of what the node shows */
    CANDELA_PROPERTY_VISIBILITY = 1,   /* 0: hidden, as is_hidden; otherwise shown; step interpolation */
    /* of a material */
    CANDELA_PROPERTY_BASE_COLOR = 2, /* 4 numbers */
    CANDELA_PROPERTY_METALLIC = 3,
    CANDELA_PROPERTY_ROUGHNESS = 4,
    CANDELA_PROPERTY_EMISSION = 5, /* 3 numbers */
    CANDELA_PROPERTY_EMISSION_STRENGTH = 6,
    CANDELA_PROPERTY_NORMAL_SCALE = 7,
    CANDELA_PROPERTY_OCCLUSION_STRENGTH = 8,
    CANDELA_PROPERTY_ALPHA_CUTOFF = 9,
    CANDELA_PROPERTY_IOR = 10,
    CANDELA_PROPERTY_SPECULAR_FACTOR = 11,
    CANDELA_PROPERTY_SPECULAR_COLOR = 12, /* 3 numbers */
    CANDELA_PROPERTY_CLEARCOAT_FACTOR = 13,
    CANDELA_PROPERTY_CLEARCOAT_ROUGHNESS = 14,
    CANDELA_PROPERTY_CLEARCOAT_NORMAL_SCALE = 15,
    CANDELA_PROPERTY_SHEEN_COLOR = 16, /* 3 numbers */
    CANDELA_PROPERTY_SHEEN_ROUGHNESS = 17,
    CANDELA_PROPERTY_ANISOTROPY_STRENGTH = 18,
    CANDELA_PROPERTY_ANISOTROPY_ROTATION = 19,
    CANDELA_PROPERTY_IRIDESCENCE_FACTOR = 20,
    CANDELA_PROPERTY_IRIDESCENCE_IOR = 21,
    CANDELA_PROPERTY_IRIDESCENCE_MIN_THICKNESS = 22,
    CANDELA_PROPERTY_IRIDESCENCE_MAX_THICKNESS = 23,
    CANDELA_PROPERTY_TRANSMISSION_FACTOR = 24,
    CANDELA_PROPERTY_THICKNESS = 25,
    CANDELA_PROPERTY_ATTENUATION_DISTANCE = 26,
    CANDELA_PROPERTY_ATTENUATION_COLOR = 27, /* 3 numbers */
    CANDELA_PROPERTY_DISPERSION = 28,
    CANDELA_PROPERTY_DIFFUSE_TRANSMISSION_FACTOR = 29,
    CANDELA_PROPERTY_DIFFUSE_TRANSMISSION_COLOR = 30, /* 3 numbers */
    /* of a texture that a material has */
    CANDELA_PROPERTY_TEXTURE_OFFSET = 31, /* 2 numbers */
    CANDELA_PROPERTY_TEXTURE_ROTATION = 32,
    CANDELA_PROPERTY_TEXTURE_SCALE = 33, /* 2 numbers */
    /* of a light */
    CANDELA_PROPERTY_LIGHT_COLOR = 34, /* 3 numbers */
    CANDELA_PROPERTY_LIGHT_INTENSITY = 35,
    CANDELA_PROPERTY_LIGHT_RANGE = 36,      /* of a light that has one */
    CANDELA_PROPERTY_INNER_CONE_ANGLE = 37, /* of a spot light */
    CANDELA_PROPERTY_OUTER_CONE_ANGLE = 38,
    CANDELA_PROPERTY_LIGHT_POSITION = 39, /* 3 numbers */
    /* of a camera that has the value */
    CANDELA_PROPERTY_VERTICAL_FOV = 40,
    CANDELA_PROPERTY_ORTHOGRAPHIC_HEIGHT = 41,
    CANDELA_PROPERTY_NEAR_PLANE = 42,
    CANDELA_PROPERTY_FAR_PLANE = 43
} candela_animated_property;

/* The textures of a material, in the order of its members (since 1.6). */
typedef enum candela_texture_slot {
    CANDELA_SLOT_BASE_COLOR = 0,
    CANDELA_SLOT_METALLIC_ROUGHNESS = 1,
    CANDELA_SLOT_NORMAL = 2,
    CANDELA_SLOT_EMISSION = 3,
    CANDELA_SLOT_OCCLUSION = 4,
    CANDELA_SLOT_SPECULAR = 5,
    CANDELA_SLOT_SPECULAR_COLOR = 6,
    CANDELA_SLOT_CLEARCOAT = 7,
    CANDELA_SLOT_CLEARCOAT_ROUGHNESS = 8,
    CANDELA_SLOT_CLEARCOAT_NORMAL = 9,
    CANDELA_SLOT_SHEEN_COLOR = 10,
    CANDELA_SLOT_SHEEN_ROUGHNESS = 11,
    CANDELA_SLOT_ANISOTROPY = 12,
    CANDELA_SLOT_IRIDESCENCE = 13,
    CANDELA_SLOT_IRIDESCENCE_THICKNESS = 14,
    CANDELA_SLOT_TRANSMISSION = 15,
    CANDELA_SLOT_THICKNESS = 16,
    CANDELA_SLOT_DIFFUSE_TRANSMISSION = 17,
    CANDELA_SLOT_DIFFUSE_TRANSMISSION_COLOR = 18
} candela_texture_slot;

/* The values of a property over time (since 1.6). Where a cubic spline leaves the range between two keys, the
 * nearest value within it counts. */
typedef struct candela_property_channel {
    candela_animated_property property;
    int32_t element; /* index of the added node, material, light or camera that has it */
    uint32_t part;   /* MORPH_WEIGHT: the target; TEXTURE_...: a candela_texture_slot; else not read */
    candela_interpolation interpolation;
    uint32_t key_count;  /* 1 or more */
    uint32_t unused;     /* padding, which is not read */
    const float* times;  /* as in candela_animation_channel */
    const float* values; /* key_count × numbers of a value (× 3 for cubic splines) */
} candela_property_channel;

typedef struct candela_animation {
    uint32_t struct_size;
    const char* name;
    uint32_t channel_count;
    const candela_animation_channel* channels;
    /* since 1.6 */
    uint32_t property_count;
    const candela_property_channel* properties;
} candela_animation;

/* The axis of positions and translations that points up (since 1.6). */
typedef enum candela_up_axis {
    CANDELA_UP_Y = 0,
    CANDELA_UP_Z = 1, /* x stays right, y goes away from who looks along -Z of candela */
    CANDELA_UP_X = 2  /* z stays towards the viewer */
} candela_up_axis;

/* What is known of the whole scene (since 1.6). Where the axis is not Y or the unit not the metre, the host
 * puts all nodes, and lights and cameras without a node, below a node of its own that turns and scales them.
 * Ranges and radii of lights, planes of cameras and the environment are in metres and with +Y up as ever. */
typedef struct candela_scene_info {
    uint32_t struct_size;
    candela_up_axis up_axis;
    double metres_per_unit; /* of positions and translations, over 0; 0: 1 */
    const char* generator;  /* the program that wrote the file, and */
    const char* copyright;  /* to whom the scene belongs: one line each; NULL: unknown */
} candela_scene_info;

/* ---- The host */
typedef struct candela_bytes {
    const uint8_t* data;
    uint64_t size;
} candela_bytes;

/* What a note tells (since 1.3), from the largest loss to none. */
typedef enum candela_note_kind {
    CANDELA_NOTE_MISSING = 0,    /* something of the file is not in the picture, or in a simpler form */
    CANDELA_NOTE_REPAIRED = 1,   /* a value that the format forbids was replaced by one that it allows */
    CANDELA_NOTE_INFORMATION = 2 /* nothing is lost: such as which of several scenes is drawn */
} candela_note_kind;

/* The body of a parallel loop. `index` is below the loop's count. `worker` is below the host's
 * `worker_count` and differs between calls that run at the same time. The body must not throw. */
typedef void (*candela_parallel_body)(void* context, uint32_t index, uint32_t worker);

/* ---- What a plugin changes from frame to frame (since 1.6) */
/* What the host does for a frame callback. Indices and counts are those of the elements as the importer added
 * them. A function that does not return CANDELA_OK has recorded its reason; the callback then returns
 * CANDELA_FAILED. Arrays are copied. What a call does not set is as the importer added it, and as animations
 * have it; what it sets takes precedence over animations. */
typedef struct candela_frame {
    uint32_t struct_size;
    uint32_t worker_count; /* as in candela_host */
    void* self;
    double seconds; /* the time of the scene */

    /* Records why the frame fails; `element` names the part at fault; NULL or empty: none. */
    void (*fail)(void* self, const char* element, const char* reason);
    /* The vertices of a mesh with is_moved: 3 numbers each, metres. `vertex_count` is that of the mesh, and
     * every number is finite and at most 1e9. `normals` are normalised; NULL: the host computes those of
     * triangles, flat ones for a mesh that was added without normals and crease_angle; otherwise smooth ones,
     * where vertices of the same position and normal count as one. Tangents stay. */
    candela_status (*set_vertices)(void* self, int32_t mesh, uint32_t vertex_count, const float* positions,
                                   const float* normals);
    /* The same of a cage with is_moved, whose normals come from its limit surface. */
    candela_status (*set_cage_vertices)(void* self, int32_t cage, uint32_t vertex_count,
                                        const float* positions);
    /* The local matrix of a node: 16 numbers, column-major, affine, in double precision for scenes far from
     * the origin. */
    candela_status (*set_transform)(void* self, int32_t node, const double* matrix);
    /* A property of a node, a material, a light or a camera. `element` and `part` are as in
     * candela_property_channel, `count` is that of the numbers of a value, which are in the property's range.
     * Not MORPH_WEIGHT. */
    candela_status (*set_property)(void* self, candela_animated_property property, int32_t element,
                                   uint32_t part, uint32_t count, const float* numbers);
    /* As in candela_host: files of the scene's folder, such as the frames of a cache. */
    candela_status (*file_size)(void* self, const char* path, uint64_t* size);
    candela_status (*read_file_part)(void* self, const char* path, uint64_t offset, uint64_t size,
                                     void* into);
    void (*parallel_for)(void* self, uint32_t count, candela_parallel_body body, void* context);
} candela_frame;

/* Changes the scene before it is shown at another time. */
typedef struct candela_frame_callback {
    uint32_t struct_size;
    uint32_t unused; /* padding, which is not read */
    void* user;      /* the plugin's own, handed to the functions */
    /* Sets what `frame->seconds` changes. Frames are drawn in any order and alone, by several machines, and
     * a frame with a shutter at several times: what is set depends on the time alone. A simulation keeps a
     * cache, or computes from its start to the time. Called for one time after another, also before the
     * import ends, from any thread, but not from two at once. */
    candela_status (*update)(void* user, const candela_frame* frame);
    /* Called once, after the last copy of the scene, from any thread; NULL: nothing is to be done. Where
     * set_frame_callback has not returned CANDELA_OK, neither function is ever called. */
    void (*destroy)(void* user);
    double first_second; /* where the motion begins and ends: for time lines, and for cameras that frame it */
    double last_second;
} candela_frame_callback;

/* What the host does for an importer. Each function takes the `self` of this struct. The functions that add
 * an element return its index (0, 1, 2, ... for each kind), or -1 when the host refuses it. */
typedef struct candela_host {
    uint32_t struct_size;
    void* self;

    /* Reads a file of the scene's folder, `path` relative to it with '/' between its parts. The host refuses
     * absolute paths, paths that leave the folder, also by a symbolic link, and everything that is not a
     * regular file. */
    candela_status (*read_file)(void* self, const char* path, candela_bytes* out);
    /* Records why the import fails; `element` names the part at fault, such as "mesh 3 'wheel', primitive 0".
     */
    void (*fail)(void* self, const char* element, const char* reason);
    /* Adds a note to the import report: something of the file that is not drawn or not used. Since 1.3
     * `add_note` takes its place. */
    void (*note)(void* self, const char* text);
    /* Reports the progress of the import, 0 to 1. Anything but CANDELA_OK asks the importer to stop and
     * return CANDELA_FAILED. */
    candela_status (*progress)(void* self, double fraction);

    int32_t (*add_image)(void* self, const candela_image* image);
    int32_t (*add_material)(void* self, const candela_material* material);
    int32_t (*add_mesh)(void* self, const candela_mesh* mesh);
    int32_t (*add_node)(void* self, const candela_node* node);
    int32_t (*add_camera)(void* self, const candela_camera* camera);
    int32_t (*add_light)(void* self, const candela_light* light);
    int32_t (*add_animation)(void* self, const candela_animation* animation);

    /* since 1.1 */
    int32_t (*add_cage)(void* self, const candela_cage* cage);
    int32_t (*add_skin)(void* self, const candela_skin* skin);
    candela_status (*add_cage_instance)(void* self, const candela_cage_instance* instance);

    /* since 1.2 */
    uint32_t
        worker_count; /* the largest number of calls that `parallel_for` runs at the same time; 1 or more */
    /* Calls `body(context, index, worker)` for each index below `count`, in no particular order, on the
     * threads of the host. Returns when all calls have returned. */
    void (*parallel_for)(void* self, uint32_t count, candela_parallel_body body, void* context);

    /* since 1.3 */
    /* Adds a note to the import report. `element` names the part it is about, such as "mesh 3 'wheel'"; NULL
     * or empty: the whole file. The host merges notes of the same kind and text into one that counts its
     * elements, so `text` holds nothing that differs between elements. */
    void (*add_note)(void* self, candela_note_kind kind, const char* element, const char* text);
    /* Reads a file as `read_file` does, but the import goes on without a file that cannot be read: `reason`
     * then says why, such as "file 'a.png': there is no such file", and is valid until `import_scene`
     * returns. It is empty when the import has failed before. Where no file has the very name, one whose name
     * differs in the case of ASCII letters is read, and noted. */
    candela_status (*read_optional_file)(void* self, const char* path, candela_bytes* out,
                                         const char** reason);
    candela_status (*add_deformation)(void* self, const candela_deformation* deformation);

    /* since 1.5: at most once */
    candela_status (*set_environment)(void* self, const candela_environment* environment);

    /* since 1.6 */
    /* Adds a variant of the scene, in which submeshes have other materials: see candela_mesh. Its name is
     * what a user selects it by. */
    int32_t (*add_variant)(void* self, const char* name);
    /* Add `count` elements of an array in one call. All have the struct_size of the first one, which is the
     * distance of two. Return the index of the first; the others follow. */
    int32_t (*add_nodes)(void* self, const candela_node* nodes, uint32_t count);
    int32_t (*add_lights)(void* self, const candela_light* lights, uint32_t count);
    /* Decodes `count` files of images on all threads, by the plugins that decode images (see
     * candela_image_decoder), and adds them. `indices` gets an index for each, and -1 for one that cannot be
     * decoded: `reasons` then says why, valid until `import_scene` returns, and the import goes on. Elsewhere
     * `reasons` is NULL. Fails when the import has failed before, or an argument is NULL. */
    candela_status (*add_image_bytes)(void* self, const candela_image_bytes* images, uint32_t count,
                                      int32_t* indices, const char** reasons);
    /* At most once. */
    candela_status (*set_scene_info)(void* self, const candela_scene_info* info);
    /* The bytes of a file, and `size` of them from `offset` on, which are read into the plugin's memory: for
     * files of which only parts are needed. `path` is as for read_file. Bytes beyond the end fail. */
    candela_status (*file_size)(void* self, const char* path, uint64_t* size);
    candela_status (*read_file_part)(void* self, const char* path, uint64_t offset, uint64_t size,
                                     void* into);
    /* At most once, before or after the elements that it changes. */
    candela_status (*set_frame_callback)(void* self, const candela_frame_callback* callback);
} candela_host;

/* ---- The subdivider (since 1.1) */
/* Stencils: stencil i has the entries offsets[i] to offsets[i + 1] - 1. Its value is the sum over its entries
 * of weight × control point (or texture coordinate of the cage). */
typedef struct candela_stencil_table {
    uint32_t stencil_count;
    const uint32_t* offsets;         /* stencil_count + 1: the first one 0, not decreasing */
    const uint32_t* control_indices; /* one an entry: a vertex of the cage, or one of its uvs */
    const float* weights;            /* of the limit value */
    const float* du_weights;         /* of its derivative along the first parameter of the face */
    const float* dv_weights;         /* of its derivative along the second */
} candela_stencil_table;

/* A refined cage. It has `point_count` distinct limit points and `vertex_count` vertices to draw. Vertex i
 * lies at point i for i < point_count. The others are seam vertices: each shares the position of a point, but
 * has tangents or texture coordinates of its own, on the other side of a crease or of a texture seam. Faces
 * that meet at an edge have the same points along it. du × dv points outwards. */
typedef struct candela_refined_cage {
    uint32_t struct_size;
    uint32_t point_count, vertex_count;
    const uint32_t* seam_points;     /* vertex_count - point_count: the point of each seam vertex */
    candela_stencil_table positions; /* a stencil a vertex, of the cage's vertices; a seam vertex has the
                                      * position of its point and only the derivatives of its own stencil */
    candela_stencil_table uvs;       /* a stencil a vertex, of the cage's uvs; empty for a cage without uvs */
    uint32_t face_size;              /* 4, or 3 for the Loop scheme */
    uint32_t face_count;
    const uint32_t* face_vertices; /* face_size a face, counter-clockwise */
    const uint32_t* cage_faces;    /* the face of the cage that each face is part of */
} candela_refined_cage;

/* What the host does for a subdivider. */
typedef struct candela_refinement {
    uint32_t struct_size;
    void* self;
    /* Records why the cage is rejected; `element` names the part at fault, such as "face 7" or "edge 3-8". */
    void (*fail)(void* self, const char* element, const char* reason);
    /* Sets the result, which the host checks and copies before it returns. Called once. */
    candela_status (*set_result)(void* self, const candela_refined_cage* refined);
    /* since 1.2: as those of candela_host */
    uint32_t worker_count;
    void (*parallel_for)(void* self, uint32_t count, candela_parallel_body body, void* context);
} candela_refinement;

typedef struct candela_subdivider {
    uint32_t struct_size;
    /* Refines a cage so that each edge of it becomes 2^level edges on the limit surface. `level` is 1 to 8.
     * May be called from several threads at once. */
    candela_status (*refine)(const candela_refinement* refinement, const candela_cage* cage, uint32_t level);
} candela_subdivider;

/* ---- The image decoder (since 1.6) */
/* What the host does for a decoder. */
typedef struct candela_decoding {
    uint32_t struct_size;
    void* self;
    /* Records why the image cannot be decoded: "a PNG file that is cut off". */
    void (*fail)(void* self, const char* reason);
    /* Sets the result, which the host checks and copies before it returns. Called once. Its name is not read.
     */
    candela_status (*set_result)(void* self, const candela_image* image);
} candela_decoding;

/* Decodes files of images for importers that call add_image_bytes. Both functions may be called from several
 * threads at once. */
typedef struct candela_image_decoder {
    uint32_t struct_size;
    /* 1 when the bytes begin as a file of a format does that this decoder has; or 0. */
    uint32_t (*recognizes)(const uint8_t* bytes, uint64_t size);
    candela_status (*decode)(const candela_decoding* decoding, const uint8_t* bytes, uint64_t size);
} candela_image_decoder;

/* ---- The plugin */
/* What an option's value is (since 1.6). Without a value ("?flip"), a flag is 1 and a keyword is its first
 * one; the others need one ("?level=3"). */
typedef enum candela_option_type {
    CANDELA_OPTION_FLAG = 0, /* 0 or 1 */
    CANDELA_OPTION_INTEGER = 1,
    CANDELA_OPTION_NUMBER = 2,
    CANDELA_OPTION_TEXT = 3,
    CANDELA_OPTION_KEYWORD = 4
} candela_option_type;

/* An option of an importer (since 1.6), which a user gives in the query: "model.obj?level=3&flip". The host
 * lists it with its help, refuses others and values out of range, and hands the values over in the request.
 */
typedef struct candela_option {
    const char* name; /* a to z, 0 to 9, '-' and '_' */
    const char* help; /* one line */
    candela_option_type type;
    uint32_t unused;            /* padding, which is not read */
    double minimum, maximum;    /* of INTEGER and NUMBER, both included; both 0: no limits */
    const char* const* keywords; /* of KEYWORD, ended by NULL */
} candela_option;

/* The value that a user has given an option (since 1.6). */
typedef struct candela_option_value {
    uint32_t option;  /* index of candela_importer::options */
    uint32_t unused;  /* padding of 0 */
    double number;    /* of FLAG, INTEGER and NUMBER; of KEYWORD the index of the keyword */
    const char* text; /* as the user gave it; of KEYWORD the keyword */
} candela_option_value;

typedef struct candela_request {
    uint32_t struct_size;
    const char* uri; /* as the user gave it */
    const char*
        name; /* a file: its name, to be read with read_file; a procedural scene: what follows "scheme:" */
    /* since 1.1: what follows '?' behind a file's name; NULL where there is none. An importer refuses a query
     * that it does not know. One built for 1.0 is never given any: the host refuses it. */
    const char* query;
    /* since 1.6: those options of the importer that the query gives, each once, in its order */
    uint32_t option_count;
    const candela_option_value* options;
} candela_request;

typedef struct candela_importer {
    uint32_t struct_size;
    const char* const* extensions; /* file name endings without the dot, lower case, ended by NULL; or NULL */
    const char* const* schemes;    /* URI schemes of procedural scenes, lower case, ended by NULL; or NULL */
    candela_status (*import_scene)(const candela_host* host, const candela_request* request);
    /* since 1.6; 0: the importer reads the query itself */
    uint32_t option_count;
    const candela_option* options;
} candela_importer;

typedef struct candela_plugin {
    uint32_t struct_size;
    uint32_t major, minor; /* CANDELA_PLUGIN_MAJOR and CANDELA_PLUGIN_MINOR that it was built with */
    const char* name;      /* a to z, 0 to 9, '-' and '_' */
    const char* version;
    const char* description;              /* one line */
    const candela_importer* importer;     /* NULL when it offers none */
    const candela_subdivider* subdivider; /* since 1.1: NULL when it offers none; one service at least */
    const candela_image_decoder* image_decoder; /* since 1.6: NULL when it offers none */
} candela_plugin;

/* The type of the one exported symbol. Returns a static description, or NULL when the plugin cannot serve
 * such a host. */
typedef const candela_plugin* (*candela_plugin_query_function)(uint32_t host_major, uint32_t host_minor);

#define CANDELA_PLUGIN_EXPORT __attribute__((visibility("default")))

CANDELA_PLUGIN_EXPORT const candela_plugin* candela_plugin_query(uint32_t host_major, uint32_t host_minor);

/* ---- Initialisers (since 1.6), in C and C++: `candela_material red = CANDELA_MATERIAL_INIT;`
 * What they leave out is absent: no texture, no parent, no mesh, no node. A material is that of surfaces
 * without one, white, rough and no metal; the lobes and media below it have no effect until their factor is
 * raised. A light is a white point light of 1 candela; counts are 0 and arrays NULL. */
#define CANDELA_TEXTURE_INIT                                                                                  \
    {                                                                                                         \
        -1, 0, CANDELA_WRAP_REPEAT, CANDELA_WRAP_REPEAT, CANDELA_FILTER_LINEAR_MIPMAP_LINEAR,                 \
            CANDELA_FILTER_LINEAR, {0.0f, 0.0f}, 0.0f, {1.0f, 1.0f}                                           \
    }
#define CANDELA_IMAGE_INIT                                                                                    \
    { sizeof(candela_image), NULL, 0, 0, CANDELA_PIXELS_RGBA8, NULL, 0 }
#define CANDELA_SPECULAR_INIT                                                                                 \
    { 1.0f, {1.0f, 1.0f, 1.0f}, NULL, NULL }
#define CANDELA_CLEARCOAT_INIT                                                                                \
    { 0.0f, 0.0f, 1.0f, NULL, NULL, NULL }
#define CANDELA_SHEEN_INIT                                                                                    \
    { {0.0f, 0.0f, 0.0f}, 0.0f, NULL, NULL }
#define CANDELA_ANISOTROPY_INIT                                                                               \
    { 0.0f, 0.0f, NULL }
#define CANDELA_IRIDESCENCE_INIT                                                                              \
    { 0.0f, 1.3f, 100.0f, 400.0f, NULL, NULL }
#define CANDELA_TRANSMISSION_INIT                                                                             \
    { 0.0f, NULL }
#define CANDELA_VOLUME_INIT                                                                                   \
    { 0.0f, 0.0f, {1.0f, 1.0f, 1.0f}, 0.0f, NULL }
#define CANDELA_DIFFUSE_TRANSMISSION_INIT                                                                     \
    { 0.0f, {1.0f, 1.0f, 1.0f}, NULL, NULL }
#define CANDELA_MATERIAL_INIT                                                                                 \
    {                                                                                                         \
        sizeof(candela_material), NULL, {1.0f, 1.0f, 1.0f, 1.0f}, 0.0f, 1.0f, {0.0f, 0.0f, 0.0f},             \
            CANDELA_TEXTURE_INIT, CANDELA_TEXTURE_INIT, CANDELA_TEXTURE_INIT, CANDELA_TEXTURE_INIT,           \
            CANDELA_TEXTURE_INIT, 1.0f, 1.0f, CANDELA_ALPHA_OPAQUE, 0.5f, 0, 0, 0.0f, NULL, NULL, NULL, NULL, \
            NULL, NULL, NULL, NULL, NULL                                                                      \
    }
#define CANDELA_SUBMESH_INIT                                                                                  \
    { 0, 0, -1 }
#define CANDELA_MESH_INIT                                                                                     \
    {                                                                                                         \
        sizeof(candela_mesh), NULL, 0, NULL, NULL, NULL, NULL, NULL, NULL, 0, NULL, 0, NULL, 0, NULL, 0,      \
            NULL, NULL, 0, NULL, NULL, NULL, 0, NULL, NULL, 0, NULL, 0.0f, 0                                  \
    }
#define CANDELA_CAGE_INIT                                                                                     \
    {                                                                                                         \
        sizeof(candela_cage), NULL, CANDELA_SCHEME_CATMULL_CLARK, CANDELA_BOUNDARY_EDGES_AND_CORNERS,         \
            CANDELA_FACE_VARYING_CORNERS_PLUS1, CANDELA_CREASE_UNIFORM, CANDELA_TRIANGLE_CATMULL_CLARK, 0,    \
            NULL, 0, NULL, NULL, 0, NULL, NULL, 0, NULL, NULL, 0, NULL, NULL, 0, NULL, NULL, 0, 0, NULL,      \
            NULL, 0, NULL, 0, NULL, 0                                                                         \
    }
#define CANDELA_SKIN_INIT                                                                                     \
    { sizeof(candela_skin), NULL, 0, NULL, NULL }
#define CANDELA_CAGE_INSTANCE_INIT                                                                            \
    { sizeof(candela_cage_instance), -1, -1, -1, 0, NULL }
#define CANDELA_DEFORMATION_INIT                                                                              \
    { sizeof(candela_deformation), -1, -1, 0, NULL }
#define CANDELA_CAMERA_INIT                                                                                   \
    { sizeof(candela_camera), NULL, 0.785398f, 0.0f, -1, 0, 0, 0.0f, 0.0f }
#define CANDELA_LIGHT_INIT                                                                                    \
    {                                                                                                         \
        sizeof(candela_light), NULL, CANDELA_LIGHT_POINT, {1.0f, 1.0f, 1.0f}, 1.0f, 0.0f, 0.0f, 0.785398f,    \
            {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, -1, 0, 0, 0.0f                                           \
    }
#define CANDELA_ENVIRONMENT_INIT                                                                              \
    {                                                                                                         \
        sizeof(candela_environment), NULL, 0, 0, NULL, 0, {0.0f, 0.0f, 0.0f, 1.0f}, 1.0f, 0, 0.0f             \
    }
#define CANDELA_NODE_INIT                                                                                     \
    {                                                                                                         \
        sizeof(candela_node), NULL, -1, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f},     \
            NULL, -1, 0, {0.0, 0.0, 0.0}, 0, 0, 0                                                             \
    }
#define CANDELA_ANIMATION_INIT                                                                                \
    { sizeof(candela_animation), NULL, 0, NULL, 0, NULL }
#define CANDELA_FRAME_CALLBACK_INIT                                                                           \
    { sizeof(candela_frame_callback), 0, NULL, NULL, NULL, 0.0, 0.0 }
#define CANDELA_SCENE_INFO_INIT                                                                               \
    { sizeof(candela_scene_info), CANDELA_UP_Y, 1.0, NULL, NULL }

#ifdef __cplusplus
}
#endif

#endif
