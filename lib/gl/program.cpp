#include "gl/program.h"

#include "gl/shader_source.h"

#include <candela/error.h>

namespace candela::gl {

void deleteProgram(GLuint name) {
    glDeleteProgram(name);
}

namespace {

void deleteShader(GLuint name) {
    glDeleteShader(name);
}

GLenum stageOf(const std::string& file) {
    if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (file.ends_with(".geom")) return GL_GEOMETRY_SHADER;
    if (file.ends_with(".frag")) return GL_FRAGMENT_SHADER;
    return GL_COMPUTE_SHADER;
}

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    return log;
}

Object<deleteShader> compile(const Stage& stage) {
    Object<deleteShader> shader(glCreateShader(stageOf(stage.file)));
    const std::string text = assembleShader(stage.file, stage.definitions) + stage.appended;
    const char* texts[] = {text.c_str()};
    glShaderSource(shader.name(), 1, texts, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        throw Error(ErrorKind::environment, stage.file,
                    "this device can not compile the shader: " + shaderLog(shader.name()));
    }
    return shader;
}

}  // namespace

Program::Program(const std::vector<Stage>& stages, const char* label) : object_(glCreateProgram()) {
    glObjectLabel(GL_PROGRAM, name(), -1, label);
    for (const Stage& stage : stages) {
        const Object<deleteShader> shader = compile(stage);
        glAttachShader(name(), shader.name());
    }
    glLinkProgram(name());
    GLint linked = GL_FALSE;
    glGetProgramiv(name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        throw Error(ErrorKind::environment, stages.back().file,
                    "this device can not link the program: " + programLog(name()));
    }
}

}  // namespace candela::gl
