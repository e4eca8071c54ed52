#include "render/show/greatest.h"

#include "render/layout.h"

#include <cstdint>
#include <span>

namespace candela {

namespace {

constexpr int groupPixels = 16;  // of greatest.comp, along each axis

GLuint groups(int pixels) {
    return static_cast<GLuint>((pixels + groupPixels - 1) / groupPixels);
}

}  // namespace

Greatest::Greatest() : program_({{"greatest.comp", {}, {}}}, "greatest value"), buffer_("greatest value") {}

void Greatest::find(const gl::Texture& picture, int width, int height) {
    constexpr float none = 0.0f;
    buffer_.upload(std::span<const float>(&none, 1));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::GREATEST_STORAGE, buffer_.name());
    glBindTextureUnit(layout::SHOWN_UNIT, picture.name());
    glUseProgram(program_.name());
    glDispatchCompute(groups(width), groups(height), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

float Greatest::value() const {
    float value = 0.0f;
    glGetNamedBufferSubData(buffer_.name(), 0, sizeof value, &value);
    return value;
}

}  // namespace candela
