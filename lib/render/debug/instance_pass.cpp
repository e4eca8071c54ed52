#include "render/debug/instance_pass.h"

#include "render/gbuffer/readback.h"
#include "render/layout.h"
#include "scene/geometry/topology.h"

#include <array>
#include <string>
#include <vector>

namespace candela {

namespace {

bool isTextured(const PipelineKey& key) {
    return key.program != PipelineKey::Program::plain;
}

gl::Program makeProgram(const PipelineKey& key, InstancePass::Motion motion) {
    std::vector<std::string> definitions{isTextured(key) ? "TEXTURED 1" : "TEXTURED 0"};
    if (motion == InstancePass::Motion::on) definitions.emplace_back("MOTION 1");
    if (key.furtherUvPairs != 0) definitions.push_back(furtherUvDefinition(key));
    std::vector<gl::Stage> stages{{"surface_instance.vert", definitions, {}},
                                  {"surface_instance.frag", definitions, {}}};
    if (key.topology != Topology::triangles) {
        definitions.push_back("WIDE_CORNERS " + std::to_string(cornersOf(key.topology)));
        stages.push_back({"surface_instance.geom", definitions, {}});
    }
    return gl::Program(stages, isTextured(key) ? "textured instances" : "plain instances");
}

}  // namespace

const gl::Program& InstancePass::programOf(const PipelineKey& key, Motion motion) {
    gl::Program& program = programs_[{key.topology, isTextured(key), key.furtherUvPairs, motion}];
    if (program.name() == 0) program = makeProgram(key, motion);
    return program;
}

InstancePass::Targets::Targets(int pixelsWide, int pixelsHigh, Motion motion)
    : width(pixelsWide),
      height(pixelsHigh),
      instances(gl::Texture::target2d(GL_RG32UI, width, height, "instances")),
      depth(gl::Texture::target2d(GL_DEPTH_COMPONENT32F, width, height, "instance depth")) {
    if (motion == Motion::off) {
        framebuffer = gl::Framebuffer({&instances}, &depth, "instances");
    } else {
        previous = gl::Texture::target2d(GL_RGBA32F, width, height, "previous positions");
        framebuffer = gl::Framebuffer({&instances, &previous}, &depth, "previous positions");
    }
}

InstancePass::Targets& InstancePass::prepare(int width, int height, Motion motion) {
    const auto found = targets_.find(motion);
    if (found != targets_.end()) {
        if (found->second.width == width && found->second.height == height) return found->second;
        targets_.erase(found);
    }
    return targets_.try_emplace(motion, width, height, motion).first->second;
}

const gl::Texture& InstancePass::render(const Inputs& inputs) {
    drawBatches(inputs, Motion::off);
    return targets_.at(Motion::off).instances;
}

std::vector<float> InstancePass::readPreviousPositions(const Inputs& inputs) {
    drawBatches(inputs, Motion::on);
    return readColor(targets_.at(Motion::on).previous, inputs.width, inputs.height);
}

std::vector<SurfaceId> InstancePass::read(const Inputs& inputs, const gl::PixelRectangle& rectangle) {
    const auto& [x, y, width, height] = rectangle;
    {
        const gl::Scissor part(rectangle);
        drawBatches(inputs, Motion::off);
    }
    std::vector<SurfaceId> ids(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    static_assert(sizeof(SurfaceId) == 2 * sizeof(GLuint));
    glGetTextureSubImage(targets_.at(Motion::off).instances.name(), 0, x, y, 0, width, height, 1,
                         GL_RG_INTEGER, GL_UNSIGNED_INT, static_cast<GLsizei>(ids.size() * sizeof(SurfaceId)),
                         ids.data());
    return ids;
}

void InstancePass::drawBatches(const Inputs& inputs, Motion motion) {
    const Targets& targets = prepare(inputs.width, inputs.height, motion);
    constexpr std::array<GLuint, 4> none{0, 0, 0, 0};
    constexpr GLfloat farthest = 0.0f;
    const GLuint framebuffer = targets.framebuffer.name();
    glClearNamedFramebufferuiv(framebuffer, GL_COLOR, 0, none.data());
    if (motion == Motion::on) {
        constexpr std::array<GLfloat, 4> nowhere{0.0f, 0.0f, 0.0f, 0.0f};
        glClearNamedFramebufferfv(framebuffer, GL_COLOR, 1, nowhere.data());
    }
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
    if (inputs.drawHostDepth) inputs.drawHostDepth(framebuffer);
    glViewport(0, 0, inputs.width, inputs.height);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    inputs.draws.bind();
    glBindTextureUnit(layout::INSTANCES_UNIT, inputs.scene.instances.records().name());
    glBindTextureUnit(layout::MATERIALS_UNIT, inputs.scene.materials.records().name());
    for (const DrawBatch& batch : inputs.draws.batches()) draw(inputs.scene, batch, motion);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glBindSampler(layout::BASE_COLOR_UNIT, 0);
}

void InstancePass::draw(const GpuScene::State& scene, const DrawBatch& batch, Motion motion) {
    glUseProgram(programOf(batch.key, motion).name());
    glBindVertexArray(scene.vertexArrayOf(batch.key));
    glFrontFace(batch.key.mirrored ? GL_CW : GL_CCW);
    if (batch.key.doubleSided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
    if (isTextured(batch.key)) {
        const SampledTexture& baseColor = batch.key.textures[0];
        glBindTextureUnit(layout::BASE_COLOR_UNIT, baseColor.texture);
        glBindSampler(layout::BASE_COLOR_UNIT, baseColor.sampler);
    }
    DrawSelection::draw(batch);
}

}  // namespace candela
