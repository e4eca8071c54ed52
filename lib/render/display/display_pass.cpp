#include "render/display/display_pass.h"

#include "color/display_shader.h"
#include "gl/framebuffer.h"
#include "render/layout.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

namespace candela {

/// One form of a display transform, ready to draw.
struct DisplayPass::DisplayProgram {
    explicit DisplayProgram(const DisplayShader& shader);
    void bind() const;

    gl::Program program;
    std::vector<gl::Texture> textures;
    gl::BufferTexture curves;  ///< Nothing for an exact transform.
};

/// A display transform that was shown.
struct DisplayPass::Prepared {
    explicit Prepared(const DisplayShader& shader) : exactGlsl(shader.glsl), program(shader) {
        for (const LookupTexture& lookup : shader.textures) exactLookups.push_back(lookup.values);
    }
    bool serves(const DisplayShader& shader) const {
        const auto same = [](const std::vector<float>& values, const LookupTexture& lookup) {
            return values == lookup.values;
        };
        return exactGlsl == shader.glsl && std::ranges::equal(exactLookups, shader.textures, same);
    }

    // The exact shader, which tells transforms apart.
    std::string exactGlsl;
    std::vector<std::vector<float>> exactLookups;

    DisplayProgram program;
    bool isBaked = false;
};

namespace {

/// Exactness is given up only where a quarter of the time or more is won.
constexpr double maxShareOfTime = 0.75;

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

/// Seconds that `draw` takes, from start to end.
template <typename Draw>
double secondsOf(const Draw& draw) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    draw();
    glFinish();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
    // Name 0 would unbind every kind of texture, more than the state guard keeps.
    if (curves.name() != 0) glBindTextureUnit(unit, curves.name());
}

DisplayPass::DisplayPass(Baking baking) : baking_(baking), vertexArray_("display") {}
DisplayPass::~DisplayPass() = default;

DisplayPass::Prepared* DisplayPass::find(const DisplayTransform& transform) const {
    const DisplayShader& shader = displayShader(transform);
    for (const auto& known : prepared_) {
        if (known->serves(shader)) return known.get();
    }
    return nullptr;
}

DisplayPass::Prepared& DisplayPass::prepare(const Inputs& inputs) {
    if (Prepared* known = find(inputs.transform)) return *known;
    prepared_.push_back(std::make_unique<Prepared>(displayShader(inputs.transform)));
    if (baking_ != Baking::never) bake(*prepared_.back(), inputs);
    return *prepared_.back();
}

void DisplayPass::bake(Prepared& prepared, const Inputs& inputs) {
    const DisplayShader* shader = bakedDisplayShader(inputs.transform);
    if (shader == nullptr) return;
    DisplayProgram baked(*shader);
    if (baking_ == Baking::whereFaster && !isWorthIt(prepared.program, baked, inputs)) return;
    prepared.program = std::move(baked);
    prepared.isBaked = true;
}

bool DisplayPass::isWorthIt(const DisplayProgram& exact, const DisplayProgram& baked,
                            const Inputs& inputs) const {
    // A strip of the picture: some milliseconds, where compiling takes a hundred.
    const int width = std::min(inputs.width, 512), height = std::min(inputs.height, 65536 / width);
    const gl::Texture codes = gl::Texture::target2d(GL_RGBA8, width, height, "display timing");
    const gl::Framebuffer framebuffer({&codes}, nullptr, "display timing");
    const Inputs strip{inputs.radiance, width, height, inputs.transform, {framebuffer.name(), 0, 0}};
    double exactTime = 1e9, bakedTime = 1e9;
    // In turns, so that other work on the machine meets both; the first turn warms up. Such work only ever
    // adds time, so that the least is the truest.
    for (int turn = 0; turn < 6; ++turn) {
        const double exactTurn = secondsOf([&] { draw(exact, strip); }),
                     bakedTurn = secondsOf([&] { draw(baked, strip); });
        if (turn == 0) continue;
        exactTime = std::min(exactTime, exactTurn);
        bakedTime = std::min(bakedTime, bakedTurn);
    }
    return bakedTime < maxShareOfTime * exactTime;
}

void DisplayPass::draw(const DisplayProgram& program, const Inputs& inputs) const {
    program.bind();
    glBindVertexArray(vertexArray_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, inputs.target.framebuffer);
    glViewport(inputs.target.x, inputs.target.y, inputs.width, inputs.height);
    glBindTextureUnit(layout::RADIANCE_UNIT, inputs.radiance.name());
    glUniform1f(layout::EXPOSURE_LOCATION, static_cast<float>(std::exp2(inputs.transform.options().exposure)));
    glUniform2i(layout::ORIGIN_LOCATION, inputs.target.x, inputs.target.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void DisplayPass::render(const Inputs& inputs) {
    draw(prepare(inputs).program, inputs);
}

bool DisplayPass::isBaked(const DisplayTransform& transform) const {
    const Prepared* prepared = find(transform);
    return prepared != nullptr && prepared->isBaked;
}

}  // namespace candela
