#include "render/occlusion/embree_mesh.h"

#include <candela/error.h>

#include <cstring>
#include <utility>

namespace candela {

namespace embree {

void check(RTCDevice device, const std::string& what) {
    const RTCError code = rtcGetDeviceError(device);
    if (code == RTC_ERROR_NONE) return;
    const auto kind = code == RTC_ERROR_OUT_OF_MEMORY ? ErrorKind::limit : ErrorKind::environment;
    throw Error(kind, "", "Embree cannot " + what + " (error " + std::to_string(code) + ")");
}

namespace {

const TraceContext& contextOf(const RTCFilterFunctionNArguments* arguments) {
    return *reinterpret_cast<const TraceContext*>(arguments->context);
}

/// Is it a hit of an instance that has left the tree?
bool isOutdated(const RTCFilterFunctionNArguments* arguments, unsigned hit) {
    const std::uint8_t* outdated = contextOf(arguments).outdated;
    return outdated != nullptr && outdated[RTCHitN_instID(arguments->hit, arguments->N, hit, 0)] != 0;
}

}  // namespace

/// The rays that have hit such an instance go on.
void passOutdated(const RTCFilterFunctionNArguments* arguments) {
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == -1 && isOutdated(arguments, i)) arguments->valid[i] = 0;
    }
}

}  // namespace embree

namespace {

/// Embree reads vertices as vectors of 16 bytes, beyond the last one too.
constexpr std::size_t vertexPadding = 1;

/// The rays of a packet of which the mesh's cut-out lets a part through go on, with that part.
void passThrough(const RTCFilterFunctionNArguments* arguments) {
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        // First: the mesh of such an instance may be gone.
        if (embree::isOutdated(arguments, i)) {
            arguments->valid[i] = 0;
            continue;
        }
        const auto& mesh = *static_cast<const OcclusionMesh*>(arguments->geometryUserPtr);
        const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
        const float u = RTCHitN_u(arguments->hit, arguments->N, i),
                    v = RTCHitN_v(arguments->hit, arguments->N, i);
        const float passing = transmittance(mesh, triangle, {1.0f - u - v, u, v});
        if (passing == 0.0f) continue;
        arguments->valid[i] = 0;
        const unsigned ray = RTCRayN_id(arguments->ray, arguments->N, i);
        embree::contextOf(arguments).transmittance[ray] *= passing;
    }
}

bool sameTriangles(const OcclusionMesh& a, const OcclusionMesh& b) {
    return a.positions.size() == b.positions.size() && a.cutouts.size() == b.cutouts.size() &&
           a.triangles == b.triangles;
}

void writeVertices(RTCGeometry geometry, const OcclusionMesh& mesh) {
    auto* into = static_cast<float*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
    std::memcpy(into, mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
}

embree::Geometry makeTriangles(RTCDevice device, const OcclusionMesh& mesh,
                               std::span<const glm::uvec3> triangles) {
    embree::Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    const void* vertices =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), mesh.positions.size() + vertexPadding);
    void* indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(glm::uvec3), triangles.size());
    if (vertices == nullptr || indices == nullptr) embree::check(device, "hold a mesh");
    std::memcpy(indices, triangles.data(), triangles.size_bytes());
    writeVertices(geometry.get(), mesh);
    return geometry;
}

}  // namespace

void EmbreeMesh::set(RTCDevice device, std::shared_ptr<const OcclusionMesh> mesh) {
    const bool refitted = mesh_ && sameTriangles(*mesh_, *mesh);
    const std::shared_ptr<const OcclusionMesh> before = std::exchange(mesh_, std::move(mesh));
    if (refitted) {
        refit();
    } else {
        build(device);
    }
    if (cutouts_) rtcSetGeometryUserData(cutouts_.get(), const_cast<OcclusionMesh*>(mesh_.get()));
    rtcCommitScene(scene_.get());
    embree::check(device, "build the tree of a mesh");
}

void EmbreeMesh::build(RTCDevice device) {
    const OcclusionMesh& mesh = *mesh_;
    scene_.reset(rtcNewScene(device));
    rtcSetSceneFlags(scene_.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                              RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    // Most rays are answered by the tests of blocks in the wide tree, which is the better one: this tree is
    // for the remainder, and is built in a fifth of the time of a better one.
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);
    const std::span<const glm::uvec3> triangles(mesh.triangles);
    opaque_.reset();
    cutouts_.reset();
    if (mesh.opaqueCount() > 0) opaque_ = makeTriangles(device, mesh, triangles.first(mesh.opaqueCount()));
    if (!mesh.cutouts.empty()) {
        cutouts_ = makeTriangles(device, mesh, triangles.subspan(mesh.opaqueCount()));
        rtcSetGeometryOccludedFilterFunction(cutouts_.get(), passThrough);
    }
    for (const embree::Geometry* geometry : {&opaque_, &cutouts_}) {
        if (!*geometry) continue;
        rtcSetGeometryBuildQuality(geometry->get(), RTC_BUILD_QUALITY_LOW);
        rtcCommitGeometry(geometry->get());
        rtcAttachGeometry(scene_.get(), geometry->get());
    }
}

void EmbreeMesh::refit() const {
    for (const embree::Geometry* geometry : {&opaque_, &cutouts_}) {
        if (!*geometry) continue;
        writeVertices(geometry->get(), *mesh_);
        rtcSetGeometryBuildQuality(geometry->get(), RTC_BUILD_QUALITY_REFIT);
        rtcCommitGeometry(geometry->get());
    }
}

}  // namespace candela
