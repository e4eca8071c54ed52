#pragma once

#include "import/file_access.h"
#include "import/note_list.h"

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

class ThreadPool;

/// Implements `candela_host` for one import. It checks and copies the elements that the plugin adds, and
/// keeps the first failure; from then on it refuses everything. No exception leaves the functions of
/// `interface()`.
class ImportHost {
  public:
    /// `files` is null for a procedural scene, which has no folder. Errors name `uri` as the file at fault.
    ImportHost(std::string uri, std::unique_ptr<FileAccess> files, ImportProgress progress);
    ImportHost(const ImportHost&) = delete;
    ImportHost& operator=(const ImportHost&) = delete;

    const candela_host& interface() const { return interface_; }

    /// Throws the first failure: an `Error` that names the URI, or what the caller's progress callback threw.
    /// Does nothing without a failure.
    void rethrowFailure() const;

    Scene takeScene() { return std::move(scene_); }
    NoteList takeNotes() { return std::move(notes_); }

  private:
    struct Functions;

    template <class Action>
    bool guarded(const char* what, Action action) noexcept;
    template <class Source, class Element, class Convert>
    std::int32_t add(const char* kind, const Source* source, std::vector<Element>& elements,
                     Convert convert) noexcept;

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
    std::deque<std::string> reasons_;  ///< Lent by `readOptionalFile`.
    std::exception_ptr failure_;
    std::shared_ptr<ThreadPool> pool_;
    candela_host interface_{};
};

}  // namespace candela
