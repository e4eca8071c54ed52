#pragma once

#include "document.h"
#include "statement.h"

namespace candela_obj {

/// Reads a statement "t name ints/floats/strings ...", which announces how many words of each kind follow.
Tag parseTag(Statement& statement);

}  // namespace candela_obj
