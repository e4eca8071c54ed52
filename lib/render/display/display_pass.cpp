#include "render/display/display_pass.h"

#include "color/display_shader.h"
#include "render/layout.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace candela {

/// A display transform's shader, linked, with its look-up textures.
struct DisplayPass::DisplayProgram {
    explicit DisplayProgram(const DisplayShader& shader);
    void bind() const;

    gl::Program program;
    std::vector<gl::Texture> textures;
    gl::BufferTexture curves;  ///< Has no name where the shader has no curves.
};

/// The program of a display transform. Transforms that differ in exposure alone share it.
struct DisplayPass::Prepared {
    DisplayTransform transform;  ///< The last one it served; keeps the shader that identifies it alive.
    DisplayProgram program;
    bool isBaked = false;
};

namespace {

bool areEqual(const DisplayShader& a, const DisplayShader& b) {
    const auto sameValues = [](const LookupTexture& left, const LookupTexture& right) {
        return left.values == right.values;
    };
    return a.glsl == b.glsl && std::ranges::equal(a.textures, b.textures, sameValues);
}

gl::Texture makeLookup(const LookupTexture& lookup) {
    const bool rgb = lookup.channels == 3;
    const GLenum internal = rgb ? GL_RGB32F : GL_R32F, format = rgb ? GL_RGB : GL_RED;
    const GLenum target = lookup.dimensions == 1   ? GL_TEXTURE_1D
                          : lookup.dimensions == 2 ? GL_TEXTURE_2D
                                                   : GL_TEXTURE_3D;
    gl::Texture texture(target, lookup.sampler.c_str());
    const GLuint name = texture.name();
    if (target == GL_TEXTURE_1D) {
        glTextureStorage1D(name, 1, internal, lookup.width);
        glTextureSubImage1D(name, 0, 0, lookup.width, format, GL_FLOAT, lookup.values.data());
    } else if (target == GL_TEXTURE_2D) {
        glTextureStorage2D(name, 1, internal, lookup.width, lookup.height);
        glTextureSubImage2D(name, 0, 0, 0, lookup.width, lookup.height, format, GL_FLOAT,
                            lookup.values.data());
    } else {
        glTextureStorage3D(name, 1, internal, lookup.width, lookup.height, lookup.depth);
        glTextureSubImage3D(name, 0, 0, 0, 0, lookup.width, lookup.height, lookup.depth, format, GL_FLOAT,
                            lookup.values.data());
    }
    const GLint filter = lookup.filter == LookupTexture::Filter::nearest ? GL_NEAREST : GL_LINEAR;
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(name, wrap, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

}  // namespace

DisplayPass::DisplayProgram::DisplayProgram(const DisplayShader& shader)
    : program({{"fullscreen_triangle.vert", {}, {}}, {"display.frag", {}, shader.glsl}}, "display") {
    GLint unit = layout::LOOKUP_UNIT;
    const auto setUnit = [&](const std::string& sampler) {
        glProgramUniform1i(program.name(), glGetUniformLocation(program.name(), sampler.c_str()), unit++);
    };
    for (const LookupTexture& lookup : shader.textures) {
        textures.push_back(makeLookup(lookup));
        setUnit(lookup.sampler);
    }
    if (shader.curves.empty()) return;
    curves = gl::BufferTexture(GL_RG32F, "display curves");
    curves.upload(std::span<const float>(shader.curves));
    setUnit("candelaCurves");
}

void DisplayPass::DisplayProgram::bind() const {
    glUseProgram(program.name());
    GLuint unit = layout::LOOKUP_UNIT;
    for (const gl::Texture& texture : textures) glBindTextureUnit(unit++, texture.name());
    // Binding name 0 would unbind textures of every target, also of those that the state guard does not save.
    if (curves.name() != 0) glBindTextureUnit(unit, curves.name());
}

DisplayPass::DisplayPass(Baking baking) : baking_(baking), vertexArray_("display") {}
DisplayPass::~DisplayPass() = default;

const DisplayPass::Prepared* DisplayPass::find(const DisplayTransform& transform) const {
    const auto found = std::ranges::find_if(prepared_, [&](const std::unique_ptr<Prepared>& known) {
        return &known->transform.state() == &transform.state();
    });
    return found == prepared_.end() ? nullptr : found->get();
}

/// Compares tables only for a transform that was not shown before.
const DisplayPass::Prepared& DisplayPass::prepare(const DisplayTransform& transform) {
    if (const Prepared* known = find(transform)) return *known;
    const DisplayShader& exact = displayShader(transform);
    for (const auto& known : prepared_) {
        if (!areEqual(displayShader(known->transform), exact)) continue;
        known->transform = transform;
        return *known;
    }
    const DisplayShader* baked = baking_ == Baking::always ? bakedDisplayShader(transform) : nullptr;
    prepared_.push_back(std::make_unique<Prepared>(
        Prepared{transform, DisplayProgram(baked != nullptr ? *baked : exact), baked != nullptr}));
    return *prepared_.back();
}

void DisplayPass::render(const Inputs& inputs) {
    prepare(inputs.transform).program.bind();
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, inputs.target.framebuffer);
    glViewport(inputs.target.x, inputs.target.y, inputs.width, inputs.height);
    glBindTextureUnit(layout::RADIANCE_UNIT, inputs.radiance.name());
    glUniform1f(layout::EXPOSURE_LOCATION,
                static_cast<float>(std::exp2(inputs.transform.options().exposure)));
    glUniform2i(layout::ORIGIN_LOCATION, inputs.target.x, inputs.target.y);
    glUniform2i(layout::PLACE_LOCATION, inputs.place.x, inputs.place.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool DisplayPass::isBaked(const DisplayTransform& transform) const {
    const Prepared* prepared = find(transform);
    return prepared != nullptr && prepared->isBaked;
}

}  // namespace candela
