#pragma once

#include <vector>

#include "document.h"
#include "materials.h"
#include "query.h"

namespace candela_obj {

/// Pushes the faces as cages: one with its node for each object. `materials` holds those of the
/// document. Progress goes from `from` to 1.
void pushCages(const Document& document, const Query& query, const std::vector<PushedMaterial>& materials,
               const Host& host, double from);

}  // namespace candela_obj
