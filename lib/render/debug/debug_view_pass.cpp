#include "render/debug/debug_view_pass.h"

#include "render/layout.h"

#include <candela/error.h>

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace candela {

namespace {

/// The heat map blends between these, in equal steps from 0 to 1. Code values.
constexpr std::array<glm::vec3, 5> heatStops{glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, 1.0f),
                                             glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(1.0f, 1.0f, 0.0f),
                                             glm::vec3(1.0f, 0.0f, 0.0f)};

/// The colours of subdivision levels: grey-blue for polygons, then hues that differ clearly from level to
/// level.
constexpr std::array<glm::vec3, maxSubdivisionLevel + 1> levelColors{
    glm::vec3(0.35f, 0.40f, 0.50f), glm::vec3(0.20f, 0.30f, 0.95f), glm::vec3(0.10f, 0.70f, 0.95f),
    glm::vec3(0.10f, 0.80f, 0.55f), glm::vec3(0.35f, 0.80f, 0.10f), glm::vec3(0.90f, 0.85f, 0.10f),
    glm::vec3(0.95f, 0.50f, 0.10f), glm::vec3(0.90f, 0.15f, 0.15f), glm::vec3(0.85f, 0.15f, 0.80f)};

/// Meshes in the view of levels.
constexpr glm::vec3 meshColor(0.5f);

constexpr int reductionGroup = 16;  ///< Pixels along each axis of a work group of max_reduction.comp.

GLuint reductionGroups(int pixels) {
    return static_cast<GLuint>((pixels + reductionGroup - 1) / reductionGroup);
}

/// The definition that selects the source in shaders/debug_view.frag.
const char* sourceDefinition(ChannelSource source) {
    switch (source) {
        case ChannelSource::depth:
            return "SOURCE SOURCE_DEPTH";
        case ChannelSource::surface:
            return "SOURCE SOURCE_SURFACE";
        case ChannelSource::emission:
            return "SOURCE SOURCE_EMISSION";
        case ChannelSource::lightCount:
        case ChannelSource::shadowedCount:
            return "SOURCE SOURCE_COUNT";
        default:
            return "SOURCE SOURCE_INSTANCE";
    }
}

bool showsCounts(const DebugViewRow& row) {
    return row.source == ChannelSource::lightCount || row.source == ChannelSource::shadowedCount;
}

gl::Program makeProgram(const DebugViewRow& row) {
    gl::Program program(
        {{"fullscreen_triangle.vert", {}, {}}, {"debug_view.frag", debugViewDefinitions(row), {}}}, row.name);
    if (showsCounts(row)) {
        glProgramUniform3fv(program.name(), layout::HEAT_STOPS_LOCATION,
                            static_cast<GLsizei>(heatStops.size()), glm::value_ptr(heatStops[0]));
    }
    return program;
}

}  // namespace

glm::vec3 levelColor(std::uint32_t level) {
    if (level < levelColors.size()) return levelColors[level];
    throw Error(ErrorKind::badInput, "",
                "the colour of subdivision level " + std::to_string(level) +
                    " is asked for; levels are 0 to " + std::to_string(maxSubdivisionLevel));
}

glm::vec3 heatColor(float value) {
    constexpr std::size_t steps = heatStops.size() - 1;
    // Written so that NaN becomes 0.
    const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
    const float position = clamped * static_cast<float>(steps);
    const std::size_t step = std::min(static_cast<std::size_t>(position), steps - 1);
    return glm::mix(heatStops[step], heatStops[step + 1], position - static_cast<float>(step));
}

std::vector<std::string> debugViewDefinitions(const DebugViewRow& row) {
    return {sourceDefinition(row.source), std::string("VIEW_CODE ") + row.code,
            "HEAT_STOPS " + std::to_string(heatStops.size())};
}

MaxReduction::MaxReduction()
    : program_({{"max_reduction.comp", {}, {}}}, "max reduction"),
      buffer_("max reduction", gl::BufferUsage::device) {}

void MaxReduction::reduce(const gl::Texture& texture, int width, int height) {
    constexpr float zero = 0.0f;
    buffer_.upload(std::span<const float>(&zero, 1));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::MAX_REDUCTION_STORAGE, buffer_.name());
    glBindTextureUnit(layout::VIEW_UNIT, texture.name());
    glUseProgram(program_.name());
    glDispatchCompute(reductionGroups(width), reductionGroups(height), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

float MaxReduction::value() const {
    float value = 0.0f;
    glGetNamedBufferSubData(buffer_.name(), 0, sizeof value, &value);
    return value;
}

DebugViewPass::DebugViewPass()
    : display_({{"fullscreen_triangle.vert", {}, {}}, {"debug_view_display.frag", {}, {}}},
               "debug view display"),
      vertexArray_("debug view"),
      instanceColors_(GL_RGBA32F, "instance colors") {}

const gl::Program& DebugViewPass::program(DebugView view) {
    auto found = programs_.find(view);
    if (found == programs_.end()) found = programs_.emplace(view, makeProgram(debugViewRow(view))).first;
    return found->second;
}

void DebugViewPass::uploadLevelColors(const GpuScene::State& scene) {
    std::vector<glm::vec4> colors;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const std::optional<std::uint32_t> level = scene.levelOf(i);
        colors.emplace_back(level ? levelColor(*level) : meshColor, 0.0f);
    }
    instanceColors_.upload(std::span<const glm::vec4>(colors));
}

/// The view is written to the radiance target, which holds the emission: reading the target that is drawn to
/// is left to a copy.
void DebugViewPass::copyEmission(const GBufferTargets& targets) {
    if (emissionSize_ != glm::ivec2(targets.width, targets.height)) {
        emission_ = gl::Texture::target2d(GL_RGBA32F, targets.width, targets.height, "debug view emission");
        emissionSize_ = {targets.width, targets.height};
    }
    glCopyImageSubData(targets.radiance.name(), GL_TEXTURE_2D, 0, 0, 0, 0, emission_.name(), GL_TEXTURE_2D, 0,
                       0, 0, 0, targets.width, targets.height, 1);
}

void DebugViewPass::uploadShadowedCounts(const Inputs& inputs) {
    const GBufferTargets& targets = inputs.frame.targets;
    const std::vector<float> counts = inputs.lighting.shadowedPerPixel(inputs.frame);
    shadowedCounts_ = gl::Texture::target2d(GL_R32F, targets.width, targets.height, "shadowed counts");
    glTextureSubImage2D(shadowedCounts_.name(), 0, 0, 0, targets.width, targets.height, GL_RED, GL_FLOAT,
                        counts.data());
}

/// Draws what the view shows besides the G-buffer. Null where the G-buffer has it.
const gl::Texture* DebugViewPass::drawSource(const Inputs& inputs, ChannelSource source) {
    const GBufferTargets& targets = inputs.frame.targets;
    switch (source) {
        case ChannelSource::emission:
            copyEmission(targets);
            return &emission_;
        case ChannelSource::lightCount:
            return &inputs.lighting.counter().drawLit(inputs.frame);
        case ChannelSource::shadowedCount:
            uploadShadowedCounts(inputs);
            return &shadowedCounts_;
        case ChannelSource::instance:
            uploadLevelColors(inputs.scene);
            return &inputs.instances.render(
                {inputs.scene, inputs.draws, targets.width, targets.height, inputs.drawHostDepth});
        default:
            return nullptr;
    }
}

void DebugViewPass::render(const Inputs& inputs) {
    const GBufferTargets& targets = inputs.frame.targets;
    const DebugViewRow& row = debugViewRow(inputs.view);
    const gl::Texture* source = drawSource(inputs, row.source);
    if (row.scale == DebugViewRow::Scale::maximum)
        maximum_.reduce(source != nullptr ? *source : targets.depth, targets.width, targets.height);
    targets.bind();
    if (source != nullptr) glBindTextureUnit(layout::VIEW_UNIT, source->name());
    if (row.source == ChannelSource::instance)
        glBindTextureUnit(layout::INSTANCE_COLORS_UNIT, instanceColors_.name());
    glUseProgram(program(inputs.view).name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.lit.name());
    glViewport(0, 0, targets.width, targets.height);
    drawTriangle();
}

std::uint32_t DebugViewPass::maxLightCount() const {
    return static_cast<std::uint32_t>(maximum_.value());
}

void DebugViewPass::display(const GBufferTargets& targets, const FrameTarget& target) const {
    glUseProgram(display_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    glViewport(target.x, target.y, targets.width, targets.height);
    glBindTextureUnit(layout::RADIANCE_UNIT, targets.radiance.name());
    glUniform2i(layout::ORIGIN_LOCATION, target.x, target.y);
    drawTriangle();
}

void DebugViewPass::drawTriangle() const {
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace candela
