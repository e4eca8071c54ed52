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
    std::string element;             ///< For messages: "stone.mtl, line 12: map_Kd".
    std::string owner;               ///< The file that holds the statement, relative to the scene's folder.
    std::vector<std::string> names;  ///< What may be the name of the file, the likeliest first; one or more.
    float offset[2] = {0.0f, 0.0f}, scale[2] = {1.0f, 1.0f};  ///< uv' = offset + scale × uv, v upwards.
    bool clamp = false;
    float multiplier = 1.0f;  ///< "-bm": of a normal map's x and y.
    Channel channel = Channel::usual;

    bool hasSameSampling(const TextureInfo& other) const;
};

/// Reads the rest of the statement, whose options may be before or behind the name of the file. An option
/// without the value that it needs is noted and not used. None where no file is named, which is noted.
std::optional<TextureInfo> parseTextureInfo(const Statement& statement, const std::string& materialFile,
                                            const Host& host, LineNotes& notes);

/// A material of an .mtl file. Numbers are in their ranges.
struct FileMaterial {
    std::string name;
    std::string element;                                    ///< For messages: "stone.mtl, line 3: newmtl".
    std::optional<std::array<float, 3>> diffuse, emission;  ///< Kd, Ke: linear.
    std::optional<float> exponent;                          ///< Ns: of the Blinn-Phong highlight, 0 or more.
    std::optional<float> opacity, transparency;             ///< d, Tr.
    std::optional<float> roughness, metallic;               ///< Pr, Pm.
    bool hasDiffuseMap = false;                             ///< A map_Kd, also where it names no file.
    std::optional<TextureInfo> diffuseMap, emissionMap, opacityMap, roughnessMap, metallicMap, normalMap,
        bumpMap;
};

/// Appends the materials of an .mtl file; `name` is its path relative to the scene's folder. What cannot be
/// read or drawn of it becomes notes.
void parseMaterialFile(const Bytes& file, const std::string& name, const Host& host,
                       std::vector<FileMaterial>& materials);

}  // namespace candela_plugins::obj
