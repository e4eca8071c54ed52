#pragma once

/// The texts of --help of the options that all programs with a picture share, a constant an option.
namespace help {

constexpr const char* scene =
    "A file that a plugin reads (.gltf, .glb, .obj), or a procedural scene such as\n"
    "plaza:4096, the benchmark scene with that many lights";
constexpr const char* scatterLights =
    "Scatter N more point lights over the scene's box, the same ones every time.\n"
    "RANGE in metres (default: twice their mean spacing), CANDELA each (default:\n"
    "RANGE x RANGE / 10); another SEED (default: 1) scatters them otherwise";
constexpr const char* pluginPath = "Search this folder for plugins first. May be given several times";
constexpr const char* time = "Time of the picture, or of frame 0, in seconds. Default: 0";

constexpr const char* size = "Width and height in pixels, 1 to 16384 each. Default: 1280x720";
constexpr const char* show =
    "Show something else than the lit picture: normals, level (of subdivision),\n"
    "base_color, metallic, roughness, depth, emission or light_count; and lines\n"
    "over it: wireframe, cage. Several are separated by commas, such as\n"
    "level,wireframe";

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

constexpr const char* subdivisionLevel =
    "Refine every subdivision cage to this level, 1 to 8. Default: the cage's own\n"
    "level, if it states one, else as its size in the picture asks for";
constexpr const char* subdivisionEdge =
    "The length in pixels that edges of a refined cage should have. Default: 8";
constexpr const char* subdivisionMaxLevel =
    "The greatest level that --subdivision-edge may lead to, 1 to 8. Default: 5";

constexpr const char* ocio = "OpenColorIO config. Default: the file $OCIO names, else a built-in one";
constexpr const char* display = "Display of the config that a .png is made for. Default: the config's";
constexpr const char* view = "View of that display. Default: the display's";
constexpr const char* look = "Look to apply. Default: none";
constexpr const char* exposure =
    "Brighten by this many stops (each doubles the light), between -64 and 64.\n"
    "Default: 0. Like display, view and look it is for .png only";

}  // namespace help
