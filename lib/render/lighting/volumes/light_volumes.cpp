#include "render/lighting/volumes/light_volumes.h"

#include "render/layout.h"

namespace candela {

LightVolumes::LightVolumes()
    : proxy_(makeSphereProxy()),
      mark_({{"light_volume.vert", {}, {}}, {"light_volume_mark.frag", {}, {}}}, "light volume mark"),
      vertices_("light volume vertices"),
      triangles_("light volume triangles"),
      indexBuffer_("light volume lights"),
      vertexArray_("light volumes") {
    vertices_.upload(std::span<const glm::vec3>(proxy_.vertices));
    triangles_.upload(std::span<const std::array<std::uint32_t, 3>>(proxy_.triangles));
    const GLuint name = vertexArray_.name();
    glVertexArrayElementBuffer(name, triangles_.name());
    glVertexArrayVertexBuffer(name, 0, vertices_.name(), 0, sizeof(glm::vec3));
    glEnableVertexArrayAttrib(name, layout::POSITION_ATTRIBUTE);
    glVertexArrayAttribFormat(name, layout::POSITION_ATTRIBUTE, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(name, layout::POSITION_ATTRIBUTE, 0);
    glVertexArrayVertexBuffer(name, 1, indexBuffer_.name(), 0, sizeof(std::uint32_t));
    glVertexArrayBindingDivisor(name, 1, 1);
    glEnableVertexArrayAttrib(name, layout::LIGHT_ATTRIBUTE);
    glVertexArrayAttribIFormat(name, layout::LIGHT_ATTRIBUTE, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(name, layout::LIGHT_ATTRIBUTE, 1);
}

LightVolumes::Kind LightVolumes::append(const LightingInputs& inputs, std::uint32_t firstLight,
                                        std::uint32_t count) {
    batches_.assign({inputs.lights.reaches(), firstLight, firstLight + count, inputs.frustum, proxy_.radius,
                     inputs.targets.width, inputs.targets.height});
    const auto start = static_cast<std::uint32_t>(lightIndices_.size());
    lightIndices_.insert(lightIndices_.end(), batches_.lights().begin(), batches_.lights().end());
    Kind kind;
    std::uint32_t first = 0;
    for (const std::uint32_t end : batches_.batchEnds()) {
        kind.batches.push_back({start + first, end - first});
        first = end;
    }
    const auto total = static_cast<std::uint32_t>(batches_.lights().size());
    kind.unsorted = {start + first, total - first};
    kind.all = {start, total};
    return kind;
}

std::uint32_t LightVolumes::prepare(const LightingInputs& inputs) {
    const LightCounts& counts = inputs.lights.counts();
    lightIndices_.clear();
    points_ = append(inputs, 0, static_cast<std::uint32_t>(counts.points));
    spots_ =
        append(inputs, static_cast<std::uint32_t>(counts.points), static_cast<std::uint32_t>(counts.spots));
    indexBuffer_.upload(std::span<const std::uint32_t>(lightIndices_));
    return static_cast<std::uint32_t>(lightIndices_.size());
}

void LightVolumes::draw(const Run& run) const {
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(3 * proxy_.triangles.size()),
                                        GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(run.count), run.first);
}

void LightVolumes::drawInside(const gl::Program& pointProgram, const gl::Program& spotProgram) const {
    drawKind(points_, pointProgram);
    drawKind(spots_, spotProgram);
}

void LightVolumes::drawKind(const Kind& kind, const gl::Program& program) const {
    if (kind.all.count == 0) return;
    glBindVertexArray(vertexArray_.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_CULL_FACE);
    glEnable(GL_STENCIL_TEST);
    glBlendFunc(GL_ONE, GL_ONE);
    for (const Run& batch : kind.batches) {
        glUseProgram(mark_.name());
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDisable(GL_BLEND);
        glCullFace(GL_BACK);
        glDepthFunc(GL_GEQUAL);
        glStencilFunc(GL_ALWAYS, 1, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        draw(batch);
        glUseProgram(program.name());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glEnable(GL_BLEND);
        glCullFace(GL_FRONT);
        glDepthFunc(GL_LEQUAL);
        glStencilFunc(GL_EQUAL, 1, 0xff);
        glStencilOp(GL_KEEP, GL_ZERO, GL_ZERO);
        draw(batch);
    }
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_BLEND);
    glUseProgram(program.name());
    glCullFace(GL_FRONT);
    glDepthFunc(GL_LEQUAL);
    if (kind.unsorted.count > 0) draw(kind.unsorted);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

void LightVolumes::drawBackFaces(const gl::Program& program) const {
    glBindVertexArray(vertexArray_.name());
    glUseProgram(program.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (const Kind* kind : {&points_, &spots_}) {
        if (kind->all.count > 0) draw(kind->all);
    }
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace candela
