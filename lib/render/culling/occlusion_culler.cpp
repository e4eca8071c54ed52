#include "render/culling/occlusion_culler.h"

#include "base/thread_pool.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace candela {

namespace {

/// Triangles that hide others, at most.
constexpr std::size_t maxTriangles = 1024;
/// Of the shorter of two sides of such a triangle over its distance, at least.
constexpr float minSize = 0.1f;
/// Fewer instances are drawn faster than they are tested.
constexpr std::size_t minInstances = 32;
/// Meshes that change more often hide nothing, and their bounding spheres are tested.
constexpr std::uint32_t maxChanges = 4;
/// Triangles whose neighbours are found in one frame: a few milliseconds.
constexpr std::uint32_t maxTrianglesRead = 8192;
/// Triangles that look large, at most.
constexpr std::size_t maxChosen = 4096;
/// Of larger meshes the bounding sphere is tested.
constexpr std::uint32_t maxVerticesRead = 16384;
/// Meshes of more triangles hide nothing.
constexpr std::uint32_t maxMeshTriangles = 8192;
/// After a frame in which nothing was hidden.
constexpr unsigned skippedFrames = 15;

bool looksLarge(const OccluderMesh& mesh, const OccluderMesh::Triangle& triangle,
                const glm::mat4x3& worldFromLocal, const glm::vec3& eye) {
    const auto place = [&](std::uint32_t corner) {
        return worldFromLocal * glm::vec4(mesh.corners[corner], 1.0f);
    };
    const glm::vec3 a = place(triangle.corners[0]), b = place(triangle.corners[1]),
                    c = place(triangle.corners[2]);
    const glm::vec3 way = (a + b + c) / 3.0f - eye, ab = b - a, ac = c - a;
    const float side2 = std::min(glm::dot(ab, ab), glm::dot(ac, ac));
    return side2 > minSize * minSize * glm::dot(way, way);
}

}  // namespace

std::span<const float> OcclusionCuller::verticesOf(const MeshPlace& at) const {
    return scene_.meshes.mappedVertices().subspan(static_cast<std::size_t>(at.baseVertex) * vertexFloats,
                                                  std::size_t{at.vertexCount} * vertexFloats);
}

OcclusionCuller::CachedMesh* OcclusionCuller::meshOf(std::uint32_t instance) {
    const std::optional<std::uint32_t> index = scene_.instances[instance].mesh;
    if (!index || scene_.draws.geometryOf(instance).kind != DrawGeometry::Kind::meshes) return nullptr;
    if (*index >= meshes_.size()) meshes_.resize(*index + 1);
    CachedMesh& cached = meshes_[*index];
    if (cached.version != scene_.meshes.version(*index)) {
        cached = {scene_.meshes.version(*index), cached.changes + 1, searches_, {}, {}};
        const MeshPlace& at = scene_.meshes.places()[*index];
        const glm::vec3 radius(at.sphere.radius);
        if (scene_.meshParts[*index].hasOnlyTriangles() && at.vertexCount > 0)
            cached.box = at.vertexCount > maxVerticesRead || cached.changes > maxChanges
                             ? Bounds{at.sphere.center - radius, at.sphere.center + radius}
                             : boxOf(verticesOf(at));
    }
    return cached.box ? &cached : nullptr;
}

const OccluderMesh* OcclusionCuller::occluderOf(std::uint32_t instance, const glm::vec3& eye) {
    CachedMesh* cached = meshOf(instance);
    const MeshPlace& at = scene_.meshes.places()[*scene_.instances[instance].mesh];
    if (cached == nullptr || at.indexCount > 3 * maxMeshTriangles) return nullptr;
    // A triangle as large as the mean of a mesh that covers its bounding sphere.
    const BoundingSphere& sphere = scene_.instances.sphere(instance);
    const float size = 3.0f * sphere.radius / std::sqrt(static_cast<float>(at.indexCount));
    if (size < minSize * (glm::distance(sphere.center, eye) - sphere.radius)) return nullptr;
    if (cached->changes > maxChanges) return nullptr;
    if (cached->since == searches_ || (!cached->triangles && trianglesRead_ > maxTrianglesRead)) {
        awaitsMeshes_ = true;
        return nullptr;
    }
    if (!cached->triangles) {
        trianglesRead_ += at.indexCount / 3;
        cached->triangles =
            occluderMesh(verticesOf(at), scene_.meshes.mappedIndices().subspan(at.firstIndex, at.indexCount));
    }
    return &*cached->triangles;
}

layout::FilterView OcclusionCuller::viewOf(const FilterCamera& camera, std::uint32_t instance,
                                           float facing) const {
    const BoundingSphere& sphere = scene_.meshes.places()[*scene_.instances[instance].mesh].sphere;
    return camera.view(scene_.instances.record(instance), sphere, facing);
}

/// Lists triangles that look large.
void OcclusionCuller::chooseTriangles(const glm::vec3& eye, std::uint32_t instance,
                                      const OccluderMesh& mesh) {
    const glm::mat4x3 worldFromLocal(scene_.instances.worldFromLocal(instance));
    const std::uint32_t firstIndex = scene_.meshes.places()[*scene_.instances[instance].mesh].firstIndex;
    const std::vector<Material>& materials = scene_.sceneState.materials;
    scene_.draws.visitDraws(instance, [&](const PipelineKey& key, std::uint32_t material,
                                          IndexRange indices) {
        const bool masks = material < materials.size() && materials[material].alphaMode != AlphaMode::opaque;
        if (key.transparent || masks || (indices.first - firstIndex) % 3 != 0) return;
        const std::uint32_t first = (indices.first - firstIndex) / 3;
        Candidate candidate{.instance = instance,
                            .facing = key.doubleSided ? 0.0f
                                      : key.mirrored  ? -1.0f
                                                      : 1.0f,
                            .drawn = {first, first + indices.count / 3},
                            .first = static_cast<std::uint32_t>(chosen_.size())};
        for (std::uint32_t i = candidate.drawn.first; i < candidate.drawn.end; ++i) {
            if (looksLarge(mesh, mesh.triangles[i], worldFromLocal, eye)) chosen_.push_back(i);
        }
        candidate.count = static_cast<std::uint32_t>(chosen_.size()) - candidate.first;
        if (candidate.count > 0) candidates_.push_back(candidate);
    });
}

/// Fills the buffer. False where nothing can hide others.
bool OcclusionCuller::drawOccluders(const layout::FrameUniforms& frame, const FilterCamera& camera,
                                    std::span<const std::uint32_t> visible) {
    const glm::vec3 eye(frame.eye);
    candidates_.clear(), chosen_.clear(), polygons_.clear(), boxes_.clear();
    for (const std::uint32_t instance : visible) {
        const OccluderMesh* mesh = occluderOf(instance, eye);
        if (mesh != nullptr && chosen_.size() < maxChosen) chooseTriangles(eye, instance, *mesh);
    }
    for (Candidate& candidate : candidates_) {
        candidate.firstBox = static_cast<std::uint32_t>(boxes_.size());
        setup_.append(*meshOf(candidate.instance)->triangles,
                      viewOf(camera, candidate.instance, candidate.facing), candidate.drawn,
                      std::span(chosen_).subspan(candidate.first, candidate.count), polygons_, boxes_);
        candidate.boxCount = static_cast<std::uint32_t>(boxes_.size()) - candidate.firstBox;
    }
    if (polygons_.empty()) return false;
    std::ranges::stable_sort(polygons_, std::greater(), &OccluderPolygon::farthest);
    if (polygons_.size() > maxTriangles) polygons_.resize(maxTriangles);
    buffer_.clear(frame.size.x, frame.size.y);
    buffer_.draw(polygons_);
    return true;
}

void OcclusionCuller::findHiddenInstances(const FilterCamera& camera,
                                          std::span<const std::uint32_t> visible) {
    isHidden_.assign(visible.size(), 0);
    ThreadPool::shared()->run(visible.size(), [&](std::size_t i, unsigned) {
        const CachedMesh* mesh = meshOf(visible[i]);
        if (mesh == nullptr) return;
        const std::optional<BoxOnScreen> box = boxOnScreen(*mesh->box, viewOf(camera, visible[i], 0.0f));
        isHidden_[i] = box && buffer_.hides(box->pixels, box->nearest) ? 1 : 0;
    });
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (isHidden_[i] != 0) hidden_.push_back(visible[i]);
    }
}

void OcclusionCuller::findHiddenTriangles() {
    for (const Candidate& candidate : candidates_) {
        if (std::ranges::binary_search(hidden_, candidate.instance)) continue;
        for (std::uint32_t i = 0; i < candidate.boxCount; ++i) {
            const auto& [triangle, box] = boxes_[candidate.firstBox + i];
            if (buffer_.hides(box.pixels, box.nearest))
                hiddenTriangles_.push_back({candidate.instance, triangle});
        }
    }
    std::ranges::sort(hiddenTriangles_);
    // Submeshes may share triangles.
    const auto repeated = std::ranges::unique(hiddenTriangles_);
    hiddenTriangles_.erase(repeated.begin(), repeated.end());
}

OcclusionCuller::Hidden OcclusionCuller::findHidden(const layout::FrameUniforms& frame,
                                                    std::span<const std::uint32_t> visible) {
    hidden_.clear();
    hiddenTriangles_.clear();
    const bool isOrthographic = frame.depthRange.w != 0.0f;
    if (isOrthographic || visible.size() < minInstances) return {};
    if (framesToSkip_ > 0) {
        --framesToSkip_;
        return {};
    }
    ++searches_;
    awaitsMeshes_ = false;
    trianglesRead_ = 0;
    const FilterCamera camera(frame);
    // All meshes have been read when this returns.
    if (drawOccluders(frame, camera, visible)) {
        findHiddenInstances(camera, visible);
        findHiddenTriangles();
    }
    const bool pays = awaitsMeshes_ || !hidden_.empty() || !hiddenTriangles_.empty();
    framesToSkip_ = pays ? 0 : skippedFrames;
    return {hidden_, hiddenTriangles_};
}

}  // namespace candela
