#pragma once

#include "common/scene_options.h"

#include <candela/context.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

enum class ListKind { plugins, devices, displays, views };
enum class PictureFormat { png, exr };

/// Frames `first` to `last`, both drawn.
struct FrameRange {
    int first = 0, last = 0;
};

/// The command line, checked as far as it can be without a file or a device.
struct Options : SceneOptions {
    std::filesystem::path output = "candela.png";
    PictureFormat format = PictureFormat::png;
    std::vector<std::string> aovs;
    std::optional<FrameRange> frames;
    std::optional<std::string> stats;  ///< A file, or "-" for standard output.
    candela::DeviceOptions device;
    bool quiet = false;
    std::optional<ListKind> list;
};

/// Reads the command line. Returns nothing when it asked for help or the version, which is printed then.
/// Throws `UsageError`.
std::optional<Options> parseOptions(int argc, const char* const* argv);
