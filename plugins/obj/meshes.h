#pragma once

#include <vector>

#include "document.h"
#include "materials.h"

namespace candela_obj {

/// Pushes the faces as polygons: a mesh and a node for each object and each of its groups. `materials` holds
/// those of the document. Progress goes from `from` to 1.
void pushMeshes(Document& document, const std::vector<PushedMaterial>& materials, const Host& host,
                double from);

}  // namespace candela_obj
