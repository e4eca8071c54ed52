#pragma once

#include <string>
#include <vector>

#include "document.h"

namespace candela_obj {

/// Faces that become one mesh or one cage.
struct Part {
    std::string name;
    std::vector<std::uint32_t> faces;  ///< In the order of the file.
};

enum class SplitAt {
    objects,           ///< 'o': a cage must not fall apart at its groups.
    objectsAndGroups,  ///< 'o' and 'g'.
};

/// The parts of the file in the order in which they begin; faces of the same names are one part, wherever
/// they stand. Its name is that of the object, of the group, or "object/group".
std::vector<Part> splitFaces(const Document& document, SplitAt splitAt);

}  // namespace candela_obj
