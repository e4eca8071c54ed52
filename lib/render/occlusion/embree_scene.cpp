#include "render/occlusion/embree_scene.h"

#include "base/thread_pool.h"

#include <candela/error.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace candela {

namespace {

struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using Scene3 = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry3 = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;
using Device3 = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;

/// Embree reads vertices as vectors of 16 bytes, beyond the last one too.
constexpr std::size_t vertexPadding = 1;

/// A mesh and its own tree.
struct MeshTree {
    std::shared_ptr<const OcclusionMesh> mesh;
    Scene3 scene;
    Geometry3 opaque, cutouts;         ///< Null where the mesh has none.
    std::vector<std::uint32_t> users;  ///< Its instances.
};

/// A tree over instances.
struct UpperTree {
    Scene3 scene;
    std::size_t instances = 0;
    bool changed = true;  ///< Since the last commit.
};

struct InstanceEntry {
    std::uint32_t mesh = 0;
    Geometry3 geometry;
    UpperTree* tree = nullptr;  ///< That holds the geometry.
    bool enabled = true;
};

/// What Embree hands on to the filter function.
struct TraceContext {
    RTCIntersectContext base;  ///< The first member: Embree gives its address.
    float* transmittance;      ///< One a ray, by its id.
};

/// The rays of a packet of which the mesh's cut-out lets a part through go on, with that part.
void passThrough(const RTCFilterFunctionNArguments* arguments) {
    const auto& mesh = *static_cast<const OcclusionMesh*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
        const float u = RTCHitN_u(arguments->hit, arguments->N, i),
                    v = RTCHitN_v(arguments->hit, arguments->N, i);
        const float passing = transmittance(mesh, triangle, {1.0f - u - v, u, v});
        if (passing == 0.0f) continue;
        arguments->valid[i] = 0;
        const auto* context = reinterpret_cast<const TraceContext*>(arguments->context);
        context->transmittance[RTCRayN_id(arguments->ray, arguments->N, i)] *= passing;
    }
}

bool sameTriangles(const OcclusionMesh& a, const OcclusionMesh& b) {
    return a.positions.size() == b.positions.size() && a.cutouts.size() == b.cutouts.size() &&
           a.triangles == b.triangles;
}

/// Denormal numbers slow Embree's traversal down.
class FlushDenormals {
  public:
#if defined(__x86_64__)
    FlushDenormals() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | 0x8040);
    }
    ~FlushDenormals() {
        _mm_setcsr(before_);
    }
#else
    FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
    unsigned before_ = 0;
};

}  // namespace

struct EmbreeScene::State {
    Device3 device;
    std::atomic<std::int64_t> bytes{0};
    std::vector<MeshTree> meshes;
    std::vector<InstanceEntry> instances;
    /// Those that rest, and those that have changed. A commit builds a tree anew: few that move, in a scene
    /// of many, do not touch the large one.
    UpperTree still, moving;
    std::vector<std::uint32_t> changed;  ///< Instances since the last commit; some are listed twice.
    bool isCommitted = false;

    /// Throws where the last calls have failed.
    void check(const std::string& what) const {
        const RTCError code = rtcGetDeviceError(device.get());
        if (code == RTC_ERROR_NONE) return;
        const auto kind = code == RTC_ERROR_OUT_OF_MEMORY ? ErrorKind::limit : ErrorKind::environment;
        throw Error(kind, "", "Embree cannot " + what + " (error " + std::to_string(code) + ")");
    }

    void makeTree(UpperTree& tree) const {
        tree.scene.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(tree.scene.get(),
                         static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
        rtcSetSceneBuildQuality(tree.scene.get(), RTC_BUILD_QUALITY_LOW);
    }

    /// Puts an instance into a tree, out of the one that holds it.
    void put(InstanceEntry& entry, std::uint32_t index, UpperTree& tree) {
        tree.changed = true;
        changed.push_back(index);
        if (entry.tree == &tree) return;
        if (entry.tree != nullptr) {
            rtcDetachGeometry(entry.tree->scene.get(), index);
            entry.tree->changed = true;
            --entry.tree->instances;
        }
        rtcAttachGeometryByID(tree.scene.get(), entry.geometry.get(), index);
        entry.tree = &tree;
        ++tree.instances;
    }

    /// Where few of those that once moved have changed now, the others are taken for resting again.
    void separate() {
        std::vector<std::uint32_t> now = std::exchange(changed, {});
        if (!isCommitted || 8 * now.size() >= moving.instances) return;
        std::vector<bool> isChanged(instances.size(), false);
        for (const std::uint32_t index : now) isChanged[index] = true;
        for (std::uint32_t i = 0; i < instances.size(); ++i) {
            if (instances[i].tree == &moving && !isChanged[i]) put(instances[i], i, still);
        }
        changed.clear();
    }

    void writeVertices(RTCGeometry geometry, const OcclusionMesh& mesh) const {
        auto* into = static_cast<float*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
        std::memcpy(into, mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
        rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    }

    Geometry3 makeTriangles(const OcclusionMesh& mesh, std::span<const glm::uvec3> triangles) const {
        Geometry3 geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        const void* vertices =
            rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), mesh.positions.size() + vertexPadding);
        void* indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(glm::uvec3), triangles.size());
        if (vertices == nullptr || indices == nullptr) check("hold a mesh");
        std::memcpy(indices, triangles.data(), triangles.size_bytes());
        writeVertices(geometry.get(), mesh);
        return geometry;
    }

    void build(MeshTree& tree) const {
        const OcclusionMesh& mesh = *tree.mesh;
        tree.scene.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(tree.scene.get(), RTC_SCENE_FLAG_ROBUST);
        // Most rays are answered by the tests of blocks in the wide tree, which is the better one: this tree
        // is for the remainder, and is built in a fifth of the time of a better one.
        rtcSetSceneBuildQuality(tree.scene.get(), RTC_BUILD_QUALITY_LOW);
        const std::span<const glm::uvec3> triangles(mesh.triangles);
        tree.opaque.reset();
        tree.cutouts.reset();
        if (mesh.opaqueCount() > 0) tree.opaque = makeTriangles(mesh, triangles.first(mesh.opaqueCount()));
        if (!mesh.cutouts.empty()) {
            tree.cutouts = makeTriangles(mesh, triangles.subspan(mesh.opaqueCount()));
            rtcSetGeometryOccludedFilterFunction(tree.cutouts.get(), passThrough);
        }
        for (const Geometry3* geometry : {&tree.opaque, &tree.cutouts}) {
            if (!*geometry) continue;
            rtcSetGeometryBuildQuality(geometry->get(), RTC_BUILD_QUALITY_LOW);
            rtcCommitGeometry(geometry->get());
            rtcAttachGeometry(tree.scene.get(), geometry->get());
        }
    }

    void refit(MeshTree& tree) const {
        for (const Geometry3* geometry : {&tree.opaque, &tree.cutouts}) {
            if (!*geometry) continue;
            writeVertices(geometry->get(), *tree.mesh);
            rtcSetGeometryBuildQuality(geometry->get(), RTC_BUILD_QUALITY_REFIT);
            rtcCommitGeometry(geometry->get());
        }
    }
};

EmbreeScene::EmbreeScene() : state_(std::make_unique<State>()) {
    const std::string configuration = "threads=" + std::to_string(ThreadPool::shared()->size());
    state_->device.reset(rtcNewDevice(configuration.c_str()));
    if (!state_->device) {
        throw Error(ErrorKind::environment, "",
                    "Embree does not start (error " + std::to_string(rtcGetDeviceError(nullptr)) +
                        "); shadows need it");
    }
    rtcSetDeviceMemoryMonitorFunction(
        state_->device.get(),
        [](void* bytes, ssize_t change, bool) {
            static_cast<std::atomic<std::int64_t>*>(bytes)->fetch_add(change, std::memory_order_relaxed);
            return true;
        },
        &state_->bytes);
    state_->makeTree(state_->still);
    state_->makeTree(state_->moving);
}

EmbreeScene::~EmbreeScene() = default;

void EmbreeScene::setMesh(std::uint32_t index, std::shared_ptr<const OcclusionMesh> mesh) {
    if (index >= state_->meshes.size()) state_->meshes.resize(index + 1);
    MeshTree& tree = state_->meshes[index];
    const bool refitted = tree.mesh && sameTriangles(*tree.mesh, *mesh);
    const std::shared_ptr<const OcclusionMesh> before = std::exchange(tree.mesh, std::move(mesh));
    if (refitted) {
        state_->refit(tree);
    } else {
        state_->build(tree);
    }
    if (tree.cutouts) rtcSetGeometryUserData(tree.cutouts.get(), const_cast<OcclusionMesh*>(tree.mesh.get()));
    rtcCommitScene(tree.scene.get());
    state_->check("build the tree of a mesh");
    // The upper tree has read the bounds of the mesh, and its scene where that is a new one.
    for (const std::uint32_t user : tree.users) {
        InstanceEntry& instance = state_->instances[user];
        rtcSetGeometryInstancedScene(instance.geometry.get(), tree.scene.get());
        rtcCommitGeometry(instance.geometry.get());
        state_->put(instance, user, state_->isCommitted ? state_->moving : *instance.tree);
    }
}

void EmbreeScene::setInstance(std::uint32_t index, const OcclusionInstance& instance) {
    if (index >= state_->instances.size()) state_->instances.resize(index + 1);
    InstanceEntry& entry = state_->instances[index];
    const bool isNew = !entry.geometry;
    if (isNew) entry.geometry.reset(rtcNewGeometry(state_->device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
    // What is added to a scene that is drawn already is taken for something that moves.
    state_->put(entry, index, isNew && !state_->isCommitted ? state_->still : state_->moving);
    if (isNew || entry.mesh != instance.mesh) {
        if (!isNew) std::erase(state_->meshes[entry.mesh].users, index);
        state_->meshes[instance.mesh].users.push_back(index);
        rtcSetGeometryInstancedScene(entry.geometry.get(), state_->meshes[instance.mesh].scene.get());
    }
    entry.mesh = instance.mesh;
    const bool enabled = instance.castsShadow && isInvertible(instance.worldFromLocal);
    if (enabled) {
        rtcSetGeometryTransform(entry.geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                                &instance.worldFromLocal);
    }
    if (enabled != entry.enabled) (enabled ? rtcEnableGeometry : rtcDisableGeometry)(entry.geometry.get());
    entry.enabled = enabled;
    rtcCommitGeometry(entry.geometry.get());
}

void EmbreeScene::disableInstance(std::uint32_t index) {
    if (index >= state_->instances.size()) return;
    InstanceEntry& entry = state_->instances[index];
    if (!entry.geometry || !entry.enabled) return;
    rtcDisableGeometry(entry.geometry.get());
    entry.enabled = false;
    rtcCommitGeometry(entry.geometry.get());
    state_->put(entry, index, state_->moving);
}

void EmbreeScene::commit() {
    state_->separate();
    for (UpperTree* tree : {&state_->still, &state_->moving}) {
        if (tree->changed) rtcCommitScene(tree->scene.get());
        tree->changed = false;
    }
    state_->isCommitted = true;
    state_->check("build the tree of the instances");
}

std::uint64_t EmbreeScene::bytes() const {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(state_->bytes.load(), 0));
}

std::uint32_t EmbreeScene::trace(const RayPacket& packet, float* transmittance) const {
    static_assert(RayPacket::size == 16);
    RTCRay16 rays;
    static_assert(sizeof rays.org_x == sizeof packet.origin[0]);
    std::memcpy(rays.org_x, packet.origin[0], sizeof rays.org_x);
    std::memcpy(rays.org_y, packet.origin[1], sizeof rays.org_y);
    std::memcpy(rays.org_z, packet.origin[2], sizeof rays.org_z);
    std::memcpy(rays.dir_x, packet.direction[0], sizeof rays.dir_x);
    std::memcpy(rays.dir_y, packet.direction[1], sizeof rays.dir_y);
    std::memcpy(rays.dir_z, packet.direction[2], sizeof rays.dir_z);
    std::memcpy(rays.tnear, packet.tMin, sizeof rays.tnear);
    std::memcpy(rays.tfar, packet.tMax, sizeof rays.tfar);
    std::fill_n(rays.time, 16, 0.0f);
    std::fill_n(rays.mask, 16, ~0u);
    std::iota(rays.id, rays.id + 16, 0u);
    std::fill_n(rays.flags, 16, 0u);
    std::fill_n(transmittance, 16, 1.0f);
    TraceContext context{{}, transmittance};
    rtcInitIntersectContext(&context.base);
    // Not RTC_INTERSECT_CONTEXT_FLAG_COHERENT: with AVX-512, the compiled packet traversal of Debian's Embree
    // 3.13.5 stores a mask of 16 bits where it reads 64, and at times never ends.
    context.base.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const FlushDenormals flush;
    for (const UpperTree* tree : {&state_->still, &state_->moving}) {
        if (tree->instances > 0) rtcOccluded16(packet.active, tree->scene.get(), &context.base, &rays);
    }
    std::uint32_t hidden = 0;
    for (int i = 0; i < 16; ++i) {
        // A ray that meets something opaque ends at minus infinity.
        if (packet.active[i] != 0 && rays.tfar[i] < 0.0f) transmittance[i] = 0.0f;
        hidden |= (transmittance[i] == 0.0f ? 1u : 0u) << i;
    }
    return hidden;
}

std::uint32_t EmbreeScene::tracePacket(const void* scene, const RayPacket& packet, float* transmittance) {
    return static_cast<const EmbreeScene*>(scene)->trace(packet, transmittance);
}

}  // namespace candela
