#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "channels.h"
#include "failure.h"
#include "texture_info.h"

namespace candela_obj {

/// Reads pictures and pushes them, each once. A file that is neither PNG nor JPEG is noted and left out.
class Images {
  public:
    explicit Images(const Host& host) : host_(host) {}

    // Each returns the host's index, -1 where there is nothing to push. The textures may be NULL.

    std::int32_t whole(const TextureInfo* texture);
    /// RGB of one picture, and as alpha a channel of the other.
    std::int32_t colorAndMask(const TextureInfo* color, const TextureInfo* mask);
    /// Roughness in G and metal in B.
    std::int32_t roughnessAndMetal(const TextureInfo* roughness, const TextureInfo* metal);

  private:
    std::optional<Picture> decode(const TextureInfo* texture);

    const Host& host_;
    std::map<std::string, std::int32_t> pushed_;  // by what it is made of
    std::set<std::string> leftOut_;
};

}  // namespace candela_obj
