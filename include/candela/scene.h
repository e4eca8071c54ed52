#pragma once

#include <candela/animation.h>
#include <candela/cage.h>
#include <candela/camera.h>
#include <candela/deformation.h>
#include <candela/environment.h>
#include <candela/export.h>
#include <candela/image.h>
#include <candela/light.h>
#include <candela/material.h>
#include <candela/mesh.h>
#include <candela/node.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// What a plugin changes at each time: see `Scene::frameCallback`.
class FrameCallback;

/// A scene as plain values; elements refer to each other by index. Metres, right-handed, +Y up.
///
/// World space, in which world matrices, lights, boxes and views are, is relative to `origin`, which lies in
/// a scene that is far from the origin of its file: what nodes without a parent say is composed in double
/// precision, and `origin` is subtracted before anything becomes a float. A light or a camera without a node
/// is in world space.
struct Scene {
    std::vector<Image> images = {};
    std::vector<Material> materials = {};
    std::vector<std::string> variants = {};  ///< Names of the looks that `selectVariant` gives the scene.
    std::vector<Mesh> meshes = {};
    std::vector<Cage> cages = {};
    std::vector<Skin> skins = {};
    std::vector<Node> nodes = {};  ///< Parents precede children.
    std::vector<Camera> cameras = {};
    std::vector<Light> lights = {};
    std::vector<Animation> animations = {};
    std::optional<Environment> environment = {};  ///< None: no light from everywhere.
    glm::dvec3 origin{0.0};  ///< Metres, at most 1e9 along each axis; 0: world space is that of the file.
    /// What the plugin that has read the scene changes at each time (`candela_frame_callback` of plugin.h),
    /// on top of the animations; null: nothing. Copies of the scene share it. It names meshes, cages, nodes,
    /// materials, lights and cameras by their indices: a scene whose elements are moved to other indices can
    /// not keep it.
    std::shared_ptr<const FrameCallback> frameCallback = {};
};

/// Whether times differ: the scene has animations or a frame callback.
CANDELA_API bool isAnimated(const Scene& scene);

/// Times in seconds.
struct TimeSpan {
    double first = 0.0, last = 0.0;
};

/// When the frame callback moves the scene, as its plugin says; 0 to 0 without one.
CANDELA_API TimeSpan frameCallbackSpan(const Scene& scene);

/// An axis-aligned box, metres; empty where `min` is over `max` on an axis.
struct CANDELA_API Bounds {
    glm::vec3 min{1e30f}, max{-1e30f};

    bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
    /// Grows to hold `other` too.
    void add(const Bounds& other);
};

/// World matrices of all nodes, one per node. Animated nodes are posed at `time` (seconds). Where two
/// animations that play animate the same property of a node, the later one in the scene applies.
/// Interpolation is that of glTF 2.0, appendix C. Throws `Error` (badInput) when `time` is not finite, a
/// parent does not precede its child, or a channel does not fit its node. This and the other functions that
/// take a time throw, besides, what the frame callback of the scene does, with the file of the scene.
CANDELA_API std::vector<glm::mat4> worldTransforms(const Scene& scene, double time = 0.0);

/// Sets the properties of nodes, materials, lights and cameras that animations which play change
/// (`Animation::properties`) to their values at `time`, in seconds. What a property was before does not
/// count, so that the same scene may be posed at one time after another. Where two channels change the same
/// property, the later one in the scene applies. Throws `Error` (badInput) when `time` is not finite or a
/// channel does not fit its element; the scene may then be posed in part.
CANDELA_API void poseProperties(Scene& scene, double time);

/// The scene's lights in world space, in the order of `Scene::lights`. `world` comes from `worldTransforms`
/// of the same `time`. As KHR_lights_punctual says, a node moves and rotates its lights, but does not scale
/// range or intensity. The intensity of lights below a node that is not visible is 0. Throws `Error`
/// (badInput) when `world` does not have one matrix per node, `time` is not finite, a light breaks a rule of
/// `validate`, or a channel of a property does not fit its element.
CANDELA_API std::vector<WorldLight> worldLights(const Scene& scene, const std::vector<glm::mat4>& world,
                                                double time = 0.0);

/// The points of a mesh or a cage at one time.
struct PosedPoints {
    std::vector<glm::vec3> points = {};  ///< Metres, one per vertex.
    glm::mat4 worldFromPoints{
        1.0f};  ///< The node's world matrix; the identity where a skin moves the points.
};

/// The positions of the mesh that node `node` shows, moved by its morph targets and then by its skin
/// (glTF 2.0, 3.7.2.2 and 3.7.3.3). `world` comes from `worldTransforms` of the same `time`. Throws `Error`
/// (badInput) when there is no such node, it shows no mesh, `world` does not have one matrix per node, `time`
/// is not finite, or mesh, skin, morph weights and animation do not fit each other.
CANDELA_API PosedPoints poseMesh(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world,
                                 double time = 0.0);

/// The same for the points of the cage that node `node` shows.
CANDELA_API PosedPoints poseCage(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world,
                                 double time = 0.0);

/// The world-space box around the meshes and cage faces that node `node` itself shows at `time`; `world`
/// comes from `worldTransforms` of that time. A limit surface lies within the box of its cage. Vertices that
/// nothing uses do not count. Empty for a node that shows nothing, as one whose matrix flattens everything to
/// a line or a point. Throws `Error` (badInput) as `poseMesh` and `poseCage`.
CANDELA_API Bounds nodeBounds(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world,
                              double time = 0.0);

/// The world-space box around the `nodeBounds` of all nodes. Throws `Error` (badInput) as `nodeBounds`.
CANDELA_API Bounds worldBounds(const Scene& scene, const std::vector<glm::mat4>& world, double time = 0.0);

/// The world-space box that a picture of the whole scene has to hold: around what `worldBounds` encloses,
/// from the first to the last key of the animations, without outliers. Outliers are vertices beside which the
/// others would be a hundredth of the picture: the shortest intervals that hold more than half of the
/// vertices along each axis grow by every vertex that lies within 100 times their largest length, and what is
/// not reached is left out. Motion is sampled at keys and between them. Throws `Error` (badInput) as
/// `worldTransforms` and `nodeBounds`.
CANDELA_API Bounds framingBounds(const Scene& scene);

/// The near plane, metres, of a view that shows `bounds` where nothing states one: a hundredth of the box's
/// diagonal, at most 0.01; 0.01 for an empty box or one of no size. Throws `Error` (badInput) when a box that
/// is not empty is not finite.
CANDELA_API float defaultNearPlane(const Bounds& bounds);

/// The view of camera `index` of the scene at `time`; `world` comes from `worldTransforms` of that time. A
/// camera ignores its node's scale, shear and mirroring. Throws `Error` (badInput) when there is no such
/// camera, it breaks a rule of `validate`, `world` does not have one finite matrix per node, or a channel of
/// a property does not fit its camera.
CANDELA_API CameraView cameraView(const Scene& scene, std::uint32_t index,
                                  const std::vector<glm::mat4>& world, double time = 0.0);

/// A view in which all of `bounds` is seen, from the front, a little to the right and above; `aspect` is
/// width over height, and `verticalFov` is in radians, 45 degrees by default. An empty box gives a view from
/// (0, 0, 5) to the origin. Throws `Error` (badInput) when `aspect` is not finite and over 0, `verticalFov`
/// does not lie between 0 and pi, or a box that is not empty is not finite.
CANDELA_API CameraView frameBounds(const Bounds& bounds, float aspect, float verticalFov = 0.785398163f);

/// Gives the submeshes of a scene, and the faces of cages, the materials that they have in variant `variant`;
/// without one, those that they have without a variant. A submesh or cage that the variant does not name gets
/// the latter too. Throws `Error` (badInput) when there is no such variant, or a mesh names a submesh that it
/// does not have.
CANDELA_API void selectVariant(Scene& scene, std::optional<std::uint32_t> variant);

/// Point lights that are scattered over a scene.
struct LightScatter {
    std::uint32_t count = 0;
    std::optional<float> range = {};    ///< Metres, over 0. None: twice their mean spacing.
    std::optional<float> candela = {};  ///< Each, 0 to 1e20. None: range² / 10.
    std::uint32_t seed = 1;             ///< Another seed gives other lights.
};

/// Appends point lights of saturated colours to a scene. They hover over its surfaces as they stand at time
/// 0, evenly by area, on the side that the normals point to, at 1/8 to 1/2 of their range, of the diagonal of
/// the surfaces' box where that is smaller: an object is lit from outside, a room from inside. They cast
/// shadows and have no radius. The first lights are the same for every larger count at the same range, and
/// the same on every machine. Throws `Error`: badInput when the scene has no surface, a number is out of its
/// range or the scene breaks a rule of `worldTransforms`; limit when memory does not hold the lights.
CANDELA_API void scatterLights(Scene& scene, const LightScatter& scatter);

/// Throws `Error` (badInput), naming the element, when the scene breaks a rule its types state: an index out
/// of range, a number that is not finite or out of its range, arrays of differing length. Lengths of
/// directions and quaternions, and sums of joint weights, may be 1 % off. Further rules:
///  - a mesh has the texture coordinates that its materials' textures read (glTF 2.0, 5.30.2), and so has a
///    cage, whose only set is 0;
///  - a submesh has at most one material for each variant, and one without a variant where it has others;
///  - the origin is finite and at most 1e9 m along each axis;
///  - as the nodes stand at time 0, their world matrices are finite, and posed meshes and cages, lights and
///    cameras stand within 1e9 m of the world's origin along each axis (matrices may be singular);
///  - emission times its strength, a light's intensity times its colour, and an environment's times its
///    radiance, are at most 1e20;
///  - the values of animations of nodes, and morph weights, are at most 1e9; those of properties are in the
///    range that `PropertyChannel` states, and the element has the property;
///  - no face of a cage names a vertex twice, each crease of a cage is an edge of one of its faces, and faces
///    of a Loop cage are triangles; what else a subdivider may reject, `Subdivider::refine` tells;
///  - the skin of a node moves a mesh or a cage with joints, and has every joint that these name.
/// Every imported scene has passed this.
CANDELA_API void validate(const Scene& scene);

/// The number of triangles that a mesh draws: those of its submeshes, or all where it has no submeshes.
CANDELA_API std::uint64_t triangleCount(const Mesh& mesh);

/// The number of triangles that the scene's meshes draw: those of every mesh, times the nodes that show it.
/// Triangles of cages depend on their level: see `GpuScene::cageReport`. Throws `Error` (badInput) when a
/// node names a mesh that does not exist.
CANDELA_API std::uint64_t triangleCount(const Scene& scene);
/// The same of lines or points.
CANDELA_API std::uint64_t elementCount(const Scene& scene, Topology topology);

}  // namespace candela
