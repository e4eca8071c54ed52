#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "../common/host.h"
#include "statement.h"

namespace candela_plugins::obj {

/// The channel of an image that a single number is read from: "-imfchan".
enum class Channel {
    usual,  ///< Not given.
    red,
    green,
    blue,
    matte,  ///< Alpha.
    luminance,
};

/// A use of an image, from a statement such as "map_Kd -s 2 2 wood.png".
struct TextureInfo {
    std::string element;                                      ///< For messages: "stone.mtl, line 12: map_Kd".
    std::string file;                                         ///< Relative to the scene's folder.
    float offset[2] = {0.0f, 0.0f}, scale[2] = {1.0f, 1.0f};  ///< uv' = offset + scale × uv, v upwards.
    bool clamp = false;
    float multiplier = 1.0f;  ///< "-bm": of a normal map's x and y.
    Channel channel = Channel::usual;

    bool hasSameSampling(const TextureInfo& other) const;
};

/// Reads the rest of the statement. Options that are not used are counted.
TextureInfo parseTextureInfo(Statement& statement, const std::string& materialFile,
                             IgnoredStatements& ignored);

/// A material of an .mtl file.
struct FileMaterial {
    std::string name;
    std::string element;                                    ///< For messages: "stone.mtl, line 3: newmtl".
    std::optional<std::array<float, 3>> diffuse, emission;  ///< Kd, Ke: linear.
    std::optional<float> exponent;                          ///< Ns: of the Blinn-Phong highlight, 0 or more.
    std::optional<float> opacity;                           ///< d, or 1 - Tr.
    std::optional<float> roughness, metallic;               ///< Pr, Pm.
    std::optional<TextureInfo> diffuseMap, emissionMap, opacityMap, roughnessMap, metallicMap, normalMap;
};

/// Appends the materials of the .mtl file `name` of the scene's folder. Unsupported statements become notes.
void parseMaterialFile(const std::string& name, const Host& host, std::vector<FileMaterial>& materials);

}  // namespace candela_plugins::obj
