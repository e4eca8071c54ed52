#pragma once

#include "convert.h"

#include <candela/accumulator.h>
#include <candela/brdf.h>
#include <candela/frame_settings.h>
#include <candela/gpu_scene.h>
#include <candela/import.h>
#include <candela/scene.h>

#include <array>
#include <utility>

/// The words of enumerations: those of the command line where it has them.
namespace candela::python {

template <typename E, std::size_t N>
using WordTable = std::array<std::pair<const char*, E>, N>;

template <>
struct Words<LightType> {
    static constexpr WordTable<LightType, 3> words{
        {{"point", LightType::point}, {"spot", LightType::spot}, {"directional", LightType::directional}}};
};

template <>
struct Words<PixelFormat> {
    static constexpr WordTable<PixelFormat, 3> words{
        {{"rgba8", PixelFormat::rgba8}, {"rgba16", PixelFormat::rgba16}, {"rgba32f", PixelFormat::rgba32f}}};
};

template <>
struct Words<Topology> {
    static constexpr WordTable<Topology, 3> words{
        {{"triangles", Topology::triangles}, {"lines", Topology::lines}, {"points", Topology::points}}};
};

template <>
struct Words<Wrap> {
    static constexpr WordTable<Wrap, 3> words{{{"repeat", Wrap::repeat},
                                               {"clamp_to_edge", Wrap::clampToEdge},
                                               {"mirrored_repeat", Wrap::mirroredRepeat}}};
};

template <>
struct Words<Filter> {
    static constexpr WordTable<Filter, 6> words{{{"linear_mipmap_linear", Filter::linearMipmapLinear},
                                                 {"nearest", Filter::nearest},
                                                 {"linear", Filter::linear},
                                                 {"nearest_mipmap_nearest", Filter::nearestMipmapNearest},
                                                 {"linear_mipmap_nearest", Filter::linearMipmapNearest},
                                                 {"nearest_mipmap_linear", Filter::nearestMipmapLinear}}};
};

template <>
struct Words<AlphaMode> {
    static constexpr WordTable<AlphaMode, 3> words{
        {{"opaque", AlphaMode::opaque}, {"mask", AlphaMode::mask}, {"blend", AlphaMode::blend}}};
};

template <>
struct Words<SubdivisionScheme> {
    static constexpr WordTable<SubdivisionScheme, 3> words{
        {{"catmull_clark", SubdivisionScheme::catmullClark},
         {"loop", SubdivisionScheme::loop},
         {"bilinear", SubdivisionScheme::bilinear}}};
};

template <>
struct Words<BoundaryInterpolation> {
    static constexpr WordTable<BoundaryInterpolation, 3> words{
        {{"none", BoundaryInterpolation::none},
         {"edges", BoundaryInterpolation::edges},
         {"edges_and_corners", BoundaryInterpolation::edgesAndCorners}}};
};

template <>
struct Words<FaceVaryingInterpolation> {
    static constexpr WordTable<FaceVaryingInterpolation, 6> words{
        {{"none", FaceVaryingInterpolation::none},
         {"corners_only", FaceVaryingInterpolation::cornersOnly},
         {"corners_plus1", FaceVaryingInterpolation::cornersPlus1},
         {"corners_plus2", FaceVaryingInterpolation::cornersPlus2},
         {"boundaries", FaceVaryingInterpolation::boundaries},
         {"all", FaceVaryingInterpolation::all}}};
};

template <>
struct Words<CreaseMethod> {
    static constexpr WordTable<CreaseMethod, 2> words{
        {{"uniform", CreaseMethod::uniform}, {"chaikin", CreaseMethod::chaikin}}};
};

template <>
struct Words<TriangleSubdivision> {
    static constexpr WordTable<TriangleSubdivision, 2> words{
        {{"catmull_clark", TriangleSubdivision::catmullClark}, {"smooth", TriangleSubdivision::smooth}}};
};

template <>
struct Words<AnimationPath> {
    static constexpr WordTable<AnimationPath, 4> words{{{"translation", AnimationPath::translation},
                                                        {"rotation", AnimationPath::rotation},
                                                        {"scale", AnimationPath::scale},
                                                        {"morph_weights", AnimationPath::morphWeights}}};
};

template <>
struct Words<AnimatedProperty> {
    static constexpr WordTable<AnimatedProperty, 43> words{
        {{"visible", AnimatedProperty::visibility},
         {"base_color", AnimatedProperty::baseColor},
         {"metallic", AnimatedProperty::metallic},
         {"roughness", AnimatedProperty::roughness},
         {"emission", AnimatedProperty::emission},
         {"emission_strength", AnimatedProperty::emissionStrength},
         {"normal_scale", AnimatedProperty::normalScale},
         {"occlusion_strength", AnimatedProperty::occlusionStrength},
         {"alpha_cutoff", AnimatedProperty::alphaCutoff},
         {"ior", AnimatedProperty::ior},
         {"specular", AnimatedProperty::specularFactor},
         {"specular_color", AnimatedProperty::specularColor},
         {"clearcoat", AnimatedProperty::clearcoatFactor},
         {"clearcoat_roughness", AnimatedProperty::clearcoatRoughness},
         {"clearcoat_normal_scale", AnimatedProperty::clearcoatNormalScale},
         {"sheen_color", AnimatedProperty::sheenColor},
         {"sheen_roughness", AnimatedProperty::sheenRoughness},
         {"anisotropy", AnimatedProperty::anisotropyStrength},
         {"anisotropy_rotation", AnimatedProperty::anisotropyRotation},
         {"iridescence", AnimatedProperty::iridescenceFactor},
         {"iridescence_ior", AnimatedProperty::iridescenceIor},
         {"iridescence_min_thickness", AnimatedProperty::iridescenceMinThickness},
         {"iridescence_max_thickness", AnimatedProperty::iridescenceMaxThickness},
         {"transmission", AnimatedProperty::transmissionFactor},
         {"thickness", AnimatedProperty::thickness},
         {"attenuation_distance", AnimatedProperty::attenuationDistance},
         {"attenuation_color", AnimatedProperty::attenuationColor},
         {"dispersion", AnimatedProperty::dispersion},
         {"diffuse_transmission", AnimatedProperty::diffuseTransmissionFactor},
         {"diffuse_transmission_color", AnimatedProperty::diffuseTransmissionColor},
         {"texture_offset", AnimatedProperty::textureOffset},
         {"texture_rotation", AnimatedProperty::textureRotation},
         {"texture_scale", AnimatedProperty::textureScale},
         {"light_color", AnimatedProperty::lightColor},
         {"light_intensity", AnimatedProperty::lightIntensity},
         {"light_range", AnimatedProperty::lightRange},
         {"inner_cone_angle", AnimatedProperty::innerConeAngle},
         {"outer_cone_angle", AnimatedProperty::outerConeAngle},
         {"light_position", AnimatedProperty::lightPosition},
         {"vertical_fov", AnimatedProperty::verticalFov},
         {"orthographic_height", AnimatedProperty::orthographicHeight},
         {"near_plane", AnimatedProperty::nearPlane},
         {"far_plane", AnimatedProperty::farPlane}}};
};

template <>
struct Words<TextureSlot> {
    static constexpr WordTable<TextureSlot, 19> words{
        {{"base_color", TextureSlot::baseColor},
         {"metallic_roughness", TextureSlot::metallicRoughness},
         {"normal", TextureSlot::normal},
         {"emission", TextureSlot::emission},
         {"occlusion", TextureSlot::occlusion},
         {"specular", TextureSlot::specular},
         {"specular_color", TextureSlot::specularColor},
         {"clearcoat", TextureSlot::clearcoat},
         {"clearcoat_roughness", TextureSlot::clearcoatRoughness},
         {"clearcoat_normal", TextureSlot::clearcoatNormal},
         {"sheen_color", TextureSlot::sheenColor},
         {"sheen_roughness", TextureSlot::sheenRoughness},
         {"anisotropy", TextureSlot::anisotropy},
         {"iridescence", TextureSlot::iridescence},
         {"iridescence_thickness", TextureSlot::iridescenceThickness},
         {"transmission", TextureSlot::transmission},
         {"thickness", TextureSlot::thickness},
         {"diffuse_transmission", TextureSlot::diffuseTransmission},
         {"diffuse_transmission_color", TextureSlot::diffuseTransmissionColor}}};
};

template <>
struct Words<Interpolation> {
    static constexpr WordTable<Interpolation, 3> words{{{"linear", Interpolation::linear},
                                                        {"step", Interpolation::step},
                                                        {"cubic_spline", Interpolation::cubicSpline}}};
};

template <>
struct Words<BrdfModel> {
    static constexpr WordTable<BrdfModel, 2> words{
        {{"course", BrdfModel::course}, {"gltf", BrdfModel::gltf}}};
};

template <>
struct Words<Technique> {
    static constexpr WordTable<Technique, 4> words{{{"auto", Technique::automatic},
                                                    {"volumes", Technique::volumes},
                                                    {"tiles", Technique::tiles},
                                                    {"fullscreen", Technique::fullscreen}}};
};

template <>
struct Words<TileBackend> {
    static constexpr WordTable<TileBackend, 3> words{
        {{"auto", TileBackend::automatic}, {"cpu", TileBackend::cpu}, {"compute", TileBackend::compute}}};
};

template <>
struct Words<DebugView> {
    static constexpr WordTable<DebugView, 10> words{{{"picture", DebugView::none},
                                                     {"normals", DebugView::normals},
                                                     {"level", DebugView::level},
                                                     {"base_color", DebugView::baseColor},
                                                     {"metallic", DebugView::metallic},
                                                     {"roughness", DebugView::roughness},
                                                     {"depth", DebugView::depth},
                                                     {"emission", DebugView::emission},
                                                     {"light_count", DebugView::lightCount},
                                                     {"shadowed_count", DebugView::shadowedCount}}};
};

template <>
struct Words<Shadows> {
    static constexpr WordTable<Shadows, 3> words{
        {{"auto", Shadows::automatic}, {"off", Shadows::off}, {"on", Shadows::on}}};
};

template <>
struct Words<AovFilter> {
    static constexpr WordTable<AovFilter, 3> words{
        {{"auto", AovFilter::automatic}, {"average", AovFilter::average}, {"first", AovFilter::first}}};
};

template <>
struct Words<VertexEvaluator> {
    static constexpr WordTable<VertexEvaluator, 3> words{{{"auto", VertexEvaluator::automatic},
                                                          {"cpu", VertexEvaluator::cpu},
                                                          {"compute", VertexEvaluator::compute}}};
};

template <>
struct Words<VertexDetail> {
    static constexpr WordTable<VertexDetail, 2> words{
        {{"as_needed", VertexDetail::asNeeded}, {"always", VertexDetail::always}}};
};

template <>
struct Words<UpAxis> {
    static constexpr WordTable<UpAxis, 3> words{{{"y", UpAxis::y}, {"z", UpAxis::z}, {"x", UpAxis::x}}};
};

template <>
struct Words<NoteKind> {
    static constexpr WordTable<NoteKind, 3> words{{{"missing", NoteKind::missing},
                                                   {"repaired", NoteKind::repaired},
                                                   {"information", NoteKind::information}}};
};

}  // namespace candela::python
