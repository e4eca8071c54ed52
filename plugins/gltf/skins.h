#pragma once

#include <vector>

#include "cages.h"
#include "document.h"
#include "hierarchy.h"
#include "host.h"

namespace candela_gltf {

/// Pushes the skins that move cages, and returns the host's index of each skin of the file, -1 for the
/// others. `nodes` are the host's indices of the file's nodes. Throws `Failure` when a joint is not part of
/// the scene that is drawn.
std::vector<std::int32_t> pushSkins(const Document& document, const std::vector<DrawnNode>& drawn,
                                    const std::vector<std::int32_t>& nodes, const PushedCages& cages,
                                    const Host& host);

}  // namespace candela_gltf
