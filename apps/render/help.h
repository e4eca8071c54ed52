#pragma once

/// The texts of --help, other than those of the shared options.
namespace help {

constexpr const char* description =
    "Draws a scene lit by any number of point lights into a picture file. Needs no window and no screen, "
    "and\n"
    "falls back to a software rasteriser where there is no GPU.\n";

constexpr const char* output =
    "Picture to write. The ending chooses: .png as the display shows it, 8 bits;\n"
    ".exr scene-linear. {camera} in it becomes the camera's name. - is standard\n"
    "output, a .png unless --format or --raw says otherwise. Default: candela.png";
constexpr const char* format = "Format of -o -: png or exr. Default: png";
constexpr const char* raw =
    "Write bare pixels instead of a picture file: rgba8, as a .png has them. For\n"
    "ffmpeg -f rawvideo -pix_fmt rgba -s WxH -r FPS -i -";
constexpr const char* pngLevel =
    "How small a .png gets: 0 (not compressed) to 9 (slow). The pixels are the\n"
    "same. Default: 1";
constexpr const char* exrPixels =
    "Numbers of an .exr: float, or half, which are half as large, with Z, P and\n"
    "counts still float. Default: float";
constexpr const char* compression =
    "Compression of an .exr: zip, piz or none, without loss, or dwaa, small with\n"
    "little loss. Default: zip";
constexpr const char* encodeThreads =
    "Threads that encode pictures beside the drawing of the next, 0 to 1024.\n"
    "Default: 0, as many as --threads";
constexpr const char* panorama =
    "Draw all directions around the camera: an equirectangular picture, twice as\n"
    "wide as high, from the faces of a cube; the AOV Z is the distance from the eye\n"
    "there. Default --size: 2048x1024";
constexpr const char* tile =
    "Draw the picture in parts, whose frames have sides of at most N pixels, 64 to\n"
    "16384; it is the same. Memory holds two rows of parts. Default: as a whole\n"
    "up to 2^25 pixels and 16384 a side, larger ones in parts of 8192x1024";
constexpr const char* aovFilter =
    "How the samples of an AOV become one value: average, first (the sample in the\n"
    "pixel's middle), or auto: first for Z, P, ids and motion, average for all\n"
    "others. The header of the .exr tells which. Default: auto";
constexpr const char* aoDistance =
    "What is farther than so many metres from a surface does not darken its\n"
    "ambient_occlusion, between 0 and 1e9. Default: 1";
constexpr const char* aoRays = "Rays that ambient_occlusion takes at each pixel, 1 to 4096. Default: 64";
constexpr const char* frames =
    "Draw frames of the scene's animation (see --fps): A-B, A-BxSTEP, single\n"
    "numbers, or several of these separated by commas. A run of # in the picture's\n"
    "name becomes the frame number; without one, out.png gives out.0007.png";
constexpr const char* turntable =
    "Draw N frames of the camera's turn around the scene, at the time of --time";
constexpr const char* shard =
    "Draw the I-th of N equal parts of all pictures, I from 1; slurm takes both\n"
    "from the task of a Slurm array. A picture is the same whoever draws it";
constexpr const char* skipExisting = "Leave out pictures whose whole file is there";
constexpr const char* placeholders =
    "Share a list of pictures among processes: PICTURE.lock stands beside a picture\n"
    "while one draws it, and the others leave it out. Implies --skip-existing";
constexpr const char* keepGoing = "When a picture fails, draw the others; at the end, code 1 and their names";
constexpr const char* mkdir = "Create the folders of pictures that are missing";
constexpr const char* camera =
    "A camera of the scene, by the name of its node, its own name or its number in\n"
    "the file, from 0; several separated by commas, or all, with a picture each:\n"
    "out.png gives out.NAME.png. Default: the first one; where there is none, one\n"
    "that frames what is drawn and its whole motion";
constexpr const char* device =
    "Draw on this device of --list devices, on the software rasteriser, or auto:\n"
    "the processes of a machine take turns with its GPUs. Default: $CANDELA_DEVICE,\n"
    "else a GPU if there is one";
constexpr const char* progress =
    "json: tell on standard error what is done, an object a line. Default:\n"
    "terminal, one line that changes, on a terminal only";
constexpr const char* stats =
    "Write what was drawn and how long it took, as JSON (- is standard output).\n"
    "Times are the wall clock of one frame, up to the finished picture in memory.\n"
    "After one drawing that is not counted, the frame is drawn 5 times; with\n"
    "--frames each frame once, and a picture in parts once. A pass's time is the\n"
    "median of these, of all samples of a picture together. \"shadows\" has the\n"
    "occlusion rays of the last frame and what they are traced in; it is null\n"
    "without shadows and in a debug view";
constexpr const char* quiet = "Say nothing but errors: no notes, no progress and no result";

constexpr const char* list =
    "Show plugins, devices, displays or views (of --display, if given), or the\n"
    "animations, cameras, materials, variants, environment or contents of SCENE:\n"
    "what it holds, and what of it is drawn otherwise or not. Draw nothing";

constexpr const char* footer =
    "Examples:\n"
    "  candela-render plaza:4096                            4096 lights, into candela.png\n"
    "  candela-render room.glb -o room.png --scatter-lights 1000,2,5\n"
    "                                                       1000 more lights of 5 cd that reach 2 m\n"
    "  candela-render room.glb -o room.exr --aov all        every channel, for compositing\n"
    "  candela-render room.glb -o 'out/####.png' --frames 0-47\n"
    "                                                       two seconds of its animation\n"
    "  candela-render room.glb -o 'out/####.png' --frames 0-47 --shard slurm\n"
    "                                                       a task's part of it (docs/farm.md)\n"
    "  candela-render plaza:256 --size 640x360 --stats - --quiet\n"
    "                                                       how fast is this machine\n"
    "\n"
    "Exit codes:\n"
    "  0  done\n"
    "  1  the scene, another file or this machine is at fault; one line says which, what and why\n"
    "  2  wrong usage\n"
    "  128 + N  ended by signal N (Ctrl-C is 2); what is done has been said\n"
    "A picture is written whole or not at all.";

}  // namespace help
