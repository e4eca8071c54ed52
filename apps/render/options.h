#pragma once

#include "common/scene_options.h"

#include <candela/context.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

enum class ListKind {
    plugins,
    devices,
    displays,
    views,
    animations,
    cameras,
    materials,
    variants,
    environment,
    contents
};

/// Whether a list is of what the scene holds.
inline bool needsScene(ListKind kind) {
    return kind >= ListKind::animations;
}

enum class PictureFormat { png, exr };

/// The frames of --frames, in the order in which they are drawn.
class FrameList {
  public:
    /// "7", "0-47", "0-100x5" (every fifth), or several of these separated by commas. Throws `UsageError`.
    static FrameList parse(const std::string& text);

    std::uint64_t count() const { return count_; }
    /// The frame at `index` (below `count`) of the list.
    int operator[](std::uint64_t index) const;
    int front() const { return runs_.front().first; }
    int back() const { return (*this)[count_ - 1]; }

  private:
    struct Run {
        int first = 0, step = 1;
        std::uint64_t count = 1;
    };
    void add(const Run& run);

    std::vector<Run> runs_;
    std::uint64_t count_ = 0;
};

/// The file of a frame: the last run of # in the name of `output` becomes its number, which otherwise goes
/// before the ending.
std::filesystem::path framePath(const std::filesystem::path& output, int frame);

/// The command line, checked as far as it can be without a file or a device.
struct Options : SceneOptions {
    std::filesystem::path output = "candela.png";
    PictureFormat format = PictureFormat::png;
    std::vector<std::string> aovs;
    candela::AovFilter aovFilter = candela::AovFilter::automatic;
    candela::AmbientOcclusionSettings ambientOcclusion;
    std::optional<FrameList> frames;   ///< None: one picture, without a number.
    std::optional<std::string> stats;  ///< A file, or "-" for standard output.
    candela::DeviceOptions device;
    bool quiet = false;
    std::optional<ListKind> list;

    /// How many samples are drawn of a pixel and where; one of a debug view.
    candela::SamplingSettings samplingSettings() const;
};

/// Samples a pixel where the command line has none.
constexpr std::uint32_t defaultSamples = 16;

/// Reads the command line. Returns nothing when it asked for help or the version, which is printed then.
/// Throws `UsageError`.
std::optional<Options> parseOptions(int argc, const char* const* argv);
