#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "failure.h"

namespace candela_obj {

/// Counts what of a file is not drawn or not used, for one note a kind.
class IgnoredStatements {
  public:
    /// `what` begins the note: "not drawn", "not used"; `kind` says of what.
    void count(std::string_view what, std::string_view kind, std::size_t line);
    /// `file` is the name of a file other than the scene's own, or empty.
    void note(const Host& host, const std::string& file) const;

  private:
    struct Kind {
        std::string what, name;
        std::size_t count = 0, firstLine = 0;
    };
    std::vector<Kind> kinds_;
    std::size_t others_ = 0;
};

/// Notes that so many corners, of faces that need texture coordinates, have none.
void noteMissingUvs(std::size_t corners, const Host& host);

}  // namespace candela_obj
