#pragma once

#include <candela/camera.h>
#include <candela/light.h>

#include <glm/vec3.hpp>

#include <filesystem>
#include <span>
#include <string>

/// A camera that a file of lights has, in world space.
struct SavedCamera {
    std::string name;
    candela::CameraView view;  ///< With a far plane, where it is orthographic.
};

/// Lights and cameras as a glTF file: KHR_lights_punctual, with `castsShadow` and `radius` in the `extras` of
/// lights that need them, and every number as the float that it is. `origin` is that of the scene, whose
/// world space the lights and cameras are in.
std::string lightsGltf(std::span<const candela::WorldLight> lights, std::span<const SavedCamera> cameras,
                       const glm::dvec3& origin);

/// The same as the bytes of a .glb file.
std::string glbOf(const std::string& gltf);
