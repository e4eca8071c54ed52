#include "render/display_pass.h"

#include "color/display_shader.h"
#include "render/layout.h"

#include <cmath>

namespace candela {

/// A display transform's program and look-up textures.
struct DisplayPass::Prepared {
    std::string glsl;
    std::vector<std::vector<float>> lookups;  ///< The values the textures were made of.
    gl::Program program;
    std::vector<gl::Texture> textures;
};

namespace {

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

DisplayPass::DisplayPass() : vertexArray_("display") {}
DisplayPass::~DisplayPass() = default;

const DisplayPass::Prepared& DisplayPass::prepare(const DisplayTransform& transform) {
    const DisplayShader& shader = displayShader(transform);
    const auto serves = [&](const Prepared& known) {
        if (known.glsl != shader.glsl || known.lookups.size() != shader.textures.size()) return false;
        for (std::size_t i = 0; i < known.lookups.size(); ++i) {
            if (known.lookups[i] != shader.textures[i].values) return false;
        }
        return true;
    };
    for (const auto& known : prepared_) {
        if (serves(*known)) return *known;
    }
    auto made = std::make_unique<Prepared>();
    made->glsl = shader.glsl;
    made->program =
        gl::Program({{"fullscreen_triangle.vert", {}, {}}, {"display.frag", {}, shader.glsl}}, "display");
    for (std::size_t i = 0; i < shader.textures.size(); ++i) {
        const LookupTexture& lookup = shader.textures[i];
        made->lookups.push_back(lookup.values);
        made->textures.push_back(makeLookup(lookup));
        const GLint location = glGetUniformLocation(made->program.name(), lookup.sampler.c_str());
        glProgramUniform1i(made->program.name(), location, layout::LOOKUP_UNIT + static_cast<GLint>(i));
    }
    prepared_.push_back(std::move(made));
    return *prepared_.back();
}

void DisplayPass::render(const Inputs& inputs) {
    const Prepared& prepared = prepare(inputs.transform);
    glUseProgram(prepared.program.name());
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, inputs.target.framebuffer);
    glViewport(inputs.target.x, inputs.target.y, inputs.width, inputs.height);
    glBindTextureUnit(layout::RADIANCE_UNIT, inputs.radiance.name());
    for (std::size_t i = 0; i < prepared.textures.size(); ++i) {
        glBindTextureUnit(layout::LOOKUP_UNIT + static_cast<GLuint>(i), prepared.textures[i].name());
    }
    glUniform1f(layout::EXPOSURE_LOCATION, static_cast<float>(std::exp2(inputs.transform.choice().exposure)));
    glUniform2i(layout::ORIGIN_LOCATION, inputs.target.x, inputs.target.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace candela
