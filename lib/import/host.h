#pragma once

#include "import/file_access.h"
#include "import/note_list.h"
#include "import/plugin_frames.h"

#include <candela/import.h>
#include <candela/plugin.h>
#include <candela/scene.h>

#include <deque>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace candela {

class AbiReader;
class ThreadPool;

/// The exception in flight as the caller gets it: an `Error` with the URI. `what` is what was done.
std::exception_ptr currentFailure(const std::string& uri, const char* what) noexcept;

/// Implements `candela_host` for one import. It checks and copies the elements that the plugin adds, and
/// keeps the first failure; from then on it refuses everything. No exception leaves the functions of
/// `interface()`.
class ImportHost {
  public:
    /// `files` is null for a procedural scene, which has no folder. Errors name `uri` as the file at fault.
    /// `imageDecoders` are plugins with an image decoder, in the order in which they are asked.
    ImportHost(std::string uri, std::unique_ptr<FileAccess> files, ImportProgress progress,
               std::vector<const candela_plugin*> imageDecoders = {});
    ImportHost(const ImportHost&) = delete;
    ImportHost& operator=(const ImportHost&) = delete;

    const candela_host& interface() const { return interface_; }

    /// Throws the first failure: an `Error` that names the URI, or what the caller's progress callback threw.
    /// Does nothing without a failure.
    void rethrowFailure() const;

    Scene takeScene() { return std::move(scene_); }
    const SceneInfo& sceneInfo() const { return info_; }
    NoteList takeNotes() { return std::move(notes_); }
    /// The access to the folder, without the files that were read.
    std::unique_ptr<FileAccess> takeFiles() {
        if (files_) files_->forget();
        return std::move(files_);
    }
    /// Null where the plugin has set none.
    std::unique_ptr<OwnedFrameCallback> takeFrameCallback() { return std::move(frameCallback_); }
    /// The meshes and cages that it may move, in ascending order.
    const std::vector<AddedMovedMesh>& movedMeshes() const { return movedMeshes_; }
    std::vector<MovedCage> takeMovedCages() { return std::move(movedCages_); }

  private:
    struct Functions;

    /// Runs an action of the plugin. After the first failure it runs none.
    template <class Action>
    bool guarded(const char* what, Action action) noexcept {
        if (failure_) return false;
        try {
            action();
            return true;
        } catch (...) {
            record(currentFailure(uri_, what));
            return false;
        }
    }
    template <class Source, class Element, class Convert>
    std::int32_t add(const char* kind, const Source* source, std::vector<Element>& elements,
                     Convert convert) noexcept;

    template <class Source, class Element, class Convert>
    std::int32_t addAll(const char* kind, const Source* sources, std::uint32_t count,
                        std::vector<Element>& elements, Convert convert) noexcept;

    candela_status addImageBytes(const candela_image_bytes* images, std::uint32_t count,
                                 std::int32_t* indices, const char** reasons) noexcept;
    candela_status setSceneInfo(const candela_scene_info* info) noexcept;
    candela_status setFrameCallback(const candela_frame_callback* callback) noexcept;
    Mesh takeMesh(const candela_mesh& source, const AbiReader& element);
    Cage takeCage(const candela_cage& source, const AbiReader& element);
    FileAccess& files(const char* path);
    candela_status fileSize(const char* path, std::uint64_t* size) noexcept;
    candela_status readFilePart(const char* path, std::uint64_t offset, std::uint64_t size,
                                void* into) noexcept;
    candela_status addCageInstance(const candela_cage_instance* instance) noexcept;
    candela_bytes fileBytes(const char* path);
    candela_status addDeformation(const candela_deformation* deformation) noexcept;
    std::int32_t addVariant(const char* name) noexcept;
    candela_status setEnvironment(const candela_environment* environment) noexcept;
    candela_status readFile(const char* path, candela_bytes* out) noexcept;
    candela_status readOptionalFile(const char* path, candela_bytes* out, const char** reason) noexcept;
    bool continues(double fraction) noexcept;
    candela_status progress(double fraction) noexcept;
    void fail(const char* element, const char* reason) noexcept;
    void addNote(candela_note_kind kind, const char* element, const char* text) noexcept;
    void record(std::exception_ptr failure) noexcept;

    std::string uri_;
    std::unique_ptr<FileAccess> files_;
    ImportProgress progress_;
    Scene scene_;
    NoteList notes_;
    std::deque<std::string> reasons_;  ///< Lent by `readOptionalFile` and `addImageBytes`.
    SceneInfo info_;
    bool hasInfo_ = false;
    std::vector<const candela_plugin*> imageDecoders_;
    std::unique_ptr<OwnedFrameCallback> frameCallback_;
    std::vector<AddedMovedMesh> movedMeshes_;
    std::vector<MovedCage> movedCages_;
    std::exception_ptr failure_;
    std::shared_ptr<ThreadPool> pool_;
    candela_host interface_{};
};

}  // namespace candela
