#pragma once

#include <string>

#include "ignored_statements.h"
#include "statement.h"

namespace candela_obj {

/// A channel of a picture that a single number is taken from: "-imfchan".
enum class Channel {
    usual,  ///< None is named.
    red,
    green,
    blue,
    matte,  ///< Alpha.
    luminance,
};

/// A texture as a statement such as "map_Kd -s 2 2 wood.png" names it.
struct TextureInfo {
    std::string element;                                      ///< For messages: "stone.mtl, line 12: map_Kd".
    std::string file;                                         ///< Relative to the scene's folder.
    float offset[2] = {0.0f, 0.0f}, scale[2] = {1.0f, 1.0f};  ///< uv' = offset + scale × uv, v upwards.
    bool clamp = false;
    float multiplier = 1.0f;  ///< "-bm": of a normal map's x and y.
    Channel channel = Channel::usual;

    bool samplesLike(const TextureInfo& other) const;
};

/// Reads what follows the keyword. Options without an effect here are counted.
TextureInfo parseTextureInfo(Statement& statement, const std::string& materialFile,
                             IgnoredStatements& ignored);

}  // namespace candela_obj
