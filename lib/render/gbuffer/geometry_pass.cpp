#include "render/gbuffer/geometry_pass.h"

#include "render/culling/triangle_filter.h"
#include "render/layout.h"

#include <array>
#include <string>
#include <vector>

namespace candela {

namespace {

constexpr std::array textureUnits{layout::BASE_COLOR_UNIT, layout::METALLIC_ROUGHNESS_UNIT,
                                  layout::NORMAL_UNIT, layout::EMISSION_UNIT, layout::OCCLUSION_TEXTURE_UNIT};

void bind(int unit, const SampledTexture& texture) {
    glBindTextureUnit(static_cast<GLuint>(unit), texture.texture);
    glBindSampler(static_cast<GLuint>(unit), texture.sampler);
}

void setLayer(const gl::Program& program, const LayerDepths& layer) {
    glProgramUniform1i(program.name(), layout::LAYER_LOCATION, layer.before == nullptr ? 0 : 1);
}

void bindDepths(const LayerDepths& layer) {
    glBindTextureUnit(layout::OPAQUE_DEPTH_UNIT, layer.opaque.name());
    if (layer.before != nullptr) glBindTextureUnit(layout::LAYER_BEFORE_UNIT, layer.before->name());
}

}  // namespace

GeometryPass::Programs::Programs(const GBufferParts& parts) {
    std::vector<std::string> definitions = definitionsOf(parts);
    const auto program = [&](const char* vertex, const char* fragment, const char* label) {
        return gl::Program({{vertex, definitions, {}}, {fragment, definitions, {}}}, label);
    };
    plain = program("surface_plain.vert", "surface_plain.frag", "plain surfaces");
    textured = program("surface_textured.vert", "surface_textured.frag", "textured surfaces");
    if (!parts.lobes) return;
    definitions.emplace_back("EXTENDED 1");
    extended = program("surface_textured.vert", "surface_textured.frag", "surfaces with more lobes");
}

GeometryPass::GeometryPass() {
    programs_.try_emplace(GBufferParts{}, GBufferParts{});
}

const GeometryPass::Programs& GeometryPass::programsFor(const GBufferTargets& targets) {
    const auto found = programs_.find(targets.parts);
    if (found != programs_.end()) return found->second;
    return programs_.try_emplace(targets.parts, targets.parts).first->second;
}

void GeometryPass::render(const Inputs& inputs) {
    inputs.targets.clearSurfaces();
    if (inputs.radianceLoad == LoadOp::clear || inputs.draws.emits(inputs.surfaces))
        inputs.targets.clearRadiance();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    drawBatches(inputs);
    glDisable(GL_DEPTH_TEST);
}

void GeometryPass::drawFragments(const Inputs& inputs) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawBatches(inputs);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GeometryPass::drawBatches(const Inputs& inputs) {
    const Programs& programs = programsFor(inputs.targets);
    if (inputs.layer != nullptr) {
        // Transparent surfaces are never drawn by the program of plain ones.
        setLayer(programs.textured, *inputs.layer);
        if (programs.extended) setLayer(*programs.extended, *inputs.layer);
        bindDepths(*inputs.layer);
    }
    glViewport(0, 0, inputs.targets.width, inputs.targets.height);
    glBindTextureUnit(layout::INSTANCES_UNIT, inputs.scene.instances.records().name());
    glBindTextureUnit(layout::MATERIALS_UNIT, inputs.scene.materials.records().name());
    if (inputs.targets.parts.lobes)
        glBindTextureUnit(layout::LOBE_RECORDS_UNIT, inputs.scene.materials.lobeRecords().name());
    // Emissive batches come last: otherwise, surfaces in front of emission would have to write black over it.
    if (inputs.filter != nullptr) {
        inputs.filter->bind();
        for (const TriangleFilter::Run& run : inputs.filter->runs()) {
            if (!run.key.isIn(inputs.surfaces)) continue;
            select(inputs, run.key, programs);
            glBindVertexArray(run.filtered ? inputs.filter->vertexArray()
                                           : inputs.scene.vertexArrayOf(run.key.geometry));
            TriangleFilter::draw(run);
        }
    } else {
        inputs.draws.bind();
        for (const DrawBatch& batch : inputs.draws.batches()) {
            if (!batch.key.isIn(inputs.surfaces)) continue;
            select(inputs, batch.key, programs);
            glBindVertexArray(inputs.scene.vertexArrayOf(batch.key.geometry));
            DrawSelection::draw(batch);
        }
    }
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glBindSamplers(layout::BASE_COLOR_UNIT, textureUnits.size(), nullptr);
    if (programs.extended) glBindSamplers(layout::LOBE_TEXTURES_UNIT, layout::LOBE_TEXTURE_COUNT, nullptr);
}

void GeometryPass::bindTextures(const PipelineKey& key) {
    for (std::size_t i = 0; i < textureUnits.size(); ++i) {
        // A unit that the program does not read keeps what the host has bound to it.
        if (key.textures[i].texture != 0) bind(textureUnits[i], key.textures[i]);
    }
}

void GeometryPass::bindLobeTextures(const GpuScene::State& scene, const PipelineKey& key) {
    const LobeTextures& textures = scene.draws.lobeTextures(key);
    for (std::size_t i = 0; i < textures.size(); ++i)
        bind(layout::LOBE_TEXTURES_UNIT + static_cast<int>(i), textures[i]);
}

void GeometryPass::select(const Inputs& inputs, const PipelineKey& key, const Programs& programs) {
    const gl::Framebuffer& target =
        key.emissive ? inputs.targets.surfacesAndEmission : inputs.targets.surfaces;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
    const bool textured = key.program != PipelineKey::Program::plain;
    const bool extended = key.program == PipelineKey::Program::extended && programs.extended;
    glUseProgram((extended ? *programs.extended : textured ? programs.textured : programs.plain).name());
    glFrontFace(key.mirrored ? GL_CW : GL_CCW);
    if (key.doubleSided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
    if (textured) bindTextures(key);
    if (extended) bindLobeTextures(inputs.scene, key);
}

}  // namespace candela
