#include "picture_plan.h"

#include "common/parse.h"

#include <candela/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace {

constexpr std::string_view cameraMark = "{camera}";

/// The cameras that --camera names, by numbers that `findCamera` finds; empty without it.
std::vector<std::uint32_t> namedCameras(const candela::Scene& scene, const Options& options) {
    std::vector<std::uint32_t> cameras;
    if (!options.camera || options.eye) return cameras;
    if (const auto found = findCamera(scene, *options.camera)) return {*found};
    if (*options.camera == "all" && !scene.cameras.empty()) {
        for (std::uint32_t i = 0; i < scene.cameras.size(); ++i) cameras.push_back(i);
        return cameras;
    }
    for (const std::string& name : splitAtCommas(*options.camera)) {
        const auto found = findCamera(scene, name);
        if (!found)
            throw candela::Error(candela::ErrorKind::badInput, options.scene,
                                 "no camera \"" + name + "\"; " + listCameras(scene, name));
        if (std::ranges::find(cameras, *found) == cameras.end()) cameras.push_back(*found);
    }
    return cameras;
}

/// A name without what leads to another folder, stands for the frame's number or is not seen.
std::string fileName(std::string name) {
    for (char& c : name)
        if (c == '/' || c == '#' || static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '_';
    return name == "." || name == ".." ? "_" : name;
}

/// The box that holds `box` in every turn around its vertical axis.
candela::Bounds turnedBox(candela::Bounds box) {
    if (box.empty()) return box;
    const glm::vec3 center = 0.5f * (box.min + box.max);
    const float radius = std::hypot(box.max.x - center.x, box.max.z - center.z);
    box.min = {center.x - radius, box.min.y, center.z - radius};
    box.max = {center.x + radius, box.max.y, center.z + radius};
    return box;
}

std::vector<PlannedCamera> planCameras(const candela::Scene& scene, const Options& options) {
    const auto box = [&] {
        const candela::Bounds framed = framedBox(scene);
        return options.turntable ? turnedBox(framed) : framed;
    };
    std::vector<PlannedCamera> cameras;
    std::set<std::string> names;
    for (const std::uint32_t camera : namedCameras(scene, options)) {
        std::string name = fileName(cameraName(scene, camera));
        if (!names.insert(name).second) name += "-" + std::to_string(camera);
        cameras.push_back({name, CameraSelection(scene, options, camera)});
    }
    if (!cameras.empty()) return cameras;
    const bool ownCamera = !options.eye && !scene.cameras.empty();
    cameras.push_back(
        {ownCamera ? fileName(cameraName(scene, 0)) : "view", CameraSelection(scene, options, box)});
    return cameras;
}

}  // namespace

PicturePlan::PicturePlan(const candela::Scene& scene, const Options& options)
    : options_(options), cameras_(planCameras(scene, options)) {
    if (options.turntable) {
        const candela::Bounds box = framedBox(scene);
        if (!box.empty()) center_ = 0.5f * (box.min + box.max);
        frames_ = *options.turntable;
    }
    if (options.frames) frames_ = options.frames->count();
    const std::uint64_t all = frames_ * cameras_.size();
    const Shard& shard = options.shard;
    count_ = all / shard.count + (shard.index < all % shard.count ? 1 : 0);
}

int PicturePlan::frameAt(std::uint64_t index) const {
    if (options_.frames) return (*options_.frames)[index];
    return static_cast<int>(index);
}

PlannedPicture PicturePlan::operator[](std::uint64_t index) const {
    const std::uint64_t picture = options_.shard.index + index * options_.shard.count;
    PlannedPicture planned{index, frameAt(picture / cameras_.size()), picture % cameras_.size(), {}};
    if (options_.output == "-") return planned;
    planned.path = cameraPath(options_.output, cameras_[planned.camera].name, cameras_.size() > 1);
    if (options_.isSequence()) planned.path = framePath(planned.path, planned.frame);
    return planned;
}

double PicturePlan::timeOf(int frame) const {
    if (!options_.frames || options_.turntable) return options_.time;
    return options_.time + frame / options_.sampling.framesPerSecond;
}

candela::CameraView PicturePlan::view(const PlannedPicture& picture, double time) const {
    candela::CameraView view = cameras_[picture.camera].selection.at(time);
    if (!options_.turntable) return view;
    const double angle = 2.0 * std::numbers::pi * picture.frame / *options_.turntable;
    glm::mat4 turn = glm::translate(glm::mat4(1.0f), center_);
    turn = glm::rotate(turn, static_cast<float>(angle), glm::vec3(0.0f, 1.0f, 0.0f));
    turn = glm::translate(turn, -center_);
    view.worldFromCamera = turn * view.worldFromCamera;
    return view;
}

std::filesystem::path cameraPath(const std::filesystem::path& output, const std::string& camera,
                                 bool several) {
    std::string text = output.string();
    bool named = false;
    for (std::size_t mark = text.find(cameraMark); mark != text.npos; mark = text.find(cameraMark, mark)) {
        text.replace(mark, cameraMark.size(), camera);
        mark += camera.size();
        named = true;
    }
    if (named || !several) return text;
    std::filesystem::path path = output;
    return path.replace_extension("." + camera + output.extension().string());
}
