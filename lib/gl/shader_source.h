#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candela::gl {

/// A file of shaders/ as the build put it into the library.
struct EmbeddedShader {
    std::string_view name;  ///< Path below shaders/, such as "lib/lighting.glsl".
    std::string_view text;
};

std::span<const EmbeddedShader> embeddedShaders();

/// The text of a file of shaders/: from the folder that CANDELA_SHADER_DIR names, if set, else from the
/// library. Throws `Error` (environment) when there is no such file.
std::string readShader(const std::string& name);

/// A whole stage: `#version`, then one line per entry of `definitions` ("NAME VALUE"), then the file with
/// each `#include "NAME"` line replaced by that file, once.
std::string assembleShader(const std::string& name, const std::vector<std::string>& definitions = {});

}  // namespace candela::gl
