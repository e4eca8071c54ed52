#include "support/lobe_pixels.h"

#include "gl/state_guard.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/gbuffer_copy.h"
#include "render/gbuffer/geometry_pass.h"
#include "render/gbuffer/readback.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace candela::test {

LobePixels::LobePixels(const Context& context, GpuScene& scene, const CameraView& view, int width, int height)
    : width_(width), height_(height) {
    context.makeCurrent();
    const gl::StateGuard guard(*context.state().binding, "a test");
    GpuScene::State& state = scene.state();
    state.update();
    const layout::FrameUniforms uniforms =
        frameUniforms(view, width, height, glm::dmat3(1.0), state.lights.counts());
    gl::Buffer buffer("frame", gl::BufferUsage::dynamic);
    buffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, buffer.name());
    const GBufferTargets targets(width, height, {.lobes = true});
    DrawSelection draws;
    state.cull(Frustum(view, static_cast<float>(width) / static_cast<float>(height)), draws);
    GeometryPass().render({state, draws, targets, LoadOp::clear});
    GBufferCopy copy;
    copy.reset(targets);
    words_.assign(copy.lobeWords().begin(), copy.lobeWords().end());
    diffuseTransmission_.assign(copy.diffuseTransmission().begin(), copy.diffuseTransmission().end());
}

std::optional<ExtendedLobes<double>> LobePixels::at(int x, int y, const glm::vec3& normal) const {
    const auto pixel = static_cast<std::size_t>((height_ - 1 - y) * width_ + x);
    GBufferLobeWords words;
    std::copy_n(&words_[4 * pixel], 4, words.lobes.begin());
    words.diffuseTransmission = diffuseTransmission_[pixel];
    if (words.lobes[2] == 0) return std::nullopt;
    const ExtendedLobes<float> lobes = unpackLobeWords(words, normal);
    return ExtendedLobes<double>{glm::dvec3(lobes.f0),
                                 lobes.f90,
                                 lobes.anisotropy,
                                 glm::normalize(glm::dvec3(lobes.anisotropyDirection)),
                                 glm::dvec3(lobes.sheenColor),
                                 lobes.sheenRoughness,
                                 lobes.clearcoat,
                                 lobes.clearcoatRoughness,
                                 glm::normalize(glm::dvec3(lobes.clearcoatNormal)),
                                 lobes.transmission,
                                 lobes.diffuseTransmission,
                                 glm::dvec3(lobes.diffuseTransmissionColor)};
}

int LobePixels::count() const {
    int count = 0;
    for (std::size_t word = 2; word < words_.size(); word += 4) count += words_[word] != 0;
    return count;
}

}  // namespace candela::test
