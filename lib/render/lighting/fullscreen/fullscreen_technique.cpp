#include "render/lighting/fullscreen/fullscreen_technique.h"

#include "render/gbuffer/readback.h"
#include "render/layout.h"

#include <algorithm>

namespace candela {

FullscreenPass::FullscreenPass(LightsPerInvocation limit)
    : programs_("fullscreen_triangle.vert", "fullscreen.frag", {}),
      limit_(limit),
      vertexArray_("fullscreen triangle") {}

void FullscreenPass::draw(const LightingInputs& inputs, Span points, Span spots, Span directionals) const {
    glUseProgram(programs_.get(inputs).name());
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, inputs.targets.lit.name());
    glViewport(0, 0, inputs.targets.width, inputs.targets.height);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUniform4i(layout::LIGHT_SPANS_LOCATION, points.first, points.end, spots.first, spots.end);
    glUniform2i(layout::DIRECTIONAL_SPAN_LOCATION, directionals.first, directionals.end);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

void FullscreenPass::addDirectionals(const LightingInputs& inputs) const {
    const LightCounts& counts = inputs.lights.counts();
    const int step = limit_.of(inputs), first = counts.points + counts.spots,
              end = first + counts.directionals;
    for (int i = first; i < end; i += step) draw(inputs, {}, {}, {i, std::min(i + step, end)});
}

void FullscreenPass::addLocals(const LightingInputs& inputs) const {
    const LightCounts& counts = inputs.lights.counts();
    const int step = limit_.of(inputs);
    for (int i = 0; i < counts.points; i += step)
        draw(inputs, {i, std::min(i + step, counts.points)}, {}, {});
    const int end = counts.points + counts.spots;
    for (int i = counts.points; i < end; i += step) draw(inputs, {}, {i, std::min(i + step, end)}, {});
}

void FullscreenTechnique::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    pass_.addLocals(inputs);
    pass_.addDirectionals(inputs);
}

std::uint64_t FullscreenTechnique::countEvaluated(const LightingInputs& inputs, PairCounter&) {
    return countLitSurfaces(inputs.targets) * inputs.lights.reaches().size();
}

}  // namespace candela
