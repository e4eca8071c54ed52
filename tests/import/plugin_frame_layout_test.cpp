// The binary layout of plugin.h, continued from plugin_layout_test.cpp: of the whole scene, and of frame callbacks.
#include <candela/plugin.h>

#include <cstddef>

// clang-format off
static_assert(offsetof(candela_scene_info, struct_size) == 0);
static_assert(offsetof(candela_scene_info, up_axis) == 4);
static_assert(offsetof(candela_scene_info, metres_per_unit) == 8);
static_assert(offsetof(candela_scene_info, generator) == 16);
static_assert(offsetof(candela_scene_info, copyright) == 24);
static_assert(sizeof(candela_scene_info) == 32);

static_assert(offsetof(candela_frame, struct_size) == 0);
static_assert(offsetof(candela_frame, worker_count) == 4);
static_assert(offsetof(candela_frame, self) == 8);
static_assert(offsetof(candela_frame, seconds) == 16);
static_assert(offsetof(candela_frame, fail) == 24);
static_assert(offsetof(candela_frame, set_vertices) == 32);
static_assert(offsetof(candela_frame, set_cage_vertices) == 40);
static_assert(offsetof(candela_frame, set_transform) == 48);
static_assert(offsetof(candela_frame, set_property) == 56);
static_assert(offsetof(candela_frame, file_size) == 64);
static_assert(offsetof(candela_frame, read_file_part) == 72);
static_assert(offsetof(candela_frame, parallel_for) == 80);
static_assert(sizeof(candela_frame) == 88);

static_assert(offsetof(candela_frame_callback, struct_size) == 0);
static_assert(offsetof(candela_frame_callback, unused) == 4);
static_assert(offsetof(candela_frame_callback, user) == 8);
static_assert(offsetof(candela_frame_callback, update) == 16);
static_assert(offsetof(candela_frame_callback, destroy) == 24);
static_assert(offsetof(candela_frame_callback, first_second) == 32);
static_assert(offsetof(candela_frame_callback, last_second) == 40);
static_assert(sizeof(candela_frame_callback) == 48);
// clang-format on
