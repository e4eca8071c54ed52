#include "render/host/depth_conversion.h"

#include "render/frame_request.h"
#include "render/layout.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace candela {

namespace {

gl::Program makeProgram(std::vector<std::string> definitions, const char* label) {
    return gl::Program(
        {{"fullscreen_triangle.vert", {}, {}}, {"depth_conversion.frag", std::move(definitions), {}}}, label);
}

}  // namespace

glm::vec4 DepthScale::uniform() const {
    const double isReversed = direction == DepthConvention::Direction::reversed ? 1.0 : 0.0;
    if (orthographic) return glm::dvec4(nearPlane, *farPlane, *farPlane - nearPlane, isReversed);
    const double end = farPlane ? nearPlane / *farPlane : 0.0;
    return glm::dvec4(nearPlane, end, 1.0 - end, isReversed);
}

DepthScale depthScale(const CameraView& view) {
    return {view.orthographicHeight.has_value(), DepthConvention::Direction::reversed, view.nearPlane,
            view.farPlane};
}

DepthScale depthScale(const CameraView& view, const DepthConvention& convention) {
    DepthScale scale = depthScale(view);
    scale.direction = convention.direction;
    if (convention.nearPlane) scale.nearPlane = *convention.nearPlane;
    if (convention.farPlane) scale.farPlane = *convention.farPlane;
    const bool isNear = std::isfinite(scale.nearPlane) && (scale.nearPlane > 0.0 || scale.orthographic);
    if (!isNear) {
        refuse("the near plane of a host's depth is " + std::to_string(scale.nearPlane) +
               " m; it has to be finite and over 0");
    }
    if (scale.farPlane && !(*scale.farPlane > scale.nearPlane && std::isfinite(*scale.farPlane))) {
        refuse("the far plane of a host's depth is " + std::to_string(*scale.farPlane) +
               " m; it has to be finite and over its near plane, " + std::to_string(scale.nearPlane) + " m");
    }
    if (scale.orthographic && !scale.farPlane)
        refuse("a host's depth of an orthographic view needs a far plane, of the view or of the host");
    return scale;
}

DepthConversion::DepthConversion()
    : depth_(makeProgram({"DEPTH 1", "RADIANCE 0"}, "depth conversion")),
      depthAndRadiance_(makeProgram({"DEPTH 1", "RADIANCE 1"}, "host surfaces")),
      radiance_(makeProgram({"DEPTH 0", "RADIANCE 1"}, "host radiance")),
      sampler_("host textures"),
      vertexArray_("depth conversion") {
    // With it a host's texture needs no levels, and a depth texture is read without comparison.
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void DepthConversion::draw(const gl::Program& program, const Inputs& inputs) {
    glUseProgram(program.name());
    if (inputs.depth != 0) {
        glUniform4fv(layout::DEPTH_FROM_LOCATION, 1, glm::value_ptr(inputs.from.uniform()));
        glUniform4fv(layout::DEPTH_TO_LOCATION, 1, glm::value_ptr(inputs.to.uniform()));
        glBindTextureUnit(layout::DEPTH_UNIT, inputs.depth);
        glBindSampler(layout::DEPTH_UNIT, sampler_.name());
    }
    glUniform4i(layout::DEPTH_PLACE_LOCATION, inputs.target.x, inputs.target.y,
                inputs.from.orthographic ? 1 : 0, inputs.from.hasSamePlanes(inputs.to) ? 1 : 0);
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, inputs.target.framebuffer);
    glViewport(inputs.target.x, inputs.target.y, inputs.width, inputs.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(layout::DEPTH_UNIT, 0);
}

void DepthConversion::render(const Inputs& inputs) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    draw(depth_, inputs);
    glDisable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void DepthConversion::renderRadiance(GLuint radiance, const Inputs& inputs) {
    glBindTextureUnit(layout::RADIANCE_UNIT, radiance);
    glBindSampler(layout::RADIANCE_UNIT, sampler_.name());
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    draw(inputs.depth != 0 ? depthAndRadiance_ : radiance_, inputs);
    glDepthMask(GL_TRUE);
    glBindSampler(layout::RADIANCE_UNIT, 0);
}

}  // namespace candela
