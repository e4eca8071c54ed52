#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "failure.h"
#include "texture_info.h"

namespace candela_obj {

/// A material as an .mtl file has it.
struct FileMaterial {
    std::string name;
    std::string element;                                    ///< For messages: "stone.mtl, line 3: newmtl".
    std::optional<std::array<float, 3>> diffuse, emission;  ///< Kd, Ke: linear.
    std::optional<float> exponent;                          ///< Ns: of the Blinn-Phong highlight, 0 or more.
    std::optional<float> opacity;                           ///< d, or 1 - Tr.
    std::optional<float> roughness, metallic;               ///< Pr, Pm.
    std::optional<TextureInfo> diffuseMap, emissionMap, opacityMap, roughnessMap, metallicMap, normalMap;
};

/// Appends the materials of the .mtl file `name` of the scene's folder. What it says beyond them becomes
/// notes.
void parseMaterialFile(const std::string& name, const Host& host, std::vector<FileMaterial>& materials);

}  // namespace candela_obj
