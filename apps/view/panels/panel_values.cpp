#include "panels/panel_values.h"

#include "common/timing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace {

void add(std::string& words, const char* word) {
    words += (words.empty() ? "" : ", ") + std::string(word);
}

class MaterialList {
  public:
    explicit MaterialList(std::size_t count) : used_(count, false) {}

    void add(const std::optional<std::uint32_t>& material) {
        if (!material || used_[*material]) return;
        used_[*material] = true;
        list_.push_back(*material);
    }
    std::vector<std::uint32_t> take() { return std::move(list_); }

  private:
    std::vector<bool> used_;
    std::vector<std::uint32_t> list_;
};

std::vector<std::string> namesOfPasses(const std::deque<FrameRecord>& frames) {
    std::vector<std::string> names;
    for (const FrameRecord& frame : frames)
        for (const candela::PassTime& pass : frame.passes)
            if (std::ranges::find(names, pass.name) == names.end()) names.push_back(pass.name);
    return names;
}

/// The sum of all runs of a pass in a frame.
std::optional<double> timeOf(const FrameRecord& frame, const std::string& pass) {
    std::optional<double> sum;
    for (const candela::PassTime& one : frame.passes)
        if (one.name == pass) sum = sum.value_or(0.0) + one.milliseconds;
    return sum;
}

PassSummary summaryOf(const std::string& pass, const std::deque<FrameRecord>& frames) {
    std::vector<double> times;
    for (const FrameRecord& frame : frames)
        if (const auto time = timeOf(frame, pass)) times.push_back(*time);
    return {pass, timeOf(frames.back(), pass), median(times)};
}

}  // namespace

std::vector<std::string> kindsOfNodes(const candela::Scene& scene) {
    std::vector<std::string> kinds(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].mesh) add(kinds[i], "mesh");
        if (scene.nodes[i].cage) add(kinds[i], "cage");
    }
    for (const candela::Light& light : scene.lights)
        if (light.node && !kinds[*light.node].ends_with("light")) add(kinds[*light.node], "light");
    for (const candela::Camera& camera : scene.cameras)
        if (camera.node && !kinds[*camera.node].ends_with("camera")) add(kinds[*camera.node], "camera");
    return kinds;
}

std::vector<std::uint32_t> materialsOfNode(const candela::Scene& scene, std::uint32_t node) {
    MaterialList list(scene.materials.size());
    const candela::Node& shown = scene.nodes[node];
    if (shown.mesh)
        for (const candela::Submesh& submesh : scene.meshes[*shown.mesh].submeshes)
            list.add(submesh.material);
    if (shown.cage)
        for (const auto& material : scene.cages[*shown.cage].faceMaterials) list.add(material);
    return list.take();
}

std::optional<FrameSummary> summarise(const std::deque<FrameRecord>& frames) {
    if (frames.empty()) return std::nullopt;
    FrameSummary summary;
    for (const std::string& pass : namesOfPasses(frames)) summary.passes.push_back(summaryOf(pass, frames));
    std::vector<double> times;
    for (const FrameRecord& frame : frames) times.push_back(frame.milliseconds);
    summary.last = times.back();
    summary.max = std::ranges::max(times);
    summary.median = median(std::move(times));
    return summary;
}

double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= value) return factor * power;
    return 10.0 * power;
}

std::string bytesText(std::uint64_t bytes) {
    if (bytes < 1024) return std::to_string(bytes) + " B";
    constexpr std::array units{"KiB", "MiB", "GiB", "TiB"};
    double size = static_cast<double>(bytes) / 1024.0;
    std::size_t unit = 0;
    for (; size >= 1024.0 && unit + 1 < units.size(); ++unit) size /= 1024.0;
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.1f %s", size, units[unit]);
    return text.data();
}

std::string elementText(const char* kind, std::uint64_t index, const std::string& name) {
    return std::string(kind) + " " + std::to_string(index) + (name.empty() ? "" : " " + name);
}

std::string withEnding(const std::string& path, const std::string& ending) {
    return path.ends_with(ending) ? path : path + ending;
}
