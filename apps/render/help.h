#pragma once

/// The texts of --help, other than those of the shared options.
namespace help {

constexpr const char* description =
    "Draws a scene lit by any number of point lights into a picture file. Needs no window and no screen, "
    "and\n"
    "falls back to a software rasteriser where there is no GPU.\n";

constexpr const char* output =
    "Picture to write. The ending chooses: .png as the display shows it, 8 bits;\n"
    ".exr scene-linear, 32-bit float. Default: candela.png";
constexpr const char* aovFilter =
    "How the samples of an AOV become one value: average, first (the sample in the\n"
    "pixel's middle), or auto: first for Z and P, average for all others. The\n"
    "header of the .exr tells which. Default: auto";
constexpr const char* aoDistance =
    "What is farther than so many metres from a surface does not darken its\n"
    "ambient_occlusion, between 0 and 1e9. Default: 1";
constexpr const char* aoRays = "Rays that ambient_occlusion takes at each pixel, 1 to 4096. Default: 64";
constexpr const char* frames =
    "Draw frames of the scene's animation (see --fps): A-B, A-BxSTEP, single\n"
    "numbers, or several of these separated by commas. A run of # in the picture's\n"
    "name becomes the frame number; without one, out.png gives out.0007.png";

constexpr const char* device =
    "Draw on this device of --list devices, or on the software rasteriser.\n"
    "Default: a GPU if there is one";
constexpr const char* stats =
    "Write what was drawn and how long it took, as JSON (- is standard output).\n"
    "Times are the wall clock of one frame, up to the finished picture in memory.\n"
    "After one drawing that is not counted, the frame is drawn 5 times; with\n"
    "--frames each frame once. A pass's time is the median of these, of all samples\n"
    "of a picture together. \"shadows\" has\n"
    "the occlusion rays of the last frame and what they are traced in; it is null\n"
    "without shadows and in a debug view";
constexpr const char* quiet = "Say nothing but errors: no notes, no progress and no result";

constexpr const char* list =
    "Show plugins, devices, displays or views (of --display, if given), or the\n"
    "animations, cameras, materials, variants, environment or contents of SCENE:\n"
    "what it holds, and what of it is drawn otherwise or not. Draw nothing";
constexpr const char* help = "Show this help";
constexpr const char* version = "Show the version";

constexpr const char* footer =
    "Examples:\n"
    "  candela-render plaza:4096                            4096 lights, into candela.png\n"
    "  candela-render room.glb -o room.png --scatter-lights 1000,2,5\n"
    "                                                       1000 more lights of 5 cd that reach 2 m\n"
    "  candela-render room.glb -o room.exr --aov all        every channel, for compositing\n"
    "  candela-render room.glb -o 'out/####.png' --frames 0-47\n"
    "                                                       two seconds of its animation\n"
    "  candela-render plaza:256 --size 640x360 --stats - --quiet\n"
    "                                                       how fast is this machine\n"
    "\n"
    "Exit codes:\n"
    "  0  done\n"
    "  1  the scene, another file or this machine is at fault; one line says which, what and why\n"
    "  2  wrong usage\n"
    "A picture is written whole or not at all.";

}  // namespace help
