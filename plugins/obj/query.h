#pragma once

#include <string>

#include "failure.h"

namespace candela_obj {

/// What the query behind a file's name asks for: "model.obj?subdivide=loop&level=3".
struct Query {
    bool subdivide = false;  ///< Polygons become cages; asked for by "subdivide" and by "level".
    candela_scheme scheme = CANDELA_SCHEME_CATMULL_CLARK;
    std::uint32_t level = 0;  ///< 1 to 8; 0: by the size on the screen.
};

/// Reads "subdivide", "subdivide=catmullClark|loop|bilinear" and "level=N", joined by '&'. `text` may be
/// NULL.
Query parseQuery(const char* text);

}  // namespace candela_obj
