#pragma once

/// The texts of --help, a constant an option.
namespace help {

constexpr const char* description =
    "Draws a scene lit by any number of point lights into a picture file. Needs no window and no screen, "
    "and\n"
    "falls back to a software rasteriser where there is no GPU.\n";

constexpr const char* scene =
    "A file that a plugin reads (.gltf, .glb), or a made scene such as plaza:4096,\n"
    "the benchmark scene with that many lights";
constexpr const char* scatterLights =
    "Strew N more point lights over the scene's box, the same ones every time.\n"
    "RANGE in metres (default: twice their mean spacing), CANDELA each (default:\n"
    "RANGE x RANGE / 10)";
constexpr const char* pluginPath = "Search this folder for plugins first. May be given several times";

constexpr const char* output =
    "Picture to write. The ending chooses: .png as the display shows it, 8 bits;\n"
    ".exr scene-linear, 32-bit float. Default: candela.png";
constexpr const char* size = "Width and height in pixels, 1 to 16384 each. Default: 1280x720";
constexpr const char* aov =
    "More channels for an .exr, separated by commas: Z, P, N, base_color, metallic,\n"
    "roughness, emission, light_count";
constexpr const char* frames =
    "Draw frames A to B of the scene's animation, 24 a second. A run of # in the\n"
    "picture's name becomes the frame number; without one, out.png gives\n"
    "out.0007.png";
constexpr const char* time = "Time of the picture, or of frame 0, in seconds. Default: 0";

constexpr const char* camera =
    "A camera of the scene, by name or by number from 0. Default: the first one;\n"
    "where there is none, one that frames the scene";
constexpr const char* eye = "Look from here instead, in metres, +Y up. Needs --target";
constexpr const char* target = "Look at this point. Needs --eye";
constexpr const char* fov =
    "Vertical field of view in degrees, between 0 and 180. Default: the camera's,\n"
    "or 45";

constexpr const char* brdf =
    "Reflection model: course (GGX with Schlick-Smith), or gltf (height-correlated,\n"
    "energy-compensated). Default: course";
constexpr const char* technique =
    "How lights come to pixels: auto, tiles (binned to the screen), volumes\n"
    "(rasterised), or fullscreen (every light at every pixel, the reference). All\n"
    "give the same picture. Default: auto";

constexpr const char* ocio = "OpenColorIO config. Default: the file $OCIO names, else a built-in one";
constexpr const char* display = "Display of the config that a .png is made for. Default: the config's";
constexpr const char* view = "View of that display. Default: the display's";
constexpr const char* look = "Look to apply. Default: none";
constexpr const char* exposure =
    "Brighten by this many stops (each doubles the light), between -64 and 64.\n"
    "Default: 0. Like display, view and look it is for .png only";

constexpr const char* device =
    "Draw on this device of --list devices, or on the software rasteriser.\n"
    "Default: a GPU if there is one";
constexpr const char* stats =
    "Write what was drawn and how long it took, as JSON (- is standard output).\n"
    "Times are the wall clock of one frame, up to the finished picture in memory.\n"
    "After one drawing that is not counted, the frame is drawn 5 times; with\n"
    "--frames each frame once. A pass's time is the median of these";
constexpr const char* quiet = "Say nothing but errors";

constexpr const char* list =
    "Show plugins, devices, displays or views, and draw nothing. Views are those of\n"
    "--display, if given";
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
