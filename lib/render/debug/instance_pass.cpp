#include "render/debug/instance_pass.h"

#include "render/layout.h"
#include "scene/geometry/topology.h"

#include <array>
#include <string>
#include <vector>

namespace candela {

namespace {

gl::Program makeProgram(const char* textured, const char* label) {
    return gl::Program({{"surface_instance.vert", {textured}, {}}, {"surface_instance.frag", {textured}, {}}},
                       label);
}

}  // namespace

const gl::Program& InstancePass::Programs::of(const PipelineKey& key) {
    const bool isTextured = key.program != PipelineKey::Program::plain;
    const bool isWide = key.topology != Topology::triangles;
    if (!isWide && key.furtherUvPairs == 0) return isTextured ? textured : plain;
    gl::Program& program = special[{key.topology, key.program, key.furtherUvPairs}];
    if (program.name() != 0) return program;
    std::vector<std::string> definitions{isTextured ? "TEXTURED 1" : "TEXTURED 0"};
    if (key.furtherUvPairs != 0) definitions.push_back(furtherUvDefinition(key));
    std::vector<gl::Stage> stages{{"surface_instance.vert", definitions, {}},
                                  {"surface_instance.frag", definitions, {}}};
    if (isWide) {
        definitions.push_back("WIDE_CORNERS " + std::to_string(cornersOf(key.topology)));
        stages.push_back({"surface_instance.geom", definitions, {}});
    }
    program = gl::Program(stages, "instances of lines, points and further texture coordinates");
    return program;
}

InstancePass::Targets::Targets(int pixelsWide, int pixelsHigh)
    : width(pixelsWide),
      height(pixelsHigh),
      instances(gl::Texture::target2d(GL_RG32UI, width, height, "instances")),
      depth(gl::Texture::target2d(GL_DEPTH_COMPONENT32F, width, height, "instance depth")),
      framebuffer({&instances}, &depth, "instances") {}

void InstancePass::prepare(int width, int height) {
    if (!programs_) {
        programs_.emplace(Programs{makeProgram("TEXTURED 0", "plain instances"),
                                   makeProgram("TEXTURED 1", "textured instances"),
                                   {}});
    }
    const bool fits = targets_ && targets_->width == width && targets_->height == height;
    if (!fits) targets_.emplace(width, height);
}

const gl::Texture& InstancePass::render(const Inputs& inputs) {
    drawBatches(inputs);
    return targets_->instances;
}

std::vector<SurfaceId> InstancePass::read(const Inputs& inputs, const gl::PixelRectangle& rectangle) {
    const auto& [x, y, width, height] = rectangle;
    {
        const gl::Scissor part(rectangle);
        drawBatches(inputs);
    }
    std::vector<SurfaceId> ids(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    static_assert(sizeof(SurfaceId) == 2 * sizeof(GLuint));
    glGetTextureSubImage(targets_->instances.name(), 0, x, y, 0, width, height, 1, GL_RG_INTEGER,
                         GL_UNSIGNED_INT, static_cast<GLsizei>(ids.size() * sizeof(SurfaceId)), ids.data());
    return ids;
}

void InstancePass::drawBatches(const Inputs& inputs) {
    prepare(inputs.width, inputs.height);
    constexpr std::array<GLuint, 4> none{0, 0, 0, 0};
    constexpr GLfloat farthest = 0.0f;
    const GLuint framebuffer = targets_->framebuffer.name();
    glClearNamedFramebufferuiv(framebuffer, GL_COLOR, 0, none.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
    if (inputs.drawHostDepth) inputs.drawHostDepth(framebuffer);
    glViewport(0, 0, inputs.width, inputs.height);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    inputs.draws.bind();
    glBindTextureUnit(layout::INSTANCES_UNIT, inputs.scene.instances.records().name());
    glBindTextureUnit(layout::MATERIALS_UNIT, inputs.scene.materials.records().name());
    for (const DrawBatch& batch : inputs.draws.batches()) draw(inputs.scene, batch);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glBindSampler(layout::BASE_COLOR_UNIT, 0);
}

void InstancePass::draw(const GpuScene::State& scene, const DrawBatch& batch) {
    const bool textured = batch.key.program != PipelineKey::Program::plain;
    glUseProgram(programs_->of(batch.key).name());
    glBindVertexArray(scene.vertexArrayOf(batch.key));
    glFrontFace(batch.key.mirrored ? GL_CW : GL_CCW);
    if (batch.key.doubleSided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
    if (textured) {
        const SampledTexture& baseColor = batch.key.textures[0];
        glBindTextureUnit(layout::BASE_COLOR_UNIT, baseColor.texture);
        glBindSampler(layout::BASE_COLOR_UNIT, baseColor.sampler);
    }
    DrawSelection::draw(batch);
}

}  // namespace candela
