#pragma once

#include "options.h"

#include "common/scene_selection.h"

#include <candela/camera.h>
#include <candela/scene.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A picture of a run.
struct PlannedPicture {
    std::uint64_t index = 0;     ///< Among those of this process, from 0.
    int frame = 0;               ///< 0 of a single picture.
    std::size_t camera = 0;      ///< Index into `PicturePlan::cameras`.
    std::filesystem::path path;  ///< Empty: standard output.

    /// As messages name it.
    std::string name() const { return path.empty() ? "standard output" : path.string(); }
};

/// A camera that pictures are drawn from.
struct PlannedCamera {
    std::string name;  ///< As in file names: "view" where the scene's cameras are not used.
    CameraSelection selection;
};

/// The pictures that this process draws: every frame from every camera, or its shard of them. Picture i of
/// all belongs to shard i modulo their number.
class PicturePlan {
  public:
    /// Both have to outlive it. Throws `candela::Error` that names the scene where it lacks a camera.
    PicturePlan(const candela::Scene& scene, const Options& options);

    std::uint64_t count() const { return count_; }
    /// The picture at `index`, below `count`.
    PlannedPicture operator[](std::uint64_t index) const;
    const std::vector<PlannedCamera>& cameras() const { return cameras_; }
    /// The time of a frame in seconds, before animations repeat.
    double timeOf(int frame) const;
    /// The view of a picture at `time`, with the turn of its frame on a turntable.
    candela::CameraView view(const PlannedPicture& picture, double time) const;

  private:
    int frameAt(std::uint64_t index) const;

    const Options& options_;
    std::vector<PlannedCamera> cameras_;
    glm::vec3 center_{0.0f};  ///< That a turntable turns around.
    std::uint64_t frames_ = 1, count_ = 1;
};

/// The file of a picture: "{camera}" in `output` becomes the name of the camera, which goes before the ending
/// where there are `several` and the name has no place for it. Then as `framePath`.
std::filesystem::path cameraPath(const std::filesystem::path& output, const std::string& camera,
                                 bool several);
