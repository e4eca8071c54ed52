#pragma once

// What embree_scene.cpp holds of Embree. Not included where candela is built without shadows.

#include "render/occlusion/occlusion_mesh.h"

#include <embree3/rtcore.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

namespace candela {

namespace embree {

struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release>;
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;

/// Throws `Error` where the last calls have failed: limit without memory, else environment. `what` is such as
/// "hold a mesh".
void check(RTCDevice device, const std::string& what);

/// What Embree hands on to filter functions.
struct TraceContext {
    RTCIntersectContext base;      ///< The first member: Embree gives its address.
    float* transmittance;          ///< One a ray, by its id.
    const std::uint8_t* outdated;  ///< 1 for each instance of the tree that rays pass through; or null.
};

/// The filter of `TraceContext::base` where `outdated` is not null.
void passOutdated(const RTCFilterFunctionNArguments* arguments);

}  // namespace embree

/// A mesh as Embree traces it: a scene of its own.
class EmbreeMesh {
  public:
    /// Where the triangles are those of before, the tree is refitted; else there is another scene. Throws as
    /// `embree::check` does.
    void set(RTCDevice device, std::shared_ptr<const OcclusionMesh> mesh);

    RTCScene scene() const { return scene_.get(); }

  private:
    void build(RTCDevice device);
    void refit() const;

    std::shared_ptr<const OcclusionMesh> mesh_;
    embree::Scene scene_;
    embree::Geometry opaque_, cutouts_;  ///< Null where the mesh has none.
};

}  // namespace candela
