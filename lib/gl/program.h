#pragma once

#include "gl/object.h"

#include <string>
#include <vector>

namespace candela::gl {

void deleteProgram(GLuint name);

/// One stage of a program: a file of shaders/, whose ending (.vert, .geom, .frag, .comp) says which stage it
/// is.
struct Stage {
    std::string file;
    std::vector<std::string> definitions;  ///< "NAME VALUE", see `assembleShader`.
    std::string appended;  ///< GLSL that follows the file's text, such as a display transform.
};

/// A linked program. Uniform locations and bindings are fixed in the shaders' text.
class Program {
  public:
    Program() = default;
    /// Compiles and links. Throws `Error` (environment) with the file and the compiler's message.
    Program(const std::vector<Stage>& stages, const char* label);

    GLuint name() const { return object_.name(); }

  private:
    Object<deleteProgram> object_;
};

}  // namespace candela::gl
