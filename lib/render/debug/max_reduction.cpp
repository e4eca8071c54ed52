#include "render/debug/max_reduction.h"

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

MaxReduction::MaxReduction()
    : program_({{"max_reduction.comp", {}, {}}}, "greatest value"), buffer_("greatest value") {}

void MaxReduction::find(const gl::Texture& picture, int width, int height) {
    constexpr float none = 0.0f;
    buffer_.upload(std::span<const float>(&none, 1));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::MAX_REDUCTION_STORAGE, buffer_.name());
    glBindTextureUnit(layout::SHOWN_UNIT, picture.name());
    glUseProgram(program_.name());
    glDispatchCompute(groups(width), groups(height), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

float MaxReduction::value() const {
    float value = 0.0f;
    glGetNamedBufferSubData(buffer_.name(), 0, sizeof value, &value);
    return value;
}

}  // namespace candela
