#include "import/plugin_frames.h"

#include "base/thread_pool.h"
#include "import/abi_reader.h"
#include "import/host.h"
#include "import/plugin_abi.h"
#include "scene/model/animated_properties.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

namespace candela {

OwnedFrameCallback::~OwnedFrameCallback() {
    if (callback_.destroy) callback_.destroy(callback_.user);
}

candela_frame_callback frameCallbackFrom(const candela_frame_callback* source) {
    const AbiReader call("set_frame_callback", std::nullopt, nullptr);
    if (!source) call.refuse("the struct is NULL");
    const auto copy = copyOf(source);
    if (!copy) call.refuse("struct_size " + sizeFault(source));
    if (!copy->update) call.refuse("update is NULL");
    const bool isSpan = std::isfinite(copy->first_second) && std::isfinite(copy->last_second) &&
                        copy->first_second <= copy->last_second;
    if (!isSpan)
        call.refuse(joined("first_second is ", copy->first_second, " and last_second is ", copy->last_second,
                           ", but finite numbers were expected, the last one not less than the first"));
    return *copy;
}

namespace {

Scene withoutVertices(const Scene& scene) {
    Scene parts;
    parts.nodes = scene.nodes;
    parts.materials = scene.materials;
    parts.lights = scene.lights;
    parts.cameras = scene.cameras;
    parts.origin = scene.origin;
    for (const Mesh& mesh : scene.meshes) parts.meshes.push_back({.name = mesh.name});
    for (const Cage& cage : scene.cages) parts.cages.push_back({.name = cage.name});
    return parts;
}

template <typename Moved, typename Index>
const Moved* find(const std::vector<Moved>& list, Index index, std::uint32_t value) {
    const auto found = std::ranges::lower_bound(list, value, {}, index);
    return found != list.end() && std::invoke(index, *found) == value ? &*found : nullptr;
}

template <typename Element>
std::uint32_t indexOf(const AbiReader& call, const char* member, std::int32_t index,
                      const std::vector<Element>& elements) {
    if (index < 0 || static_cast<std::size_t>(index) >= elements.size())
        call.refuse(joined(member, " is ", index, ", but the scene has ", elements.size()));
    return static_cast<std::uint32_t>(index);
}

}  // namespace

/// One call of the plugin: implements `candela_frame`. It keeps the first failure, and from then on refuses
/// everything. No exception leaves the functions of the interface.
class PluginFrameCallback::Call {
  public:
    Call(const PluginFrameCallback& callback, double seconds)
        : callback_(callback), seconds_(seconds), pool_(ThreadPool::shared()) {}
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    SceneUpdate run();

  private:
    static Call& from(void* self) { return *static_cast<Call*>(self); }
    candela_frame interface();
    void callPlugin();
    SceneUpdate takeUpdate();

    template <typename Action>
    candela_status guarded(const char* what, Action action) noexcept {
        if (failure_) return CANDELA_FAILED;
        try {
            action();
            return CANDELA_OK;
        } catch (...) {
            failure_ = currentFailure("", what);
            return CANDELA_FAILED;
        }
    }
    void setVertices(std::int32_t mesh, std::uint32_t count, const float* positions, const float* normals);
    void setCageVertices(std::int32_t cage, std::uint32_t count, const float* positions);
    void setTransform(std::int32_t node, const double* matrix);
    void setProperty(const candela_animated_property& property, std::int32_t element, std::uint32_t part,
                     std::uint32_t count, const float* numbers);
    std::uint32_t elementFrom(const AbiReader& call, AnimatedProperty property, std::int32_t element) const;
    FileAccess& files(const char* path) const;
    static void requireCount(const AbiReader& element, std::uint32_t count, std::size_t expected);
    static std::vector<glm::vec3> positionsFrom(const AbiReader& element, const float* from,
                                                std::uint32_t count);

    const PluginFrameCallback& callback_;
    double seconds_;
    std::shared_ptr<ThreadPool> pool_;
    std::map<std::uint32_t, SceneUpdate::MeshVertices> meshes_;
    std::map<std::uint32_t, SceneUpdate::CageVertices> cages_;
    std::map<std::uint32_t, glm::dmat4> nodes_;
    std::vector<PropertyChannel> properties_;
    std::exception_ptr failure_;
};

candela_frame PluginFrameCallback::Call::interface() {
    candela_frame frame{};
    frame.struct_size = sizeof frame;
    frame.worker_count = pool_->size();
    frame.self = this;
    frame.seconds = seconds_;
    frame.fail = [](void* self, const char* element, const char* reason) {
        from(self).guarded("a failed frame", [&] {
            const std::string at = element && *element ? oneLine(element) + ": " : std::string();
            throw Error(ErrorKind::badInput, "",
                        at + (reason && *reason ? oneLine(reason) : "the plugin gives no reason"));
        });
    };
    frame.set_vertices = [](void* self, std::int32_t mesh, std::uint32_t count, const float* positions,
                            const float* normals) {
        return from(self).guarded("set_vertices",
                                  [&] { from(self).setVertices(mesh, count, positions, normals); });
    };
    frame.set_cage_vertices = [](void* self, std::int32_t cage, std::uint32_t count, const float* positions) {
        return from(self).guarded("set_cage_vertices",
                                  [&] { from(self).setCageVertices(cage, count, positions); });
    };
    frame.set_transform = [](void* self, std::int32_t node, const double* matrix) {
        return from(self).guarded("set_transform", [&] { from(self).setTransform(node, matrix); });
    };
    frame.set_property = [](void* self, candela_animated_property property, std::int32_t element,
                            std::uint32_t part, std::uint32_t count, const float* numbers) {
        return from(self).guarded("set_property",
                                  [&] { from(self).setProperty(property, element, part, count, numbers); });
    };
    frame.file_size = [](void* self, const char* path, std::uint64_t* size) {
        return from(self).guarded("reading a file", [&] {
            if (!path || !size)
                throw Error(ErrorKind::badInput, "", "file_size: its path or its result is NULL");
            *size = from(self).files(path).size(path);
        });
    };
    frame.read_file_part = [](void* self, const char* path, std::uint64_t offset, std::uint64_t size,
                              void* into) {
        return from(self).guarded("reading a file", [&] {
            if (!path || (size > 0 && !into))
                throw Error(ErrorKind::badInput, "", "read_file_part: its path or its memory is NULL");
            from(self).files(path).readPart(path, offset, {static_cast<std::byte*>(into), size});
        });
    };
    frame.parallel_for = [](void* self, std::uint32_t count, candela_parallel_body body, void* context) {
        runParallelLoop(*from(self).pool_, count, body, context);
    };
    return frame;
}

FileAccess& PluginFrameCallback::Call::files(const char* path) const {
    if (callback_.source_.files) return *callback_.source_.files;
    throw Error(ErrorKind::badInput, "",
                joined("file '", oneLine(path), "': a procedural scene has no folder to read files from"));
}

void PluginFrameCallback::Call::requireCount(const AbiReader& element, std::uint32_t count,
                                             std::size_t expected) {
    if (count != expected)
        element.refuse(joined("vertex_count is ", count, ", but it has ", expected, " vertices"));
}

std::vector<glm::vec3> PluginFrameCallback::Call::positionsFrom(const AbiReader& element, const float* from,
                                                                std::uint32_t count) {
    std::vector<glm::vec3> positions;
    element.numbers("position", from, count, positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& p = positions[i];
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > maxCoordinate)
            element.refuse(joined("position ", i, " is farther than 1e9 metres from the origin"));
    }
    return positions;
}

void PluginFrameCallback::Call::setVertices(std::int32_t mesh, std::uint32_t count, const float* positions,
                                            const float* normals) {
    const AbiReader call("set_vertices", std::nullopt, nullptr);
    const std::uint32_t index = indexOf(call, "mesh", mesh, callback_.scene_.meshes);
    const AbiReader element("mesh", index, callback_.scene_.meshes[index].name.c_str());
    const MovedMesh* moved = find(callback_.elements_.meshes, &MovedMesh::mesh, index);
    if (!moved) element.refuse("its is_moved is 0: its vertices can not be set");
    requireCount(element, count, moved->vertices());
    SceneUpdate::MeshVertices vertices{index, moved->spread(positionsFrom(element, positions, count)), {}};
    if (!normals) {
        vertices.normals = moved->normalsAt(vertices.positions);
    } else {
        std::vector<glm::vec3> given;
        element.numbers("normal", normals, count, given);
        vertices.normals = moved->spread(given);
        for (std::size_t i = 0; i < vertices.normals.size(); ++i) {
            const glm::dvec3 normal(vertices.normals[i]);
            const double length = glm::length(normal);
            vertices.normals[i] = length > 0.0 ? glm::vec3(normal / length) : moved->restNormals()[i];
        }
    }
    meshes_.insert_or_assign(index, std::move(vertices));
}

void PluginFrameCallback::Call::setCageVertices(std::int32_t cage, std::uint32_t count,
                                                const float* positions) {
    const AbiReader call("set_cage_vertices", std::nullopt, nullptr);
    const std::uint32_t index = indexOf(call, "cage", cage, callback_.scene_.cages);
    const AbiReader element("cage", index, callback_.scene_.cages[index].name.c_str());
    const MovedCage* moved = find(callback_.elements_.cages, &MovedCage::cage, index);
    if (!moved) element.refuse("its is_moved is 0: its vertices can not be set");
    requireCount(element, count, moved->restPositions.size());
    cages_.insert_or_assign(index,
                            SceneUpdate::CageVertices{index, positionsFrom(element, positions, count)});
}

void PluginFrameCallback::Call::setTransform(std::int32_t node, const double* matrix) {
    const AbiReader call("set_transform", std::nullopt, nullptr);
    const std::uint32_t index = elementFrom(call, AnimatedProperty::visibility, node);
    const AbiReader element("node", static_cast<std::size_t>(node),
                            callback_.scene_.nodes[index].name.c_str());
    element.present("matrix", matrix, 16);
    glm::dmat4 local = glm::make_mat4(matrix);
    element.context().requireFinite("its matrix", glm::mat4(local));
    const glm::mat4 affine = element.affine("matrix", glm::mat4(local));
    for (glm::length_t column = 0; column < 4; ++column) local[column][3] = affine[column][3];
    nodes_.insert_or_assign(index, local);
}

/// The index in the scene.
std::uint32_t PluginFrameCallback::Call::elementFrom(const AbiReader& call, AnimatedProperty property,
                                                     std::int32_t element) const {
    const Scene& scene = callback_.scene_;
    switch (elementOf(property)) {
        case AnimatedElement::node: {
            const std::uint32_t first = callback_.elements_.firstNode;
            const std::size_t count = scene.nodes.size() - first;
            if (element < 0 || static_cast<std::size_t>(element) >= count)
                call.refuse(joined("node is ", element, ", but the scene has ", count));
            return static_cast<std::uint32_t>(element) + first;
        }
        case AnimatedElement::material:
            return indexOf(call, "material", element, scene.materials);
        case AnimatedElement::light:
            return indexOf(call, "light", element, scene.lights);
        default:
            return indexOf(call, "camera", element, scene.cameras);
    }
}

void PluginFrameCallback::Call::setProperty(const candela_animated_property& given, std::int32_t element,
                                            std::uint32_t part, std::uint32_t count, const float* numbers) {
    const AbiReader call("set_property", std::nullopt, nullptr);
    const std::uint32_t number = call.enumerator("property", given, CANDELA_PROPERTY_FAR_PLANE + 1);
    if (number == CANDELA_PROPERTY_MORPH_WEIGHT)
        call.refuse("property is MORPH_WEIGHT, which can not be set");
    PropertyChannel channel{.property = AnimatedProperty(number - 1), .interpolation = Interpolation::step};
    const AnimatedPropertyRow& row = rowOf(channel.property);
    channel.element = elementFrom(call, channel.property, element);
    if (std::holds_alternative<TextureNumbers>(row.place)) {
        const auto slots = static_cast<std::uint32_t>(materialTextures().size());
        channel.texture = static_cast<TextureSlot>(call.below("part", part, slots));
    }
    if (count != row.numbers)
        call.refuse(joined("count is ", count, ", but ", row.name, " has ", row.numbers));
    call.present("numbers", numbers, count);
    channel.times = {0.0f};
    channel.values.assign(numbers, numbers + count);
    for (const float value : channel.values) call.context().requireWithin(row.name, value, row.min, row.max);
    requireChannel(channel, properties_.size(), callback_.scene_, call.context());
    if (channel.property == AnimatedProperty::lightPosition && !callback_.scene_.lights[channel.element].node)
        for (std::size_t axis = 0; axis < 3; ++axis)
            channel.values[axis] = static_cast<float>(
                channel.values[axis] - callback_.scene_.origin[static_cast<glm::length_t>(axis)]);
    properties_.push_back(std::move(channel));
}

SceneUpdate PluginFrameCallback::Call::run() {
    try {
        callPlugin();
    } catch (const Error& error) {
        throw Error(error.kind(), callback_.source_.uri,
                    joined("the frame at ", seconds_, " s, by the plugin '", callback_.source_.plugin,
                           "': ", error.what()));
    }
    return takeUpdate();
}

// A plugin must not throw. An exception that can be caught becomes an error like others.
void PluginFrameCallback::Call::callPlugin() {
    const candela_frame frame = interface();
    const candela_frame_callback& callback = callback_.callback_->get();
    candela_status status = CANDELA_FAILED;
    const char* fault = "failed and gave no reason";
    try {
        status = callback.update(callback.user, &frame);
    } catch (...) {
        fault = "threw an exception, which the plugin interface forbids";
    }
    if (failure_) std::rethrow_exception(failure_);
    if (status != CANDELA_OK) throw Error(ErrorKind::badInput, "", joined("it ", fault));
}

/// What may move but was not set is at rest.
SceneUpdate PluginFrameCallback::Call::takeUpdate() {
    SceneUpdate update;
    for (const MovedMesh& mesh : callback_.elements_.meshes) {
        const auto set = meshes_.find(mesh.mesh());
        if (set == meshes_.end()) {
            update.meshes.push_back({mesh.mesh(), mesh.restPositions(), mesh.restNormals()});
        } else {
            update.meshes.push_back(std::move(set->second));
        }
    }
    for (const MovedCage& cage : callback_.elements_.cages) {
        const auto set = cages_.find(cage.cage);
        update.cages.push_back(set == cages_.end() ? SceneUpdate::CageVertices{cage.cage, cage.restPositions}
                                                   : std::move(set->second));
    }
    for (const auto& [node, local] : nodes_) update.nodes.push_back({node, local});
    update.properties = std::move(properties_);
    return update;
}

PluginFrameCallback::PluginFrameCallback(Source source, std::unique_ptr<OwnedFrameCallback> callback,
                                         Elements elements, const Scene& scene)
    : FrameCallback({callback->get().first_second, callback->get().last_second}),
      source_(std::move(source)),
      elements_(std::move(elements)),
      scene_(withoutVertices(scene)),
      callback_(std::move(callback)) {}

PluginFrameCallback::~PluginFrameCallback() = default;

bool PluginFrameCallback::movesMesh(std::uint32_t mesh) const {
    return find(elements_.meshes, &MovedMesh::mesh, mesh) != nullptr;
}

bool PluginFrameCallback::movesCage(std::uint32_t cage) const {
    return find(elements_.cages, &MovedCage::cage, cage) != nullptr;
}

SceneUpdate PluginFrameCallback::evaluate(double seconds) const {
    return Call(*this, seconds).run();
}

}  // namespace candela
