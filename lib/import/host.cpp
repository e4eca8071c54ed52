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

}  // namespace

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

void ImportHost::rethrowFailure() const {
    if (failure_) std::rethrow_exception(failure_);
}

void ImportHost::record(std::exception_ptr failure) noexcept {
    if (!failure_) failure_ = std::move(failure);
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

// The elements of an array, whose distance is the size that their sender's struct has.
template <class Source, class Element, class Convert>
std::int32_t ImportHost::addAll(const char* kind, const Source* sources, std::uint32_t count,
                                std::vector<Element>& elements, Convert convert) noexcept {
    const std::size_t first = elements.size();
    const bool ready = guarded(kind, [&] {
        if (count > 0 && !sources) AbiReader(kind, first, nullptr).refuse("the array is NULL");
        elements.reserve(first + count);
    });
    if (!ready) return -1;
    const std::uint32_t size = count > 0 ? structSizeOf(sources) : 0;
    const auto* bytes = reinterpret_cast<const std::byte*>(sources);
    for (std::size_t i = 0; i < count; ++i) {
        const auto* source = reinterpret_cast<const Source*>(bytes + i * size);
        const bool same = guarded(kind, [&] {
            if (structSizeOf(source) != size)
                AbiReader(kind, first + i, nullptr)
                    .refuse(
                        joined("struct_size is ", structSizeOf(source), ", but that of the array is ", size));
        });
        if (!same || add(kind, source, elements, convert) < 0) return -1;
    }
    return static_cast<std::int32_t>(first);
}

candela_status ImportHost::setSceneInfo(const candela_scene_info* info) noexcept {
    const bool done = guarded("the scene's info", [&] {
        const AbiReader call("set_scene_info", std::nullopt, nullptr);
        if (!info) call.refuse("the struct is NULL");
        const auto copy = copyOf(info);
        if (!copy) call.refuse("struct_size " + sizeFault(info));
        if (hasInfo_) call.refuse("it has been called before");
        info_ = sceneInfoFrom(*copy, call);
        hasInfo_ = true;
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_status ImportHost::setFrameCallback(const candela_frame_callback* callback) noexcept {
    const bool done = guarded("a frame callback", [&] {
        if (frameCallback_)
            AbiReader("set_frame_callback", std::nullopt, nullptr).refuse("it has been called before");
        frameCallback_ = std::make_unique<OwnedFrameCallback>(frameCallbackFrom(callback));
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

Mesh ImportHost::takeMesh(const candela_mesh& source, const AbiReader& element) {
    Mesh mesh = meshFrom(source, element, scene_, notes_);
    if (source.is_moved != 0) {
        const bool isFlat = !source.normals && !(source.crease_angle > 0.0f);
        movedMeshes_.push_back({static_cast<std::uint32_t>(scene_.meshes.size()), source.vertex_count,
                                isFlat ? MovedNormals::Vertices::separate : MovedNormals::Vertices::welded});
    }
    return mesh;
}

Cage ImportHost::takeCage(const candela_cage& source, const AbiReader& element) {
    Cage cage = cageFrom(source, element, scene_);
    if (source.is_moved != 0)
        movedCages_.push_back({static_cast<std::uint32_t>(scene_.cages.size()), cage.positions});
    return cage;
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
            return from(self).takeMesh(source, element);
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
        const auto convert = [&](const candela_cage& source, const AbiReader& element) {
            return from(self).takeCage(source, element);
        };
        return from(self).add("cage", cage, from(self).scene_.cages, convert);
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

    static std::int32_t addNodes(void* self, const candela_node* nodes, std::uint32_t count) {
        return from(self).addAll("node", nodes, count, from(self).scene_.nodes, inScene(self, nodeFrom));
    }
    static std::int32_t addLights(void* self, const candela_light* lights, std::uint32_t count) {
        return from(self).addAll("light", lights, count, from(self).scene_.lights, inScene(self, lightFrom));
    }
    static candela_status addImageBytes(void* self, const candela_image_bytes* images, std::uint32_t count,
                                        std::int32_t* indices, const char** reasons) {
        return from(self).addImageBytes(images, count, indices, reasons);
    }
    static candela_status setSceneInfo(void* self, const candela_scene_info* info) {
        return from(self).setSceneInfo(info);
    }
    static candela_status setFrameCallback(void* self, const candela_frame_callback* callback) {
        return from(self).setFrameCallback(callback);
    }
    static candela_status fileSize(void* self, const char* path, std::uint64_t* size) {
        return from(self).fileSize(path, size);
    }
    static candela_status readFilePart(void* self, const char* path, std::uint64_t offset, std::uint64_t size,
                                       void* into) {
        return from(self).readFilePart(path, offset, size, into);
    }

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
        host.add_nodes = addNodes;
        host.add_lights = addLights;
        host.add_image_bytes = addImageBytes;
        host.set_scene_info = setSceneInfo;
        host.file_size = fileSize;
        host.read_file_part = readFilePart;
        host.set_frame_callback = setFrameCallback;
        return host;
    }
};

ImportHost::ImportHost(std::string uri, std::unique_ptr<FileAccess> files, ImportProgress progress,
                       std::vector<const candela_plugin*> imageDecoders)
    : uri_(std::move(uri)),
      files_(std::move(files)),
      progress_(std::move(progress)),
      imageDecoders_(std::move(imageDecoders)),
      pool_(ThreadPool::shared()) {
    interface_ = Functions::table(this);
}

}  // namespace candela
