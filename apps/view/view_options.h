#pragma once

#include "common/scene_options.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

enum class StoredSettings { use, reset };

/// Samples a pixel of a view at rest, where the command line has none.
constexpr std::uint32_t defaultViewSamples = 64;

/// The command line of candela-view.
struct ViewOptions : SceneOptions {
    /// Were these given? What was not comes from the stored settings.
    bool sizeGiven = false, displayGiven = false, exposureGiven = false, drawingGiven = false,
         subdivisionGiven = false;
    std::optional<std::uint32_t> frames;              ///< End after so many.
    std::optional<std::filesystem::path> screenshot;  ///< Write the picture here at the end: PNG or EXR.
    std::optional<std::filesystem::path> windowScreenshot;  ///< And the whole window, as PNG.
    StoredSettings settings = StoredSettings::use;

    /// A scripted run ends by itself, and neither reads nor writes stored settings.
    bool scripted() const { return frames || screenshot || windowScreenshot; }
};

/// The ending of a file's name in small letters, such as ".png".
std::string endingOf(const std::filesystem::path& file);

/// None when the user asked for help or the version, which has been printed. Throws `UsageError`.
std::optional<ViewOptions> parseViewOptions(int argc, const char* const* argv);
