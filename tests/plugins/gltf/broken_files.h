#pragma once

#include <string>
#include <vector>

#include "loading.h"

namespace candela_test {

/// A file, and what its error message, or the note, must contain: the element and the reason.
struct Case {
    const char* name;
    std::string text;
    std::vector<std::string> parts;
};

/// The text of a document with these members.
std::string document(const std::string& members);

/// A node with a mesh 'wheel' whose primitive has these members; accessors 0 and 1 are its positions and
/// normals.
GltfFile wheel(const std::string& primitive);

/// The members of the primitive of a triangle.
inline const std::string onlyTriangle = R"("attributes":{"POSITION":0,"NORMAL":1})";

/// The wheel with these indices in accessor 2.
std::string wheelWithIndices(const std::vector<std::uint16_t>& indices, const std::string& more = "");

/// A document whose only mesh has these primitives, which may read accessor 0.
std::string withPrimitives(const std::string& primitives);

/// Each file is refused with an error.
void expectErrors(const std::vector<Case>& cases);

/// Each file is read, with exactly one note, and refused where strictness is asked for.
void expectNotes(const std::vector<Case>& cases);

}  // namespace candela_test
