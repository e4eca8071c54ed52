#pragma once

#include <vector>

#include "cages.h"
#include "document.h"
#include "hierarchy.h"
#include "host.h"

namespace candela_gltf {

/// Tells the host which nodes show a cage, with which skin and which weights of morph targets. `skins` are
/// the host's indices of the file's skins. Throws `Failure` where node, skin and cage do not fit together.
void showCages(const Document& document, const std::vector<DrawnNode>& drawn,
               const std::vector<std::int32_t>& nodes, const PushedCages& cages,
               const std::vector<std::int32_t>& skins, const Host& host);

}  // namespace candela_gltf
