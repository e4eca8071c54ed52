#pragma once

#include "common/count_text.h"
#include "view_model.h"

#include <candela/scene.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

/// What each node of a scene holds, such as "mesh", "camera" or "mesh, light"; empty for a group.
std::vector<std::string> kindsOfNodes(const candela::Scene& scene);

/// The materials of the mesh or cage of `node`, each once, in the order of first use.
std::vector<std::uint32_t> materialsOfNode(const candela::Scene& scene, std::uint32_t node);

/// Times of one pass, in milliseconds.
struct PassSummary {
    std::string name;
    std::optional<double> last;  ///< None where the last frame did not run it.
    double median = 0.0;         ///< Over the frames that ran it.
};

/// Times of the stored frames, in milliseconds.
struct FrameSummary {
    std::vector<PassSummary> passes;  ///< In the order of first occurrence.
    double last = 0.0, median = 0.0, max = 0.0;
};

/// None without a frame.
std::optional<FrameSummary> summarise(const std::deque<FrameRecord>& frames);

/// A round number that is not less than `value` (over 0): 1, 2 or 5 times a power of ten.
double roundedUp(double value);

/// Such as "512 B", "1.5 KiB", "20.0 MiB", "3.2 GiB".
std::string bytesText(std::uint64_t bytes);

/// Such as "material 3 brass"; "material 3" where there is no name.
std::string elementText(const char* kind, std::uint64_t index, const std::string& name);

/// `path` with `ending` (such as ".png") added, unless it has it.
std::string withEnding(const std::string& path, const std::string& ending);
