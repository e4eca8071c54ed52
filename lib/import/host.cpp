#include "import/host.h"

#include "base/thread_pool.h"
#include "import/abi_import.h"
#include "import/plugin_abi.h"
#include "import/text.h"

#include <candela/error.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

namespace candela {
namespace {

std::string textOr(const char* text, const char* otherwise) {
    return text && *text ? oneLine(text) : std::string(otherwise);
}

// The exception in flight as the caller gets it: an `Error` with the URI.
std::exception_ptr currentFailure(const std::string& uri, const char* what) noexcept {
    try {
        try {
            throw;
        } catch (const Error& error) {
            if (!error.path().empty()) throw;
            throw Error(error.kind(), uri, error.what());
        } catch (const std::bad_alloc&) {
            throw Error(ErrorKind::limit, uri, joined(what, ": there is not enough memory"));
        } catch (const std::length_error&) {
            throw Error(ErrorKind::limit, uri, joined(what, ": there is not enough memory"));
        } catch (const std::exception& error) {
            throw Error(ErrorKind::environment, uri, joined(what, ": ", oneLine(error.what())));
        }
    } catch (...) {
        return std::current_exception();
    }
}

}  // namespace

void ImportHost::rethrowFailure() const {
    if (failure_) std::rethrow_exception(failure_);
}

void ImportHost::record(std::exception_ptr failure) noexcept {
    if (!failure_) failure_ = std::move(failure);
}

// Runs an action of the plugin. After the first failure it runs none.
template <class Action>
bool ImportHost::guarded(const char* what, Action action) noexcept {
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
std::int32_t ImportHost::add(const char* kind, const Source* source, std::vector<Element>& elements,
                             Convert convert) noexcept {
    const std::size_t index = elements.size();
    const bool added = guarded(kind, [&] {
        if (index >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
            throw Error(ErrorKind::limit, uri_,
                        joined("there are more than ", index, " elements of the kind ", kind));
        if (!source) AbiReader(kind, index, nullptr).refuse("the struct is NULL");
        const auto copy = copyOf(source);
        if (!copy) AbiReader(kind, index, nullptr).refuse("struct_size " + sizeFault(source));
        elements.push_back(convert(*copy, AbiReader(kind, index, copy->name)));
    });
    return added ? static_cast<std::int32_t>(index) : -1;
}

candela_status ImportHost::addCageInstance(const candela_cage_instance* instance) noexcept {
    const bool done = guarded("a cage instance", [&] {
        const AbiReader call("add_cage_instance", std::nullopt, nullptr);
        if (!instance) call.refuse("the struct is NULL");
        const auto copy = copyOf(instance);
        if (!copy) call.refuse("struct_size " + sizeFault(instance));
        candela::addCageInstance(*copy, scene_);
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_status ImportHost::addDeformation(const candela_deformation* deformation) noexcept {
    const bool done = guarded("a deformation", [&] {
        const AbiReader call("add_deformation", std::nullopt, nullptr);
        if (!deformation) call.refuse("the struct is NULL");
        const auto copy = copyOf(deformation);
        if (!copy) call.refuse("struct_size " + sizeFault(deformation));
        candela::addDeformation(*copy, scene_);
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_status ImportHost::setEnvironment(const candela_environment* environment) noexcept {
    const bool done = guarded("an environment", [&] {
        const AbiReader call("set_environment", std::nullopt, nullptr);
        if (!environment) call.refuse("the struct is NULL");
        const auto copy = copyOf(environment);
        if (!copy) call.refuse("struct_size " + sizeFault(environment));
        if (scene_.environment) call.refuse("the scene has an environment already");
        scene_.environment = environmentFrom(*copy, AbiReader("environment", std::nullopt, copy->name));
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

std::int32_t ImportHost::addVariant(const char* name) noexcept {
    const std::size_t index = scene_.variants.size();
    const bool added = guarded("variant", [&] {
        if (index >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
            throw Error(ErrorKind::limit, uri_, joined("there are more than ", index, " variants"));
        scene_.variants.push_back(validUtf8(name));
    });
    return added ? static_cast<std::int32_t>(index) : -1;
}

candela_bytes ImportHost::fileBytes(const char* path) {
    if (!files_)
        throw Error(
            ErrorKind::badInput, "",
            joined("file '", oneLine(path), "': a procedural scene has no folder to read files from"));
    const auto bytes = files_->read(path);
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

candela_status ImportHost::readFile(const char* path, candela_bytes* out) noexcept {
    const bool done = guarded("reading a file", [&] {
        if (!path || !out)
            throw Error(ErrorKind::badInput, uri_, "read_file: its path or its result is NULL");
        *out = {};
        *out = fileBytes(path);
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_status ImportHost::readOptionalFile(const char* path, candela_bytes* out,
                                            const char** reason) noexcept {
    if (reason) *reason = "";
    bool read = false;
    guarded("reading a file", [&] {
        if (!path || !out || !reason)
            throw Error(ErrorKind::badInput, uri_,
                        "read_optional_file: its path, its result or its reason is NULL");
        *out = {};
        try {
            const std::string name = files_ ? files_->inAnyCase(path) : path;
            *out = fileBytes(name.c_str());
            read = true;
            if (name != path)
                notes_.add(NoteKind::information, joined("file '", oneLine(path), "'"),
                           "read, though its name differs in upper and lower case");
        } catch (const Error& error) {
            *reason = reasons_.emplace_back(error.what()).c_str();
        }
    });
    return read ? CANDELA_OK : CANDELA_FAILED;
}

// False: cancelled. What the caller's own callback throws reaches the caller unchanged.
bool ImportHost::continues(double fraction) noexcept {
    try {
        return !progress_ || progress_(fraction);
    } catch (...) {
        record(std::current_exception());
        return false;
    }
}

candela_status ImportHost::progress(double fraction) noexcept {
    const bool proceed = guarded("the progress of the import", [&] {
        if (!(fraction >= 0.0 && fraction <= 1.0))
            throw Error(ErrorKind::badInput, uri_,
                        joined("progress: ", fraction, " was reported, but 0 to 1 was expected"));
        if (!continues(fraction)) throw Error(ErrorKind::cancelled, uri_, "the import was cancelled");
    });
    return proceed ? CANDELA_OK : CANDELA_FAILED;
}

void ImportHost::fail(const char* element, const char* reason) noexcept {
    guarded("a failed import", [&] {
        const std::string at = element && *element ? oneLine(element) + ": " : std::string();
        throw Error(ErrorKind::badInput, uri_, at + textOr(reason, "the plugin gives no reason"));
    });
}

void ImportHost::addNote(candela_note_kind kind, const char* element, const char* text) noexcept {
    constexpr std::array kinds{NoteKind::missing, NoteKind::repaired, NoteKind::information};
    guarded("a note", [&] {
        const AbiReader call("add_note", std::nullopt, nullptr);
        notes_.add(kinds[call.enumerator("kind", kind, kinds.size())], textOr(element, ""),
                   textOr(text, "(an empty note)"));
    });
}

// The C functions of the interface. `self` is the object.
struct ImportHost::Functions {
    static ImportHost& from(void* self) { return *static_cast<ImportHost*>(self); }

    // A conversion that checks its indices against the elements added so far.
    template <class Element, class Source>
    static auto inScene(void* self, Element (*convert)(const Source&, const AbiReader&, const Scene&)) {
        return [self, convert](const Source& source, const AbiReader& element) {
            return convert(source, element, from(self).scene_);
        };
    }

    static candela_status readFile(void* self, const char* path, candela_bytes* out) {
        return from(self).readFile(path, out);
    }
    static candela_status readOptionalFile(void* self, const char* path, candela_bytes* out,
                                           const char** reason) {
        return from(self).readOptionalFile(path, out, reason);
    }
    static void fail(void* self, const char* element, const char* reason) {
        from(self).fail(element, reason);
    }
    static void note(void* self, const char* text) {
        from(self).addNote(CANDELA_NOTE_MISSING, nullptr, text);
    }
    static void addNote(void* self, candela_note_kind kind, const char* element, const char* text) {
        from(self).addNote(kind, element, text);
    }
    static candela_status progress(void* self, double fraction) { return from(self).progress(fraction); }

    static std::int32_t addImage(void* self, const candela_image* image) {
        return from(self).add("image", image, from(self).scene_.images, imageFrom);
    }
    static std::int32_t addMaterial(void* self, const candela_material* material) {
        return from(self).add("material", material, from(self).scene_.materials, inScene(self, materialFrom));
    }
    static std::int32_t addMesh(void* self, const candela_mesh* mesh) {
        const auto convert = [&](const candela_mesh& source, const AbiReader& element) {
            return meshFrom(source, element, from(self).scene_, from(self).notes_);
        };
        return from(self).add("mesh", mesh, from(self).scene_.meshes, convert);
    }
    static std::int32_t addNode(void* self, const candela_node* node) {
        return from(self).add("node", node, from(self).scene_.nodes, inScene(self, nodeFrom));
    }
    static std::int32_t addCamera(void* self, const candela_camera* camera) {
        return from(self).add("camera", camera, from(self).scene_.cameras, inScene(self, cameraFrom));
    }
    static std::int32_t addLight(void* self, const candela_light* light) {
        return from(self).add("light", light, from(self).scene_.lights, inScene(self, lightFrom));
    }
    static std::int32_t addAnimation(void* self, const candela_animation* animation) {
        return from(self).add("animation", animation, from(self).scene_.animations,
                              inScene(self, animationFrom));
    }

    static std::int32_t addCage(void* self, const candela_cage* cage) {
        return from(self).add("cage", cage, from(self).scene_.cages, inScene(self, cageFrom));
    }
    static std::int32_t addSkin(void* self, const candela_skin* skin) {
        return from(self).add("skin", skin, from(self).scene_.skins, inScene(self, skinFrom));
    }
    static candela_status addCageInstance(void* self, const candela_cage_instance* instance) {
        return from(self).addCageInstance(instance);
    }

    static candela_status addDeformation(void* self, const candela_deformation* deformation) {
        return from(self).addDeformation(deformation);
    }

    static candela_status setEnvironment(void* self, const candela_environment* environment) {
        return from(self).setEnvironment(environment);
    }

    static std::int32_t addVariant(void* self, const char* name) { return from(self).addVariant(name); }

    static void parallelFor(void* self, std::uint32_t count, candela_parallel_body body, void* context) {
        runParallelLoop(*from(self).pool_, count, body, context);
    }

    static candela_host table(ImportHost* self) {
        candela_host host{};
        host.struct_size = sizeof host;
        host.self = self;
        host.read_file = readFile;
        host.fail = fail;
        host.note = note;
        host.progress = progress;
        host.add_image = addImage;
        host.add_material = addMaterial;
        host.add_mesh = addMesh;
        host.add_node = addNode;
        host.add_camera = addCamera;
        host.add_light = addLight;
        host.add_animation = addAnimation;
        host.add_cage = addCage;
        host.add_skin = addSkin;
        host.add_cage_instance = addCageInstance;
        host.worker_count = self->pool_->size();
        host.parallel_for = parallelFor;
        host.add_note = addNote;
        host.read_optional_file = readOptionalFile;
        host.add_deformation = addDeformation;
        host.set_environment = setEnvironment;
        host.add_variant = addVariant;
        return host;
    }
};

ImportHost::ImportHost(std::string uri, std::unique_ptr<FileAccess> files, ImportProgress progress)
    : uri_(std::move(uri)),
      files_(std::move(files)),
      progress_(std::move(progress)),
      pool_(ThreadPool::shared()) {
    interface_ = Functions::table(this);
}

}  // namespace candela
