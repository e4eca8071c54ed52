#pragma once

#include "document.h"
#include "statement.h"

namespace candela_obj {

/// Appends the corners of a statement "f" to the document; its face is the caller's. Corners have the form v,
/// v/t, v//n or v/t/n; negative indices count back from the last element so far.
void parseCorners(Statement& statement, Document& document);

}  // namespace candela_obj
