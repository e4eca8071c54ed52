#pragma once

#include <candela/brdf.h>
#include <candela/color.h>
#include <candela/context.h>
#include <candela/renderer.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

enum class ListKind { plugins, devices, displays, views };
enum class PictureFormat { png, exr };

/// Where the user puts the eye: metres, world space.
struct EyeChoice {
    glm::vec3 eye{0.0f}, target{0.0f};
};

/// Lights to strew over the scene; what is not given follows from their mean spacing.
struct ScatterChoice {
    std::uint32_t count = 0;
    std::optional<float> range;    ///< Metres, over 0.
    std::optional<float> candela;  ///< Over 0.
};

/// Frames `first` to `last`, both drawn.
struct FrameRange {
    int first = 0, last = 0;
};

/// The command line, checked as far as it can be without a file or a device.
struct Options {
    std::string scene;
    std::filesystem::path output = "candela.png";
    PictureFormat format = PictureFormat::png;
    int width = 1280, height = 720;  ///< Pixels.

    std::optional<std::string> camera;  ///< Name or index.
    std::optional<EyeChoice> eye;
    std::optional<float> verticalFov;  ///< Radians.

    std::optional<ScatterChoice> scatter;
    candela::BrdfModel brdf = candela::BrdfModel::course;
    candela::Technique technique = candela::Technique::automatic;

    std::optional<std::string> ocio;
    candela::DisplayChoice display;
    std::vector<std::string> aovs;

    std::optional<FrameRange> frames;
    double time = 0.0;  ///< Seconds.

    std::optional<std::string> stats;  ///< A file, or "-" for standard output.
    std::vector<std::filesystem::path> pluginFolders;
    candela::DeviceChoice device;
    bool quiet = false;
    std::optional<ListKind> list;
};

/// Reads the command line. Returns nothing when it asked for help or the version, which is printed then.
/// Throws `UsageError`.
std::optional<Options> parseOptions(int argc, const char* const* argv);
