#pragma once

#include <string>

#include "query.h"

namespace candela_obj {

/// Reads the file `name` of the scene's folder and pushes it: as polygons, or as cages where the query asks
/// for them or the file has a tag. Throws `Failure`, `HostRefused` or a standard exception.
void importFile(const std::string& name, const Query& query, const Host& host);

}  // namespace candela_obj
