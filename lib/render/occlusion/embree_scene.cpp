#include "render/occlusion/embree_scene.h"

#include "base/thread_pool.h"
#include "render/occlusion/embree_mesh.h"

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

/// A mesh and its instances.
struct MeshEntry {
    EmbreeMesh mesh;
    std::vector<std::uint32_t> users;
};

/// A tree over instances.
struct UpperTree {
    embree::Scene scene;
    std::size_t instances = 0;
    bool changed = true;  ///< Since the last commit.
};

struct InstanceEntry {
    std::uint32_t mesh = noMesh;
    glm::mat4 worldFromLocal{1.0f};
    bool hides = false;      ///< It casts a shadow.
    bool isChanged = false;  ///< Since the last commit.
    embree::Geometry geometry;
    RTCScene scene = nullptr;   ///< That the geometry shows, and keeps.
    UpperTree* tree = nullptr;  ///< That holds the geometry.
    unsigned id = 0;            ///< Of the geometry in the tree.

    static constexpr std::uint32_t noMesh = 0xffffffffu;
};

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
    embree::Device device;
    std::atomic<std::int64_t> bytes{0};
    std::vector<MeshEntry> meshes;
    std::vector<InstanceEntry> instances;
    /// Those that rest, and those that have changed. A commit builds a tree anew: few that move, in a scene
    /// of many, do not touch the large one. Of those that have left it the geometry stays there, and rays
    /// pass through it, until it is built anew. Its geometries have the numbers of the instances.
    UpperTree still, moving;
    std::vector<std::uint32_t> changed;    ///< Instances since the last commit.
    std::vector<std::uint8_t> isOutdated;  ///< 1 for each instance whose geometry in `still` is outdated.
    std::vector<std::uint32_t> outdated;   ///< These.
    std::size_t movingWork = 0;  ///< Instances in all trees of those that move since `still` was built.
    bool isCommitted = false;

    void makeTree(UpperTree& tree) const {
        tree.scene.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(tree.scene.get(),
                         static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
        rtcSetSceneBuildQuality(tree.scene.get(), RTC_BUILD_QUALITY_LOW);
    }

    void mark(std::uint32_t index) {
        if (!instances[index].isChanged) changed.push_back(index);
        instances[index].isChanged = true;
    }

    void attach(std::uint32_t index, UpperTree& tree) {
        InstanceEntry& entry = instances[index];
        entry.tree = &tree;
        ++tree.instances;
        tree.changed = true;
        if (&tree == &moving) {
            entry.id = rtcAttachGeometry(tree.scene.get(), entry.geometry.get());
            return;
        }
        entry.id = index;
        rtcAttachGeometryByID(tree.scene.get(), entry.geometry.get(), index);
    }

    void detach(InstanceEntry& entry) {
        if (entry.tree == nullptr) return;
        rtcDetachGeometry(entry.tree->scene.get(), entry.id);
        entry.tree->changed = true;
        --entry.tree->instances;
        entry.tree = nullptr;
    }

    /// Leaves the instance's geometry in the tree of those that rest.
    void outdate(std::uint32_t index) {
        isOutdated.resize(instances.size());
        isOutdated[index] = 1;
        outdated.push_back(index);
        instances[index].geometry.reset();
        instances[index].tree = nullptr;
        --still.instances;
    }

    /// Brings the geometry of a changed instance in step.
    void apply(std::uint32_t index, bool leavesGeometry) {
        InstanceEntry& entry = instances[index];
        entry.isChanged = false;
        if (entry.tree == &still && leavesGeometry) {
            outdate(index);
        } else if (entry.tree == &still || !entry.hides) {
            detach(entry);
        }
        if (!entry.hides) return entry.geometry.reset();
        if (!entry.geometry) {
            entry.geometry.reset(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
            entry.scene = nullptr;
        }
        if (const RTCScene scene = meshes[entry.mesh].mesh.scene(); entry.scene != scene) {
            rtcSetGeometryInstancedScene(entry.geometry.get(), scene);
            entry.scene = scene;
        }
        rtcSetGeometryTransform(entry.geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                                &entry.worldFromLocal);
        rtcCommitGeometry(entry.geometry.get());
        // What is added to a scene that is drawn already is taken for something that moves.
        if (entry.tree == nullptr)
            attach(index, isCommitted ? moving : still);
        else
            entry.tree->changed = true;
    }

    void applyChanges() {
        const bool few = 8 * changed.size() < still.instances;
        for (const std::uint32_t index : changed) apply(index, isCommitted && few);
        if (moving.changed) movingWork += moving.instances;
    }

    /// Takes those that have come to rest for resting once the trees of those that move have taken as much
    /// work as a tree of the others does: so that a commit costs in proportion to what changes, on average.
    void settle() {
        const bool mostRest = 2 * changed.size() < moving.instances;
        if (mostRest && movingWork > still.instances) {
            removeOutdated();
            std::vector<bool> moves(instances.size(), false);
            for (const std::uint32_t index : changed) moves[index] = true;
            for (std::uint32_t i = 0; i < instances.size(); ++i) {
                if (instances[i].tree != &moving || moves[i]) continue;
                detach(instances[i]);
                attach(i, still);
            }
        }
        if (still.changed || 8 * outdated.size() > still.instances) removeOutdated();
        if (still.changed) movingWork = 0;
    }

    void removeOutdated() {
        for (const std::uint32_t index : std::exchange(outdated, {})) {
            rtcDetachGeometry(still.scene.get(), index);
            isOutdated[index] = 0;
            still.changed = true;
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
    MeshEntry& entry = state_->meshes[index];
    entry.mesh.set(state_->device.get(), std::move(mesh));
    // The upper tree has read the bounds of the mesh, and its scene where that is a new one.
    for (const std::uint32_t user : entry.users) state_->mark(user);
}

void EmbreeScene::setInstance(std::uint32_t index, const OcclusionInstance& instance) {
    if (index >= state_->instances.size()) state_->instances.resize(index + 1);
    InstanceEntry& entry = state_->instances[index];
    if (entry.mesh != instance.mesh) {
        if (entry.mesh != InstanceEntry::noMesh) std::erase(state_->meshes[entry.mesh].users, index);
        state_->meshes[instance.mesh].users.push_back(index);
    }
    entry.mesh = instance.mesh;
    entry.worldFromLocal = instance.worldFromLocal;
    entry.hides = instance.castsShadow && isInvertible(instance.worldFromLocal);
    state_->mark(index);
}

void EmbreeScene::disableInstance(std::uint32_t index) {
    if (index >= state_->instances.size() || !state_->instances[index].hides) return;
    state_->instances[index].hides = false;
    state_->mark(index);
}

void EmbreeScene::commit() {
    state_->applyChanges();
    state_->settle();
    state_->changed.clear();
    for (UpperTree* tree : {&state_->still, &state_->moving}) {
        if (tree->changed) rtcCommitScene(tree->scene.get());
        tree->changed = false;
    }
    state_->isCommitted = true;
    embree::check(state_->device.get(), "build the tree of the instances");
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
    embree::TraceContext context{{}, transmittance, nullptr};
    rtcInitIntersectContext(&context.base);
    // Not RTC_INTERSECT_CONTEXT_FLAG_COHERENT: with AVX-512, the compiled packet traversal of Debian's Embree
    // 3.13.5 stores a mask of 16 bits where it reads 64, and at times never ends.
    context.base.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const FlushDenormals flush;
    if (state_->moving.instances > 0)
        rtcOccluded16(packet.active, state_->moving.scene.get(), &context.base, &rays);
    if (!state_->outdated.empty()) {
        context.outdated = state_->isOutdated.data();
        context.base.filter = embree::passOutdated;
    }
    if (state_->still.instances > 0)
        rtcOccluded16(packet.active, state_->still.scene.get(), &context.base, &rays);
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
