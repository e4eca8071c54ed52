#include "gl_program.h"

#include <candela/error.h>

#include <vector>

namespace {

GLuint compileStage(GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* texts[] = {text.c_str()};
    glShaderSource(shader, 1, texts, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    throw candela::Error(candela::ErrorKind::environment, "shader", "this device can not compile it: " + log);
}

/// Deletes the stages.
GLuint linked(const std::vector<GLuint>& stages) {
    const GLuint program = glCreateProgram();
    for (const GLuint stage : stages) glAttachShader(program, stage);
    glLinkProgram(program);
    for (const GLuint stage : stages) glDeleteShader(stage);
    GLint isLinked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (isLinked == GL_TRUE) return program;
    glDeleteProgram(program);
    throw candela::Error(candela::ErrorKind::environment, "shader", "this device can not link it");
}

}  // namespace

GLuint makeProgram(const std::string& vertexText, const std::string& fragmentText) {
    return linked(
        {compileStage(GL_VERTEX_SHADER, vertexText), compileStage(GL_FRAGMENT_SHADER, fragmentText)});
}

GLuint makeComputeProgram(const std::string& text) {
    return linked({compileStage(GL_COMPUTE_SHADER, text)});
}
