#include "render/gbuffer/geometry_pass.h"

#include "render/culling/triangle_filter.h"
#include "render/layout.h"
#include "scene/geometry/topology.h"

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

}  // namespace

GeometryPass::Programs::Programs(const GBufferParts& parts)
    : plain_(make(PipelineKey{}, parts)),
      textured_(make(PipelineKey{.program = PipelineKey::Program::textured}, parts)),
      parts_(parts) {
    if (parts.lobes) extended_ = make(PipelineKey{.program = PipelineKey::Program::extended}, parts);
}

const gl::Program& GeometryPass::Programs::of(const PipelineKey& key) {
    PipelineKey::Program kind = key.program;
    if (kind == PipelineKey::Program::extended && !extended_) kind = PipelineKey::Program::textured;
    if (key.topology != Topology::triangles || key.furtherUvPairs != 0) {
        gl::Program& program = special_[{key.topology, kind, key.unlit, key.furtherUvPairs}];
        if (program.name() == 0) {
            PipelineKey own = key;
            own.program = kind;
            program = make(own, parts_);
        }
        return program;
    }
    if (kind == PipelineKey::Program::extended) return *extended_;
    return kind == PipelineKey::Program::textured ? textured_ : plain_;
}

gl::Program GeometryPass::Programs::make(const PipelineKey& key, const GBufferParts& parts) {
    const bool isPlain = key.program == PipelineKey::Program::plain;
    std::vector<std::string> definitions = definitionsOf(parts);
    if (key.program == PipelineKey::Program::extended) definitions.emplace_back("EXTENDED 1");
    if (key.unlit) definitions.emplace_back("WITHOUT_NORMALS 1");
    if (key.furtherUvPairs != 0) definitions.push_back(furtherUvDefinition(key));
    const std::string file = isPlain ? "surface_plain" : "surface_textured";
    std::vector<gl::Stage> stages{{file + ".vert", definitions, {}}, {file + ".frag", definitions, {}}};
    if (key.topology != Topology::triangles) {
        definitions.push_back("WIDE_CORNERS " + std::to_string(cornersOf(key.topology)));
        stages.push_back({file + ".geom", definitions, {}});
    }
    return gl::Program(stages, isPlain ? "plain surfaces" : "textured surfaces");
}

GeometryPass::GeometryPass() {
    programs_.try_emplace(GBufferParts{}, GBufferParts{});
}

GeometryPass::Programs& GeometryPass::programsFor(const GBufferTargets& targets) {
    const auto found = programs_.find(targets.parts);
    if (found != programs_.end()) return found->second;
    return programs_.try_emplace(targets.parts, targets.parts).first->second;
}

void GeometryPass::render(const Inputs& inputs) {
    inputs.targets.clearSurfaces();
    const HostSurfaceDraws* host = inputs.host;
    if (inputs.radianceLoad == LoadOp::clear || inputs.draws.emits(inputs.surfaces) || host != nullptr)
        inputs.targets.clearRadiance();
    if (host != nullptr && host->depth) host->depth(inputs.targets.surfaces.name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    drawSurfaces(inputs, DepthTies::none);
    if (host != nullptr && host->radiance) host->radiance(inputs.targets);
    glDisable(GL_DEPTH_TEST);
}

void GeometryPass::renderLayer(const Inputs& inputs, DepthTies ties) {
    if (inputs.radianceLoad == LoadOp::clear || inputs.draws.emits(inputs.surfaces))
        inputs.targets.clearRadiance();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    drawSurfaces(inputs, ties);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

void GeometryPass::recordFragments(const Inputs& inputs) {
    drawFragments(inputs, FragmentUse::record, GL_GREATER, 0);
}

void GeometryPass::findLayers(const Inputs& inputs, std::uint32_t firstNumber) {
    drawFragments(inputs, FragmentUse::findLayers, GL_GREATER, firstNumber);
}

void GeometryPass::numberSurfaces(const Inputs& inputs, std::uint32_t index) {
    drawFragments(inputs, FragmentUse::number, GL_EQUAL, index);
}

const gl::Program& GeometryPass::fragmentProgram(const PipelineKey& key, FragmentUse use) {
    gl::Program& program = fragmentPrograms_[{key.topology, key.furtherUvPairs, use}];
    if (program.name() != 0) return program;
    std::vector<std::string> definitions{"USE " + std::to_string(static_cast<int>(use))};
    if (key.furtherUvPairs != 0) definitions.push_back(furtherUvDefinition(key));
    std::vector<gl::Stage> stages{{"layer_fragment.vert", definitions, {}},
                                  {"layer_fragment.frag", definitions, {}}};
    if (key.topology != Topology::triangles) {
        definitions.push_back("WIDE_CORNERS " + std::to_string(cornersOf(key.topology)));
        stages.push_back({"layer_fragment.geom", definitions, {}});
    }
    program = gl::Program(stages, "fragments of layers");
    return program;
}

void GeometryPass::drawFragments(const Inputs& inputs, FragmentUse use, GLenum depthFunction,
                                 std::uint32_t value) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, inputs.targets.surfaces.name());
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(depthFunction);
    glEnable(GL_DEPTH_TEST);
    drawBatches(inputs, [&](const PipelineKey& key) {
        const gl::Program& program = fragmentProgram(key, use);
        glUseProgram(program.name());
        if (use != FragmentUse::record)
            glProgramUniform1i(program.name(), layout::LAYER_LOCATION, static_cast<GLint>(value));
        bind(layout::BASE_COLOR_UNIT, key.textures[0]);
    });
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GeometryPass::drawSurfaces(const Inputs& inputs, DepthTies ties) {
    Programs& programs = programsFor(inputs.targets);
    if (inputs.targets.parts.lobes)
        glBindTextureUnit(layout::LOBE_RECORDS_UNIT, inputs.scene.materials.lobeRecords().name());
    const bool isLayer = inputs.targets.parts.layer;
    drawBatches(inputs, [&](const PipelineKey& key) {
        const gl::Program& program = select(inputs, key, programs);
        // Transparent surfaces are never drawn by the program of plain ones.
        if (isLayer)
            glProgramUniform1i(program.name(), layout::LAYER_LOCATION, ties == DepthTies::numbered ? 1 : 0);
    });
    if (programs.hasLobes()) glBindSamplers(layout::LOBE_TEXTURES_UNIT, layout::LOBE_TEXTURE_COUNT, nullptr);
}

template <typename Select>
void GeometryPass::drawBatches(const Inputs& inputs, const Select& select) {
    glViewport(0, 0, inputs.targets.width, inputs.targets.height);
    glBindTextureUnit(layout::INSTANCES_UNIT, inputs.scene.instances.records().name());
    glBindTextureUnit(layout::MATERIALS_UNIT, inputs.scene.materials.records().name());
    // Emissive batches come last: otherwise, surfaces in front of emission would have to write black over it.
    if (inputs.runs != nullptr || inputs.filter != nullptr) {
        drawRuns(inputs, select);
    } else {
        inputs.draws.bind();
        for (const DrawBatch& batch : inputs.draws.batches()) {
            if (!batch.key.isIn(inputs.surfaces)) continue;
            select(batch.key);
            cull(batch.key);
            glBindVertexArray(inputs.scene.vertexArrayOf(batch.key));
            DrawSelection::draw(batch);
        }
    }
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glBindSamplers(layout::BASE_COLOR_UNIT, textureUnits.size(), nullptr);
}

template <typename Select>
void GeometryPass::drawRuns(const Inputs& inputs, const Select& select) {
    std::span<const TriangleFilter::Run> runs;
    if (inputs.runs != nullptr) {
        runs = inputs.runs->runs;
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, inputs.runs->commandBuffer);
    } else {
        runs = inputs.filter->runs();
        inputs.filter->bind();
    }
    for (const TriangleFilter::Run& run : runs) {
        if (!run.key.isIn(inputs.surfaces)) continue;
        select(run.key);
        cull(run.key);
        glBindVertexArray(run.filtered ? inputs.filter->vertexArray() : inputs.scene.vertexArrayOf(run.key));
        TriangleFilter::draw(run);
    }
}

void GeometryPass::cull(const PipelineKey& key) {
    glFrontFace(key.mirrored ? GL_CW : GL_CCW);
    if (key.doubleSided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
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

const gl::Program& GeometryPass::select(const Inputs& inputs, const PipelineKey& key, Programs& programs) {
    const gl::Framebuffer& target =
        key.emissive ? inputs.targets.surfacesAndEmission : inputs.targets.surfaces;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
    const bool textured = key.program != PipelineKey::Program::plain;
    const bool extended = key.program == PipelineKey::Program::extended && programs.hasLobes();
    const gl::Program& program = programs.of(key);
    glUseProgram(program.name());
    if (textured) bindTextures(key);
    if (extended) bindLobeTextures(inputs.scene, key);
    return program;
}

}  // namespace candela
