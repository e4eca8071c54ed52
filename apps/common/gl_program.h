#pragma once

// Programs of the applications' own drawing, beside what the library draws.

#include <epoxy/gl.h>

#include <string>

/// Compiles and links. Throws `candela::Error` (environment) with the compiler's message.
GLuint makeProgram(const std::string& vertexText, const std::string& fragmentText);

/// The same of a compute stage.
GLuint makeComputeProgram(const std::string& text);
