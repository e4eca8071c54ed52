#include "render/occlusion/environment_occlusion_pass.h"

#include <algorithm>
#include <string>
#include <vector>

namespace candela {

namespace {

constexpr int groupSide = 8;  // of environment_occlusion.comp

void dispatch(const GBufferTargets& targets) {
    glDispatchCompute(static_cast<GLuint>((targets.width + groupSide - 1) / groupSide),
                      static_cast<GLuint>((targets.height + groupSide - 1) / groupSide), 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace

EnvironmentOcclusionPass::Targets::Targets(int pixelsWide, int pixelsHigh)
    : width(pixelsWide),
      height(pixelsHigh),
      hidden(gl::Texture::target2d(GL_R32F, width, height, "hidden environment")),
      visibility(gl::Texture::target2d(GL_R8, width, height, "environment visibility")) {}

const gl::Program& EnvironmentOcclusionPass::filterFor(const GBufferParts& parts) {
    const auto found = filters_.find(parts);
    if (found != filters_.end()) return found->second;
    std::vector<std::string> definitions{"FILTER 1"};
    for (const std::string& definition : definitionsOf(parts)) definitions.push_back(definition);
    const std::vector<gl::Stage> stages{{"environment_occlusion.comp", definitions, {}}};
    return filters_.try_emplace(parts, stages, "environment occlusion filter").first->second;
}

const gl::Texture& EnvironmentOcclusionPass::render(const GBufferTargets& targets,
                                                    const GpuOcclusion& occluders,
                                                    const EnvironmentRays& rays) {
    if (!trace_)
        trace_.emplace(std::vector<gl::Stage>{{"environment_occlusion.comp", {"FILTER 0"}, {}}},
                       "environment occlusion rays");
    const bool fits = targets_ && targets_->width == targets.width && targets_->height == targets.height;
    if (!fits) targets_.emplace(targets.width, targets.height);
    const gl::Program& filter = filterFor(targets.parts);
    targets.bind();
    occluders.bind();
    glBindImageTexture(layout::HIDDEN_IMAGE, targets_->hidden.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    glBindImageTexture(layout::VISIBILITY_IMAGE, targets_->visibility.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                       GL_R8);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glUseProgram(trace_->name());
    glUniform1f(layout::ENVIRONMENT_DISTANCE_LOCATION, rays.distance);
    for (std::uint32_t first = 0; first < rays.rays; first += maxRays_) {
        const std::uint32_t end = std::min(first + maxRays_, rays.rays);
        glUniform4ui(layout::ENVIRONMENT_RAYS_LOCATION, first, end, rays.rays, rays.sample);
        dispatch(targets);
    }
    glUseProgram(filter.name());
    glUniform4ui(layout::ENVIRONMENT_RAYS_LOCATION, 0, 0, rays.rays, rays.sample);
    dispatch(targets);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    return targets_->visibility;
}

}  // namespace candela
