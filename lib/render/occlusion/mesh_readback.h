#pragma once

#include "render/gpu_scene/gpu_scene_state.h"
#include "render/occlusion/occlusion_mesh.h"

#include <cstdint>
#include <map>
#include <memory>

namespace candela {

/// The alpha of the images of a scene, each read back once.
using AlphaImages = std::map<std::uint32_t, std::shared_ptr<const AlphaImage>>;

/// The triangles that an instance draws, read back from the device. `images` gains those that its cut-outs
/// read.
OcclusionMesh readOcclusionMesh(const GpuScene::State& scene, std::uint32_t instance, AlphaImages& images);

/// Has a part of what the instance draws a material that masks or blends by alpha?
bool hasAlphaPart(const GpuScene::State& scene, std::uint32_t instance);

}  // namespace candela
