#include "render/environment/environment_pass.h"

#include "render/layout.h"

#include <cstddef>
#include <string>
#include <vector>

namespace candela {

EnvironmentPass::EnvironmentPass() : vertexArray_("environment") {}

const gl::Program& EnvironmentPass::lightProgram(const LightingInputs& inputs, bool withVisibility) {
    const bool withLobes = inputs.targets.parts.lobes;
    auto& program = lightPrograms_[4 * static_cast<std::size_t>(inputs.brdf) + (withLobes ? 2 : 0) +
                                   (withVisibility ? 1 : 0)];
    if (!program) {
        std::vector<std::string> definitions{inputs.brdf == BrdfModel::course ? "BRDF BRDF_COURSE"
                                                                              : "BRDF BRDF_GLTF"};
        if (withVisibility) definitions.emplace_back("VISIBILITY 1");
        if (withLobes) definitions.emplace_back("LOBES 1");
        program.emplace(std::vector<gl::Stage>{{"fullscreen_triangle.vert", {}, {}},
                                               {"environment.frag", definitions, {}}},
                        "environment");
    }
    return *program;
}

void EnvironmentPass::bindVisibility(const LightingInputs& inputs) {
    if (inputs.environmentVisibilityTexture != nullptr) {
        glBindTextureUnit(layout::ENVIRONMENT_VISIBILITY_UNIT, inputs.environmentVisibilityTexture->name());
        return;
    }
    const int width = inputs.targets.width, height = inputs.targets.height;
    if (visibilityWidth_ != width || visibilityHeight_ != height) {
        visibility_ = gl::Texture::target2d(GL_R8, width, height, "environment visibility");
        visibilityWidth_ = width, visibilityHeight_ = height;
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(visibility_.name(), 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE,
                        inputs.environmentVisibility);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindTextureUnit(layout::ENVIRONMENT_VISIBILITY_UNIT, visibility_.name());
}

void EnvironmentPass::draw(const gl::Framebuffer& target, const GBufferTargets& targets) const {
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
    glViewport(0, 0, targets.width, targets.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void EnvironmentPass::addLight(const LightingInputs& inputs, const gl::Framebuffer& target, Parts parts) {
    const bool withVisibility =
        inputs.environmentVisibility != nullptr || inputs.environmentVisibilityTexture != nullptr;
    if (withVisibility) bindVisibility(inputs);
    inputs.environment->bindMaps();
    glUseProgram(lightProgram(inputs, withVisibility).name());
    glUniform2f(layout::ENVIRONMENT_PARTS_LOCATION, parts.diffuse, parts.specular);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw(target, inputs.targets);
    glDisable(GL_BLEND);
}

void EnvironmentPass::drawBackground(const GBufferTargets& targets, const GpuEnvironment& environment) {
    drawPicture(targets.litWithDepth, targets, environment);
}

void EnvironmentPass::drawBehind(const gl::Framebuffer& picture, const GBufferTargets& targets,
                                 const GpuEnvironment& environment) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    drawPicture(picture, targets, environment);
    glDisable(GL_BLEND);
}

void EnvironmentPass::drawPicture(const gl::Framebuffer& target, const GBufferTargets& targets,
                                  const GpuEnvironment& environment) {
    if (!background_) {
        background_.emplace(
            std::vector<gl::Stage>{{"fullscreen_triangle.vert", {}, {}}, {"background.frag", {}, {}}},
            "background");
    }
    glUseProgram(background_->name());
    glBindTextureUnit(layout::ENVIRONMENT_PICTURE_UNIT, environment.picture().name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    draw(target, targets);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace candela
