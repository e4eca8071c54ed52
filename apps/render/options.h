#pragma once

#include "common/device_option.h"
#include "common/scene_options.h"

#include <candela/image_file.h>

#include <algorithm>
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

enum class PictureFormat {
    png,
    exr,
    rgba8,  ///< The bytes of a PNG without its file: rows from the top.
};

/// How pictures are encoded.
struct EncodingOptions {
    candela::PngOptions png;
    candela::ExrPixelType pixels = candela::ExrPixelType::float32;
    candela::ExrOptions exr;
    unsigned threads = 0;  ///< 0: as many as the process uses.
};

/// The part of all pictures that a process draws.
struct Shard {
    std::uint64_t index = 0;  ///< From 0, below `count`.
    std::uint64_t count = 1;
};

/// The frames of --frames, in the order in which they are drawn.
class FrameList {
  public:
    /// "7", "0-47", "0-100x5" (every fifth), or several of these separated by commas. Throws `UsageError`.
    static FrameList parse(const std::string& text);

    std::uint64_t count() const { return count_; }
    /// The frame at `index` (below `count`) of the list.
    int operator[](std::uint64_t index) const;
    /// The largest number.
    int max() const;
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
    std::filesystem::path output = "candela.png";  ///< "-" for standard output.
    PictureFormat format = PictureFormat::png;
    std::vector<std::string> aovs;
    candela::AovFilter aovFilter = candela::AovFilter::automatic;
    candela::AmbientOcclusionSettings ambientOcclusion;
    std::optional<FrameList> frames;   ///< None: one picture, without a number.
    std::optional<std::string> stats;  ///< A file, or "-" for standard output.
    EncodingOptions encoding;
    Shard shard;
    std::optional<int> turntable;  ///< Pictures of a whole turn.
    bool skipExisting = false;
    bool placeholders = false;  ///< Implies `skipExisting`.
    bool keepGoing = false;
    bool mkdir = false;
    bool panorama = false;
    std::optional<int> tile;  ///< The largest side of the frames of a picture that is drawn in parts.
    DeviceOption device;
    bool quiet = false;
    bool jsonProgress = false;
    std::optional<ListKind> list;

    /// Whether the names of pictures have the number of a frame.
    bool isSequence() const { return frames || turntable; }
    /// None where this process draws every picture.
    std::optional<std::uint64_t> shardIndex() const {
        return shard.count > 1 ? std::optional(shard.index) : std::nullopt;
    }
    /// The largest frames of a picture, that of a whole one included.
    struct FrameSize {
        int width = 0, height = 0;
    };
    FrameSize frameSize() const;
    bool isParted() const { return width > frameSize().width || height > frameSize().height; }
    /// How many samples are drawn of a pixel and where; one of a debug view.
    candela::SamplingSettings samplingSettings() const;
};

/// Samples a pixel where the command line has none.
constexpr std::uint32_t defaultSamples = 16;

/// Reads the command line. Returns nothing when it asked for help or the version, which is printed then.
/// Throws `UsageError`.
std::optional<Options> parseOptions(int argc, const char* const* argv);
