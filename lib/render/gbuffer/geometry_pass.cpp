#include "render/gbuffer/geometry_pass.h"

#include "render/layout.h"

#include <array>

namespace candela {

namespace {

constexpr std::array textureUnits{layout::BASE_COLOR_UNIT, layout::METALLIC_ROUGHNESS_UNIT,
                                  layout::NORMAL_UNIT, layout::EMISSION_UNIT, layout::OCCLUSION_TEXTURE_UNIT};

void clear(const GBufferTargets& targets, LoadOp radianceLoad) {
    constexpr std::array<GLuint, 4> nothing{0, 0, 0, 0};
    constexpr std::array<GLfloat, 4> black{0.0f, 0.0f, 0.0f, 0.0f};
    constexpr GLfloat farthest = 0.0f;
    for (const GBufferWordTexture& words : targets.layout) {
        if (words.readType == GL_UNSIGNED_INT) {
            glClearNamedFramebufferuiv(targets.surfaces.name(), GL_COLOR, words.output, nothing.data());
        } else {
            glClearNamedFramebufferfv(targets.surfaces.name(), GL_COLOR, words.output, black.data());
        }
    }
    glClearNamedFramebufferfv(targets.surfaces.name(), GL_DEPTH, 0, &farthest);
    if (radianceLoad == LoadOp::clear)
        glClearNamedFramebufferfv(targets.lit.name(), GL_COLOR, 0, black.data());
}

}  // namespace

GeometryPass::Programs::Programs(const std::vector<std::string>& definitions)
    : plain({{"surface_plain.vert", definitions, {}}, {"surface_plain.frag", definitions, {}}},
            "plain surfaces"),
      textured({{"surface_textured.vert", definitions, {}}, {"surface_textured.frag", definitions, {}}},
               "textured surfaces") {}

GeometryPass::GeometryPass() {
    programs_.try_emplace(GBufferParts{}, definitionsOf({}));
}

const GeometryPass::Programs& GeometryPass::programsFor(const GBufferTargets& targets) {
    const auto found = programs_.find(targets.parts);
    if (found != programs_.end()) return found->second;
    return programs_.try_emplace(targets.parts, definitionsOf(targets.parts)).first->second;
}

void GeometryPass::render(const Inputs& inputs) {
    const Programs& programs = programsFor(inputs.targets);
    clear(inputs.targets, inputs.draws.emits() ? LoadOp::clear : inputs.radianceLoad);
    glViewport(0, 0, inputs.targets.width, inputs.targets.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    inputs.draws.bind();
    glBindTextureUnit(layout::INSTANCES_UNIT, inputs.scene.instances.records().name());
    glBindTextureUnit(layout::MATERIALS_UNIT, inputs.scene.materials.records().name());
    // Emissive batches come last: otherwise, surfaces in front of emission would have to write black over it.
    for (const DrawBatch& batch : inputs.draws.batches()) {
        const gl::Framebuffer& target =
            batch.key.emissive ? inputs.targets.surfacesAndEmission : inputs.targets.surfaces;
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
        glBindVertexArray(inputs.scene.vertexArrayOf(batch));
        draw(batch, programs);
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glBindSamplers(layout::BASE_COLOR_UNIT, textureUnits.size(), nullptr);
}

void GeometryPass::draw(const DrawBatch& batch, const Programs& programs) {
    const bool textured = batch.key.program == PipelineKey::Program::textured;
    glUseProgram(textured ? programs.textured.name() : programs.plain.name());
    glFrontFace(batch.key.mirrored ? GL_CW : GL_CCW);
    if (batch.key.doubleSided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
    if (textured) {
        for (std::size_t i = 0; i < textureUnits.size(); ++i) {
            // A unit that the program does not read keeps what the host has bound to it.
            if (batch.key.textures[i].texture == 0) continue;
            glBindTextureUnit(static_cast<GLuint>(textureUnits[i]), batch.key.textures[i].texture);
            glBindSampler(static_cast<GLuint>(textureUnits[i]), batch.key.textures[i].sampler);
        }
    }
    DrawSelection::draw(batch);
}

}  // namespace candela
